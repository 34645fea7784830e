#include "fit_units.hpp"

#include "front/other_units.hpp"
#include "front/tolerances.hpp"
#include "numeric/eigen_index.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

namespace higherpair {
namespace {

// RMS of `measured` · factor - `fitted`, divided by the RMS of `fitted`; for a column whose zero is unknown,
// both without their means.
double misfit(const std::vector<double>& measured, const Eigen::VectorXd& fitted, double factor,
              bool free_zero) {
  double mean_off = 0, mean = 0, count = 0;
  const auto each = [&](auto use) {
    for (std::size_t k = 0; k < measured.size(); ++k) {
      const double own = fitted(eigen_index(k));
      if (std::isfinite(measured[k]) && std::isfinite(own)) use(factor * measured[k] - own, own);
    }
  };
  each([&](double off, double own) {
    mean_off += off;
    mean += own;
    count += 1;
  });
  const double from_off = free_zero ? mean_off / count : 0, from = free_zero ? mean / count : 0;
  double square_off = 0, square = 0;
  each([&](double off, double own) {
    square_off += std::pow(off - from_off, 2);
    square += std::pow(own - from, 2);
  });
  return square > 0 ? std::sqrt(square_off / square) : 0;
}

std::string advice(const std::string& name, const std::string& own, const OtherUnit& other) {
  const double times = 1 / other.factor;
  return fmt::format(
      "{}: these values are far from the motion of the profile in {}, but near it if they are in {} "
      "(a factor of {:.6g}); write {}[{}] in the header, or {}[{}] if they are right as they are",
      name, own, other.unit, times > 1 ? times : other.factor, name, other.unit, name, own);
}

// Whether the unit of a column is only presumed; that of a point in a frame of its own has no part in it.
bool is_presumed(const FitData& data, std::size_t c) {
  return !data.columns[c].unit_given &&
         std::none_of(data.frames.begin(), data.frames.end(),
                      [&](const FitFrame& frame) { return frame.x == c || frame.y == c; });
}

// The columns whose unit is presumed to be this driver's.
std::vector<std::size_t> with_the_driver(const FitData& data, const FitWhere& driver) {
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < data.columns.size(); ++c) {
    if (is_presumed(data, c) && data.columns[c].unit == driver.unit) columns.push_back(c);
  }
  return columns;
}

// The mean misfit of all columns; none where the motion cannot be run.
std::optional<double> whole_misfit(const FitProblem& problem, const std::vector<double>& variables,
                                   const FitData& data) {
  const FitMotion motion(data, problem.motion().branch());
  const auto table = motion.table(variables, std::vector<double>(data.where.size(), 0.0));
  if (!table) return std::nullopt;
  double sum = 0;
  for (std::size_t c = 0; c < data.columns.size(); ++c) {
    sum += std::min(2.0, misfit(data.columns[c].values, table->col(eigen_index(c)), 1, true));
  }
  return sum / static_cast<double>(data.columns.size());
}

// Columns that would fit in another unit.
Diagnostics column_suspicions(const FitData& data, const FitTable& table) {
  Diagnostics suspicions;
  for (std::size_t c = 0; c < data.columns.size(); ++c) {
    const FitColumn& column = data.columns[c];
    const Eigen::VectorXd fitted = table.col(eigen_index(c));
    const double as_it_is = misfit(column.values, fitted, 1, column.offset);
    if (!is_presumed(data, c) || !(as_it_is > kFarMisfit)) continue;
    const auto best = best_unit(
        column.unit, data.model.units(), std::min(kNearMisfit, kBetterMisfit * as_it_is),
        [&](const OtherUnit& other) { return misfit(column.values, fitted, other.factor, column.offset); });
    if (best) suspicions.push_back({column.place, advice(column.name, column.unit, *best)});
  }
  return suspicions;
}

// Drivers, or the time, with which everything would fit in another unit, together with the columns that are
// presumed to have the same one, or without them.
Diagnostics driver_suspicions(const FitProblem& problem, const std::vector<double>& variables) {
  const FitData& data = problem.data();
  Diagnostics suspicions;
  const auto as_it_is = whole_misfit(problem, variables, data);
  for (std::size_t i = 0; as_it_is && *as_it_is > kFarMisfit && i < data.where.size(); ++i) {
    const FitWhere& where = data.where[i];
    if (where.unit_given || where.offset) continue;
    const std::vector<std::size_t> alike = with_the_driver(data, where);
    std::optional<OtherUnit> best;
    bool with_columns = false;
    double least = std::min(kNearMisfit, kBetterMisfit * *as_it_is);
    for (const OtherUnit& other : other_units(where.unit, data.model.units())) {
      FitData scaled = data;
      for (double& value : scaled.where[i].values) value *= other.factor;
      for (const bool columns_too : {false, true}) {
        if (columns_too && alike.empty()) continue;
        for (const std::size_t c : columns_too ? alike : std::vector<std::size_t>()) {
          for (double& value : scaled.columns[c].values) value *= other.factor;
        }
        const auto there = whole_misfit(problem, variables, scaled);
        if (there && *there < least) {
          least = *there;
          best = other;
          with_columns = columns_too;
        }
      }
    }
    if (!best) continue;
    suspicions.push_back({where.place, advice(where.name, where.unit, *best)});
    for (const std::size_t c : with_columns ? alike : std::vector<std::size_t>()) {
      const FitColumn& column = data.columns[c];
      suspicions.push_back({column.place, advice(column.name, column.unit, *best)});
    }
  }
  return suspicions;
}

}  // namespace

Diagnostics unit_suspicions(const FitProblem& problem) {
  const FitData& data = problem.data();
  const std::vector<double> variables = start_values(*data.variables);
  const auto table = problem.motion().table(variables, std::vector<double>(data.where.size(), 0.0));
  if (!table) return {};
  Diagnostics suspicions = column_suspicions(data, *table);
  return suspicions.empty() ? driver_suspicions(problem, variables) : suspicions;
}

}  // namespace higherpair
