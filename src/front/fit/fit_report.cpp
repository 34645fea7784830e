#include "fit_report.hpp"

#include "fit_statistics.hpp"
#include "front/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

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
    report_.where_unit = data_.where[0].unit;
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
    report_.too_large = statistics_.chance < kLeastFitChance;
    report_.missing = solution_.missing;
    report_.starts = solution_.starts;
    report_.different = solution_.different;
    report_.iterations = solution_.iterations;
    report_.exact = problem_.motion().is_exact();
    report_.end = solution_.end;
    report_.good = report_.end == FitEnd::kConverged && report_.undetermined.empty() &&
                   report_.missing == 0 && !report_.too_large &&
                   std::none_of(report_.columns.begin(), report_.columns.end(),
                                [](const FitReport::Column& column) { return column.unexplained; });
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
      number.after = solution_.x(eigen_index(i));
      number.error = statistics_.errors(eigen_index(i));
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
      residual.where = data_.where[0].values[row];
      residual.column = column;
      residual.measured = data_.columns[column].values[row];
      residual.fitted = residual.measured - solution_.residuals(eigen_index(i));
      residual.weight = solution_.weights(eigen_index(i));
      const double noise = noise_of(column);
      residual.outlier = !solution_.constant[column] &&
                         std::abs(solution_.residuals(eigen_index(i))) > kOutlierDeviations * noise;
      report_.residuals.push_back(residual);
    }
  }

  // The noise relative to which a residual is an outlier.
  double noise_of(std::size_t column) {
    for (std::size_t c = robust_.size(); c < data_.columns.size(); ++c) {
      robust_.push_back(
          std::max(robust_noise(problem_, solution_.residuals, c), kNoSpread * problem_.largest(c)));
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
      column.unexplained = column.explained < kUnexplained && !solution_.constant[c];
      std::stable_sort(by_place.begin(), by_place.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      std::vector<double> residuals;
      for (const auto& [where, off] : by_place) residuals.push_back(off);
      // Rounding errors of exact values have a pattern of their own: it does not count.
      const Succession succession = succession_of(residuals);
      const bool noisy = column.rms > kNoisyColumn * problem_.largest(c);
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
                        "something, or noise that is slow; intervals are too small",
                        column.name, column.succession));
      }
      if (column.outliers > 0 && report_.loss == FitLoss::kSquares) {
        report_.notes.push_back(
            fmt::format("{}: {} of {} values are more than {} deviations off: outliers, which "
                        "loss = \"huber\" or \"tukey\" would give less weight",
                        column.name, column.outliers, column.values, kOutlierDeviations));
      }
    }
    if (statistics_.freedoms < 1) {
      report_.notes.push_back(
          "as many values as numbers: nothing is left to estimate noise and intervals from");
    }
    add_correlation_note();
  }

  void add_correlation_note() {
    for (Eigen::Index i = 0; i < problem_.size(); ++i) {
      for (Eigen::Index k = i + 1; k < problem_.size(); ++k) {
        const double correlation = report_.correlation(i, k);
        if (!(std::abs(correlation) > kCloseCorrelation)) continue;
        report_.notes.push_back(
            fmt::format("{} and {} are hard to tell apart (correlation {:.4f}): their intervals are large, "
                        "what they have in common is known better",
                        problem_.unknowns()[i].name, problem_.unknowns()[k].name, correlation));
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

}  // namespace

FitReport fit_report(const FitProblem& problem, const FitSolution& solution) {
  return FitReporter(problem, solution).report();
}

}  // namespace higherpair
