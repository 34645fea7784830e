#include "higherpair/front/design.hpp"

#include "analysis_impl.hpp"
#include "design_setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace higherpair {
namespace {

constexpr int kStarts = 200;
constexpr std::int64_t kEvaluations = 2'000'000;
constexpr double kAtBound = 1e-6;  // of the range
constexpr double kHolds = 1e-9;    // of a limit: what rounding may take from it

DesignOptions options_of(const DesignTask& task, const DesignSettings& settings) {
  DesignOptions options;
  options.method = task.method;
  options.seed = settings.seed.value_or(task.seed.value_or(1));
  options.starts = settings.starts.value_or(task.starts.value_or(kStarts));
  options.evaluations = settings.evaluations.value_or(kEvaluations);
  options.seconds = settings.seconds;
  options.target = task.target;
  options.threads = settings.threads;
  options.stop = settings.stop;
  options.progress = settings.progress;
  return options;
}

std::string_view method_text(DesignMethod method, bool has_cost) {
  switch (method) {
    case DesignMethod::kCobyla:
      return "COBYLA";
    case DesignMethod::kBobyqa:
      return "BOBYQA";
    case DesignMethod::kIsres:
      return "ISRES";
    case DesignMethod::kAuto:
    case DesignMethod::kLeastSquares:
      if (!has_cost) return "least squares (Levenberg-Marquardt), SLSQP at constraints";
      [[fallthrough]];
    default:
      return "SLSQP";
  }
}

// 0.3, not 0.30000000000000004, for three steps of 0.1.
double decimal(double x) {
  return std::stod(fmt::format("{:.12g}", x));
}

std::string text_of(const Measure& measure) {
  return measure.of == MeasureKind::kAt ? fmt::format("{} at {}", measure.column, measure.at)
                                        : fmt::format("{} of {}", name_of(measure.of), measure.column);
}

double total(const DesignTask& task, const std::vector<double>& objectives) {
  double sum = 0;
  for (std::size_t k = 0; k < objectives.size(); ++k) {
    const DesignTask::Objective& objective = task.objectives[k];
    const double off = objectives[k] - objective.target.value_or(0);
    sum += objective.weight * (objective.target ? off * off : off);
  }
  return sum;
}

// Units of the measures, in their order.
std::vector<std::string> units_of(const DesignSetup& setup) {
  std::vector<std::string> units;
  const auto analysis = setup.numbers.model().start(setup.settings);
  for (const Measure& measure : setup.measures) {
    std::string unit;
    if (analysis) {
      for (const Column& column : analysis->columns())
        unit = column.name == measure.column ? column.unit : unit;
    }
    units.push_back(unit);
  }
  return units;
}

class Reporter {
public:
  Reporter(const DesignSetup& setup, const DesignOutcome& outcome)
      : setup_(setup), task_(setup.numbers.task()), outcome_(outcome) {}

  Result<DesignReport> report() {
    std::vector<double> x = outcome_.best.x;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (task_.variables[i].range.step > 0) x[i] = decimal(x[i]);
    }
    const int branch = task_.keep_branch ? setup_.start_branch.value_or(0) : outcome_.best.branch;
    auto text = text_of_design(setup_, x, branch);
    if (!text) {
      return tl::unexpected(std::move(text.error()));
    }
    DesignReport report;
    report.text = *std::move(text);
    const auto after = score_of_text(report.text, x);
    if (!after) {
      return tl::unexpected(std::move(after.error()));
    }
    add_variables(x, report);
    add_objectives(*after, report);
    add_constraints(*after, report);
    add_search(report);
    return report;
  }

private:
  // By the ordinary way: the text is read, and started from its poses.
  Result<DesignScore> score_of_text(const std::string& text, std::span<const double> x) {
    const Model::Data& before = setup_.numbers.model().data();
    const auto model = Model::from_text(text, before.name, before.document->overrides());
    if (!model) {
      return tl::unexpected(model.error());
    }
    DesignSetup read{DesignNumbers(*model, *model->profile().design),
                     setup_.measures,
                     setup_.settings,
                     setup_.schedule,
                     setup_.branches,
                     {},
                     setup_.size};
    const auto start = model->start(setup_.settings);
    if (!start) {
      DesignScore nothing;
      nothing.missing = 1;
      nothing.objectives.assign(task_.objectives.size(), std::numeric_limits<double>::quiet_NaN());
      nothing.constraints.assign(task_.constraints.size(), std::numeric_limits<double>::quiet_NaN());
      return nothing;
    }
    return score_of(read, x, branch_of(start->impl().run));
  }

  void add_variables(const std::vector<double>& x, DesignReport& report) const {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const DesignTask::Variable& variable = task_.variables[i];
      const double near = kAtBound * (variable.range.high - variable.range.low);
      report.variables.push_back({variable.name, variable.paths, variable.range.start, x[i],
                                  variable.range.low, variable.range.high, variable.range.step,
                                  x[i] - variable.range.low <= near || variable.range.high - x[i] <= near});
    }
  }

  void add_objectives(const DesignScore& after, DesignReport& report) const {
    const std::vector<std::string> units = units_of(setup_);
    const DesignScore before = score_before();
    const std::string length =
        unit_text(dimension::kLength * dimension::kLength, setup_.numbers.model().units());
    std::size_t measure = 0;
    for (std::size_t k = 0; k < task_.objectives.size(); ++k) {
      const DesignTask::Objective& objective = task_.objectives[k];
      DesignReport::Objective& line = report.objectives.emplace_back();
      line.what = objective.path               ? "path of " + objective.path->point
                  : objective.followed.empty() ? text_of(*objective.measure)
                                               : objective.followed.front().column + " followed";
      line.unit = objective.path ? length : units[measure];
      if (!objective.followed.empty()) line.unit = fmt::format("({})^2", line.unit);
      measure += objective.path ? 0 : std::max<std::size_t>(1, objective.followed.size());
      line.target = objective.target;
      line.before = before.objectives[k];
      line.after = after.objectives[k];
    }
    report.before = total(task_, before.objectives);
    report.after = total(task_, after.objectives);
    report.starts_good = before.started && before.missing == 0;
    report.path_good = after.started && after.missing == 0;
  }

  [[nodiscard]] DesignScore score_before() const {
    std::vector<double> x;
    for (const DesignTask::Variable& variable : task_.variables) x.push_back(variable.range.start);
    DesignScore score = score_of(setup_, x, setup_.start_branch.value_or(0));
    if (!setup_.start_branch) {
      score.started = false;
      std::fill(score.objectives.begin(), score.objectives.end(), std::numeric_limits<double>::quiet_NaN());
      std::fill(score.constraints.begin(), score.constraints.end(), std::numeric_limits<double>::quiet_NaN());
    }
    return score;
  }

  void add_constraints(const DesignScore& after, DesignReport& report) const {
    const std::vector<std::string> units = units_of(setup_);
    const DesignScore before = score_before();
    const std::vector<LimitPlaces> places = limit_places(setup_);
    report.holds = report.path_good;
    auto measure = static_cast<std::size_t>(
        std::count_if(task_.objectives.begin(), task_.objectives.end(),
                      [](const auto& objective) { return objective.measure.has_value(); }));
    for (std::size_t k = 0; k < task_.constraints.size(); ++k) {
      const DesignTask::Constraint& constraint = task_.constraints[k];
      const std::string what = constraint.transmission ? "transmission at " + constraint.transmission->pin
                                                       : text_of(*constraint.measure);
      const std::string unit = constraint.transmission ? "deg" : units[measure++];
      const auto add = [&](std::string_view side, double limit, double sign,
                           std::optional<Eigen::Index> place) {
        DesignReport::Constraint line;
        line.what = fmt::format("{} {} {}", what, side, limit);
        line.unit = unit;
        line.limit = limit;
        line.before = before.constraints[k];
        line.after = after.constraints[k];
        line.margin = sign * (limit - line.after);
        line.cost = cost_of(constraint, limit, place);
        if (std::abs(line.margin) <= kHolds * std::max(1.0, scale_of(constraint))) line.margin = 0;
        report.holds = report.holds && line.margin >= 0;
        report.constraints.push_back(std::move(line));
      };
      if (constraint.above) add("above", *constraint.above, -1, places[k].above);
      if (constraint.below) add("below", *constraint.below, 1, places[k].below);
    }
  }

  // Multipliers are of what the optimiser was given: limits by their scale, angles by their sines.
  [[nodiscard]] double cost_of(const DesignTask::Constraint& constraint, double limit,
                               std::optional<Eigen::Index> place) const {
    const auto k = static_cast<std::size_t>(place.value_or(0));
    if (!place || k >= outcome_.multipliers.size()) return 0;
    const double by_unit =
        constraint.transmission ? std::cos(limit * kPi / 180) * kPi / 180 : 1 / scale_of(constraint);
    return outcome_.multipliers[k] * by_unit;
  }

  void add_search(DesignReport& report) const {
    report.title = setup_.numbers.model().mechanism().title;
    report.starts = outcome_.starts;
    report.evaluations = outcome_.evaluations;
    report.end = outcome_.end;
    report.different = outcome_.different;
    for (const DesignPoint& point : outcome_.optima) {
      report.optima.push_back({point.x, point.objective, point.violation <= kConstraintTolerance});
    }
  }

  const DesignSetup& setup_;
  const DesignTask& task_;
  const DesignOutcome& outcome_;
};

}  // namespace

Result<DesignReport> design(const Model& model, const DesignSettings& settings) {
  if (!model.data().document) {
    return tl::unexpected(error_about(model.data(), ErrorKind::kInput,
                                      "was built and has no profile that a design could be written into"));
  }
  const auto setup = design_setup(model);
  if (!setup) {
    return tl::unexpected(setup.error());
  }
  const DesignTask& task = (*setup)->numbers.task();
  const DesignProblem problem = problem_of(*setup);
  const DesignOutcome outcome = optimise(problem, options_of(task, settings));
  if (outcome.best.x.empty()) {
    return tl::unexpected(
        error_about(model.data(), ErrorKind::kMechanism,
                    "no candidate within the bounds could be worked out; change the bounds"));
  }
  return Reporter(**setup, outcome).report().map([&](DesignReport report) {
    report.method = method_text(task.method, problem.has_cost);
    return report;
  });
}

}  // namespace higherpair
