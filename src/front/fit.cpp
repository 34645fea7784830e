#include "higherpair/front/fit.hpp"

#include "analysis_impl.hpp"
#include "design_setup.hpp"
#include "fit_statistics.hpp"
#include "fit_units.hpp"
#include "higherpair/analysis/branch_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace higherpair {
namespace {

constexpr double kSameMotion = 1e-9;  // of a column's largest value: the new profile moves as was fitted

// The branch on which the profile stands.
Result<int> branch_of_model(const Model& model) {
  RunSettings settings;
  settings.columns = {"status"};
  auto run = model.start(settings);
  if (!run) {
    return tl::unexpected(std::move(run.error()));
  }
  return branch_of(run->impl().run);
}

// Unknowns of which no measured value depends.
Diagnostics idle_variables(const FitProblem& problem, const Eigen::VectorXd& x) {
  constexpr double kNothing = 1e-12;  // of the most that a variable changes, each by its own scale
  Diagnostics mistakes;
  const auto jacobian = problem.jacobian(x);
  if (!jacobian) return mistakes;
  Eigen::MatrixXd J = *jacobian;
  for (std::size_t i = 0; i < problem.values().size(); ++i) {
    J.row(place(i)) /= problem.spread(problem.values()[i].column);
  }
  const std::vector<DesignTask::Variable>& variables = problem.data().variables->variables;
  Eigen::VectorXd effects = J.colwise().norm();
  for (std::size_t i = 0; i < variables.size(); ++i) effects(place(i)) *= problem.motion().scale(i);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (effects(place(i)) > kNothing * effects.maxCoeff()) continue;
    mistakes.push_back(
        {variables[i].place,
         fmt::format("design.variables.{}: changes none of the measured columns: leave it out, or measure "
                     "something that depends on {}",
                     variables[i].name, variables[i].paths.front())});
  }
  return mistakes;
}

// Angles that an instrument counts within a turn, or from another turn.
void unwrap_angles(FitData& data, const FitProblem& problem, const Eigen::VectorXd& x) {
  for (std::size_t c = 0; c < data.columns.size(); ++c) {
    const std::vector<double> values = problem.unwrapped(c, x);
    int moved = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      moved += std::abs(values[k] - data.columns[c].values[k]) > 0 ? 1 : 0;
    }
    if (moved == 0) continue;
    data.columns[c].values = values;
    data.notes.push_back(
        fmt::format("{}: {} of its angles are taken as so many whole turns more or less, near "
                    "the profile's motion",
                    data.columns[c].name, moved));
  }
}

// What a fit has found, as a report.
class FitReporter {
public:
  FitReporter(const FitProblem& problem, const FitSolution& solution)
      : problem_(problem),
        data_(problem.data()),
        solution_(solution),
        statistics_(fit_statistics(problem, solution)) {}

  FitReport report() {
    report_.title = data_.model.mechanism().title;
    report_.in_time = data_.in_time();
    report_.where_unit = data_.where_unit();
    report_.loss = data_.task.loss;
    report_.confidence = data_.task.confidence;
    report_.notes = data_.notes;
    add_numbers();
    add_residuals();
    add_columns();
    report_.undetermined = statistics_.undetermined;
    report_.correlation = statistics_.correlation;
    report_.freedoms = statistics_.freedoms;
    report_.noise_ratio = statistics_.noise_ratio;
    report_.chance = statistics_.chance;
    report_.too_large = statistics_.chance < kUnlikely;
    report_.missing = solution_.missing;
    report_.starts = solution_.starts;
    report_.different = solution_.different;
    report_.iterations = solution_.iterations;
    report_.exact = problem_.motion().is_exact();
    report_.end = solution_.end;
    report_.good = report_.end == FitEnd::kConverged && report_.undetermined.empty() &&
                   report_.missing == 0 && !report_.too_large;
    add_notes();
    return std::move(report_);
  }

private:
  void add_numbers() {
    for (std::size_t i = 0; i < problem_.unknowns().size(); ++i) {
      const FitUnknown& unknown = problem_.unknowns()[i];
      FitReport::Number number;
      number.name = unknown.name;
      number.unit = unknown.unit;
      number.after = solution_.x(place(i));
      number.error = statistics_.errors(place(i));
      number.half = statistics_.quantile * number.error;
      number.at_bound = statistics_.at_bound[i];
      number.determined = statistics_.determined[i];
      if (unknown.kind != FitUnknown::Kind::kVariable) {
        report_.measurement.push_back(std::move(number));
        continue;
      }
      const DesignTask::Variable& variable = data_.variables->variables[unknown.index];
      number.paths = variable.paths;
      number.before = variable.range.start;
      if (std::isfinite(variable.range.low)) number.low = variable.range.low;
      if (std::isfinite(variable.range.high)) number.high = variable.range.high;
      report_.variables.push_back(std::move(number));
    }
  }

  void add_residuals() {
    for (std::size_t i = 0; i < problem_.values().size(); ++i) {
      const auto [row, column] = problem_.values()[i];
      FitReport::Residual residual;
      residual.line = data_.lines[row];
      residual.where = data_.where[0][row];
      residual.column = column;
      residual.measured = data_.columns[column].values[row];
      residual.fitted = residual.measured - solution_.residuals(place(i));
      residual.weight = solution_.weights(place(i));
      const double noise = robust_noise(column);
      residual.outlier =
          !solution_.constant[column] && std::abs(solution_.residuals(place(i))) > kOutlier * noise;
      report_.residuals.push_back(residual);
    }
  }

  // As a few wrong values do not make it larger.
  double robust_noise(std::size_t column) {
    if (robust_.empty()) {
      for (std::size_t c = 0; c < data_.columns.size(); ++c) {
        std::vector<double> sizes;
        for (std::size_t i = 0; i < problem_.values().size(); ++i) {
          if (problem_.values()[i].column == c) sizes.push_back(std::abs(solution_.residuals(place(i))));
        }
        std::nth_element(sizes.begin(), sizes.begin() + std::ssize(sizes) / 2, sizes.end());
        robust_.push_back(std::max(1.4826 * sizes[sizes.size() / 2], 1e-12 * problem_.largest(c)));
      }
    }
    return data_.columns[column].deviation.value_or(robust_[column]);
  }

  void add_columns() {
    for (std::size_t c = 0; c < data_.columns.size(); ++c) {
      FitReport::Column column;
      column.name = data_.columns[c].name;
      column.unit = data_.columns[c].unit;
      column.deviation = data_.columns[c].deviation;
      if (statistics_.freedoms > 0) column.noise = solution_.deviations[c];
      std::vector<std::pair<double, double>> by_place;
      double square = 0, mean = 0;
      for (const FitReport::Residual& residual : report_.residuals) {
        if (residual.column != c) continue;
        const double off = residual.measured - residual.fitted;
        by_place.emplace_back(residual.where, off);
        square += off * off;
        mean += residual.measured;
        column.outliers += residual.outlier ? 1 : 0;
        if (!(std::abs(off) <= std::abs(column.largest))) {
          column.largest = off;
          column.largest_at = residual.where;
        }
      }
      column.values = static_cast<int>(by_place.size());
      mean /= column.values;
      column.rms = std::sqrt(square / column.values);
      double spread = 0;
      for (const FitReport::Residual& residual : report_.residuals) {
        if (residual.column == c) spread += std::pow(residual.measured - mean, 2);
      }
      if (spread > 0) column.explained = 1 - square / spread;
      std::stable_sort(by_place.begin(), by_place.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      std::vector<double> residuals;
      for (const auto& [where, off] : by_place) residuals.push_back(off);
      // What rounding leaves of exact values has a pattern of its own.
      const Succession succession = succession_of(residuals);
      const bool noisy = column.rms > 1e-9 * problem_.largest(c);
      column.succession = succession.correlation;
      column.systematic = noisy && succession.systematic;
      report_.columns.push_back(column);
    }
  }

  void add_notes() {
    for (std::size_t c = 0; c < report_.columns.size(); ++c) {
      const FitReport::Column& column = report_.columns[c];
      if (solution_.constant[c]) {
        report_.notes.push_back(
            fmt::format("{} is the same whatever the numbers that are looked for: it has no part in the fit",
                        column.name));
      } else if (column.systematic) {
        report_.notes.push_back(
            fmt::format("residuals of {} follow one another (autocorrelation {:.2f}): the model misses "
                        "something, or noise "
                        "that is slow; intervals are too small",
                        column.name, column.succession));
      }
      if (column.outliers > 0 && report_.loss == FitLoss::kSquares) {
        report_.notes.push_back(
            fmt::format("{}: {} of {} values are more than {} deviations off: outliers, which loss = "
                        "\"huber\" or \"tukey\" "
                        "would give less weight",
                        column.name, column.outliers, column.values, kOutlier));
      }
    }
    if (statistics_.freedoms < 1) {
      report_.notes.push_back(
          fmt::format("as many values as numbers: nothing is left to estimate noise and intervals from"));
    }
    add_correlation_note();
  }

  void add_correlation_note() {
    constexpr double kClose = 0.99;
    for (Eigen::Index i = 0; i < problem_.size(); ++i) {
      for (Eigen::Index k = i + 1; k < problem_.size(); ++k) {
        const double correlation = report_.correlation(i, k);
        if (!(std::abs(correlation) > kClose)) continue;
        report_.notes.push_back(
            fmt::format("{} and {} are hard to tell apart (correlation {:.4f}): their intervals are large, "
                        "what they have in "
                        "common is known better",
                        problem_.unknowns()[static_cast<std::size_t>(i)].name,
                        problem_.unknowns()[static_cast<std::size_t>(k)].name, correlation));
      }
    }
  }

  const FitProblem& problem_;
  const FitData& data_;
  const FitSolution& solution_;
  FitStatistics statistics_;
  std::vector<double> robust_;
  FitReport report_;
};

// The new text, which is read again and run through the rows.
Result<std::string> verified_text(const FitProblem& problem, const FitSolution& solution, FitReport& report) {
  const FitData& data = problem.data();
  const auto schedule = first_schedule(data.model.data());
  if (!schedule) {
    return tl::unexpected(schedule.error());
  }
  RunSettings settings;
  settings.columns = {"status"};
  const DesignSetup setup{
      problem.motion().numbers(),  {}, {}, settings, *schedule, 1, problem.motion().branch(),
      data.model.data().plan->size};
  const std::vector<double> x(solution.x.data(), solution.x.data() + data.variables->variables.size());
  auto text = text_of_design(setup, x, problem.motion().branch());
  if (!text) {
    return text;
  }
  const Model::Data& before = data.model.data();
  auto model = Model::from_text(*text, before.name, before.document->overrides());
  if (!model) {
    return tl::unexpected(std::move(model.error()));
  }
  FitData again = data;
  again.model = *model;
  again.variables = model->profile().design;
  const auto branch = branch_of_model(*model);
  bool same = branch.has_value();
  if (same) {
    const FitMotion motion(again, *branch);
    const FitProblem reread(again, motion);
    const auto residuals = reread.residuals(solution.x);
    same = residuals.has_value();
    for (std::size_t i = 0; same && i < problem.values().size(); ++i) {
      same = std::abs((*residuals)(place(i)) - solution.residuals(place(i))) <=
             kSameMotion * problem.largest(problem.values()[i].column);
    }
  }
  if (!same) {
    report.good = false;
    report.notes.push_back(
        fmt::format("the profile that was written, read again, does not move as was fitted"));
  }
  return text;
}

}  // namespace

Result<FitReport> fit(const Model& model, const MeasuredTable& measured, const FitSettings& settings) {
  auto data = fit_data(model, measured, settings);
  if (!data) {
    return tl::unexpected(data.error());
  }
  const auto branch = branch_of_model(model);
  if (!branch) {
    return tl::unexpected(branch.error());
  }
  FitMotion motion(*data, *branch);
  {
    const FitProblem as_measured(*data, motion);
    unwrap_angles(*data, as_measured, as_measured.start());
  }
  const FitProblem problem(*data, motion);
  if (Diagnostics suspicions = unit_suspicions(problem); !suspicions.empty()) {
    return tl::unexpected(Error{ErrorKind::kInput, std::move(suspicions)});
  }
  const Eigen::VectorXd start = problem.start();
  std::vector<double> variables(start.data(), start.data() + data->variables->variables.size());
  motion.choose_derivatives(variables, std::vector<double>(data->where.size(), 0.0));
  if (Diagnostics mistakes = idle_variables(problem, start); !mistakes.empty()) {
    return tl::unexpected(Error{ErrorKind::kInput, std::move(mistakes)});
  }
  const FitSolution solution = solve_fit(problem, settings);
  if (!solution.started) {
    return tl::unexpected(error_about(model.data(), ErrorKind::kMechanism,
                                      "the mechanism cannot be run through the rows of the table"));
  }
  FitReport report = FitReporter(problem, solution).report();
  return verified_text(problem, solution, report).map([&](std::string text) {
    report.text = std::move(text);
    return std::move(report);
  });
}

}  // namespace higherpair
