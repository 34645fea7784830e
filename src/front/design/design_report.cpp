// The result of a search, evaluated again from the profile that is written.
#include "design_report.hpp"

#include "design_setup.hpp"
#include "front/analysis_impl.hpp"
#include "front/tolerances.hpp"
#include "higherpair/numeric/overload.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/decimal.hpp"
#include "numeric/joined_words.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr int kDigitsOfSteps = 12;  // 0.3, not 0.30000000000000004, for three steps of 0.1

// \param of  of an objective or a constraint
template <class Of>
std::string words_of(const Of& of) {
  return std::visit(
      Overload{[](const DesignTask::PointPath& path) { return "path of " + path.point; },
               [](const DesignTask::Followed& followed) { return followed.measure.column + " followed"; },
               [](const Measure& measure) {
                 return measure.of == MeasureKind::kAt
                            ? fmt::format("{} at {}", measure.column, measure.at)
                            : fmt::format("{} of {}", name_of(measure.of), measure.column);
               },
               [](const DesignTask::Figure& figure) {
                 return figure.item + "." + figure.quantity + (figure.of.empty() ? "" : " of " + figure.of);
               },
               [](const DesignTask::Extent& extent) { return extent.words; },
               [](const DesignTask::Transmission& one) { return "transmission at " + one.pin; },
               [](const DesignTask::Grashof& grashof) { return "room as a " + grashof.wanted; },
               [](const DesignTask::Events& events) {
                 std::vector<std::string> names;
                 for (const EventType type : events.types) names.emplace_back(name_of(type));
                 return "events " + joined_words(names);
               }},
      of);
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

class Reporter {
public:
  Reporter(const DesignSetup& setup, const DesignOutcome& outcome)
      : setup_(setup),
        task_(setup.numbers.task()),
        outcome_(outcome),
        before_(setup.start_branch ? setup.start_score : nothing()) {}

  Result<DesignReport> report() {
    const std::vector<double> x = as_made(outcome_.best.x);
    auto text = text_of(x, outcome_.best.branch);
    if (!text) {
      return tl::unexpected(std::move(text.error()));
    }
    DesignReport report;
    report.text = *std::move(text);
    auto after = reread(report.text, x, outcome_.best.branch);
    if (!after) {
      return tl::unexpected(std::move(after.error()));
    }
    report.as_found = after->as_found;
    add_variables(x, report);
    add_objectives(after->score, report);
    add_constraints(after->score, report);
    add_search(report);
    return report;
  }

private:
  // The values as written: multiples of steps are rounded to decimals.
  [[nodiscard]] std::vector<double> as_made(std::vector<double> x) const {
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (task_.variables[i].range.step > 0) x[i] = rounded_to(x[i], kDigitsOfSteps);
    }
    return x;
  }

  [[nodiscard]] int searched(int branch) const {
    return task_.keep_branch ? setup_.start_branch.value_or(0) : branch;
  }

  [[nodiscard]] Result<std::string> text_of(std::span<const double> x, int branch) const {
    return text_of_design(setup_.numbers, setup_.settings, x, searched(branch));
  }

  struct Reread {
    DesignScore score;
    bool as_found = false;  // whether it is the design, in the same assembly
  };

  // Evaluates the text as any profile: it is read, and started from its poses.
  [[nodiscard]] Result<Reread> reread(const std::string& text, std::span<const double> x, int branch) const {
    const Model::Data& before = setup_.numbers.model().data();
    const auto model = Model::from_text(text, before.profile.source);
    if (!model) {
      return tl::unexpected(model.error());
    }
    DesignSetup read = setup_;
    read.numbers = DesignNumbers(*model, *model->profile().design);
    const DesignScore found = score_of(setup_, x, searched(branch));
    const auto start = model->start(setup_.settings);
    if (!start) {
      return Reread{nothing(), !found.started};
    }
    Reread after{score_of(read, x, branch_of(start->impl().run))};
    after.as_found = starts_as_designed(setup_.numbers, setup_.settings, x, searched(branch), *model) &&
                     same(found, after.score);
    return after;
  }

  // The score of a mechanism that cannot be assembled.
  [[nodiscard]] DesignScore nothing() const {
    DesignScore score;
    score.missing = 1;
    score.objectives.assign(task_.objectives.size(), kNoValue);
    score.placements.resize(task_.objectives.size());
    score.constraints.assign(task_.constraints.size(), kNoValue);
    return score;
  }

  [[nodiscard]] bool same(const DesignScore& a, const DesignScore& b) const {
    const auto same_value = [&](double one, double other) {
      const double scale = std::max({std::abs(one), std::abs(other), setup_.cost_scale});
      return std::isfinite(one) ? std::abs(one - other) <= kSameScore * scale : !std::isfinite(other);
    };
    return a.started == b.started && (a.missing > 0) == (b.missing > 0) &&
           std::equal(a.objectives.begin(), a.objectives.end(), b.objectives.begin(), same_value);
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
    const std::string length =
        unit_text(dimension::kLength * dimension::kLength, setup_.numbers.model().units());
    for (std::size_t k = 0; k < task_.objectives.size(); ++k) {
      const DesignTask::Objective& objective = task_.objectives[k];
      DesignReport::Objective& line = report.objectives.emplace_back();
      line.what = words_of(objective.of);
      line.unit = objective.path() ? length : setup_.quantities[setup_.objective_places[k].quantity].unit;
      if (objective.followed()) line.unit = fmt::format("({})^2", line.unit);
      line.target = objective.target;
      line.before = before_.objectives[k];
      line.after = after.objectives[k];
      if (after.placements[k]) add_placement(*after.placements[k], line);
    }
    report.before = total(task_, before_.objectives);
    report.after = total(task_, after.objectives);
    report.starts_good = before_.started && before_.missing == 0;
    report.path_good = after.started && after.missing == 0;
  }

  void add_placement(const std::pair<PathPlacement::Complex, PathPlacement::Complex>& placed,
                     DesignReport::Objective& line) const {
    const Units& units = setup_.numbers.model().units();
    const Scaling length = from_si(dimension::kLength, units);
    const auto& [z, shift] = placed;
    line.placement = {from_si(dimension::kAngle, units).apply(std::arg(z)), std::abs(z),
                      length.apply(shift.real()), length.apply(shift.imag())};
    line.length_unit = unit_text(dimension::kLength, units);
    line.angle_unit = unit_text(dimension::kAngle, units);
  }

  void add_constraints(const DesignScore& after, DesignReport& report) const {
    report.holds = report.path_good && report.as_found;
    for (std::size_t k = 0; k < task_.constraints.size(); ++k) {
      const DesignTask::Constraint& constraint = task_.constraints[k];
      const ConstraintPlace& place = setup_.constraint_places[k];
      const std::string what = words_of(constraint.of);
      const std::string unit = constraint.transmission()
                                   ? unit_text(dimension::kAngle, setup_.numbers.model().units())
                                   : setup_.quantities[place.quantity].unit;
      const auto add = [&](std::string_view side, double limit, double sign, Eigen::Index at) {
        DesignReport::Constraint line;
        line.what = fmt::format("{} {} {}", what, side, limit);
        line.unit = unit;
        line.limit = limit;
        line.before = before_.constraints[k];
        line.after = after.constraints[k];
        line.margin = sign * (limit - line.after);
        line.cost = cost_of(k, limit, static_cast<std::size_t>(at));
        if (task_.objectives.size() == 1) line.cost /= task_.objectives.front().weight;
        line.cost_unit = unit_per(unit_of_all(report), unit);
        if (std::abs(line.margin) <= setup_.slack(k)) line.margin = 0;
        report.holds = report.holds && line.margin >= 0;
        report.constraints.push_back(std::move(line));
      };
      if (place.above) add("above", *constraint.above, -1, *place.above);
      if (place.below) add("below", *constraint.below, 1, *place.below);
    }
  }

  // Unit of the whole objective; several objectives have no unit in common.
  [[nodiscard]] static std::string unit_of_all(const DesignReport& report) {
    if (report.objectives.size() != 1) return "1";
    const DesignReport::Objective& objective = report.objectives.front();
    return objective.target ? fmt::format("({})^2", objective.unit) : objective.unit;
  }

  // Multipliers refer to the constraints as the optimiser has them: limits divided by their scale, sines of
  // angles.
  [[nodiscard]] double cost_of(std::size_t constraint, double limit, std::size_t place) const {
    if (place >= outcome_.multipliers.size()) return 0;
    const Scaling angle = to_si(dimension::kAngle, setup_.numbers.model().units());
    const double by_unit = task_.constraints[constraint].transmission()
                               ? std::cos(angle.apply(limit)) * angle.apply(1)
                               : 1 / setup_.scales[constraint];
    return outcome_.multipliers[place] * by_unit;
  }

  void add_search(DesignReport& report) const {
    report.title = setup_.numbers.model().mechanism().title;
    report.starts = outcome_.starts;
    report.evaluations = outcome_.evaluations;
    report.end = outcome_.end;
    report.different = outcome_.different;
    for (std::size_t k = 0; k < outcome_.optima.size(); ++k) {
      const bool is_made = k < outcome_.made.size();
      const DesignPoint& point = is_made ? outcome_.made[k] : outcome_.optima[k];
      DesignReport::Alternative& line = report.optima.emplace_back();
      line.variables = is_made ? as_made(point.x) : point.x;
      line.objective = point.objective;
      line.holds = point.violation <= kConstraintTolerance;
      if (k == 0 && is_made) {
        line.text = report.text;
        line.as_found = report.as_found;
      } else if (is_made) {
        line.text = text_of(line.variables, point.branch).value_or(std::string());
        if (line.text.empty()) continue;
        const auto again = reread(line.text, line.variables, point.branch);
        line.as_found = again && again->as_found;
      }
    }
  }

  const DesignSetup& setup_;
  const DesignTask& task_;
  const DesignOutcome& outcome_;
  const DesignScore before_;
};

}  // namespace

Result<DesignReport> design_report(const DesignSetup& setup, const DesignOutcome& outcome) {
  return Reporter(setup, outcome).report();
}

}  // namespace higherpair
