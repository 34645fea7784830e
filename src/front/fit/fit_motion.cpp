#include "fit_motion.hpp"

#include "fit_candidate.hpp"
#include "fit_columns.hpp"
#include "front/tolerances.hpp"
#include "higherpair/analysis/displaced.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/numbers.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/eigen_index.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// The variables alone, each with finite bounds about its start.
DesignTask ranges_of(const DesignTask& task) {
  DesignTask ranges;
  for (DesignTask::Variable variable : task.variables) {
    DesignVariable& range = variable.range;
    const double span = range.start != 0 ? kUnboundedRange * std::abs(range.start) : 1;
    if (!std::isfinite(range.low)) range.low = std::min(range.start, range.high) - span;
    if (!std::isfinite(range.high)) range.high = std::max(range.start, range.low) + span;
    ranges.variables.push_back(std::move(variable));
  }
  return ranges;
}

// The effect of a parameter of the fit: on the mechanism, or on the position of a driver.
struct FitParameter {
  Sensitivity by;
  std::optional<std::size_t> offset;  // of this driver
};

// The variables, then the offsets that are free.
std::optional<std::vector<FitParameter>> parameters_of(const FitCandidate& candidate, const FitData& data,
                                                       const DesignNumbers& numbers,
                                                       std::span<const double> variables) {
  std::vector<FitParameter> parameters;
  const std::vector<double> at_rest(candidate.run.mechanism().drivers.size(), 0.0);
  const auto add = [&](const auto& derivative, std::optional<std::size_t> offset) {
    auto by = Sensitivity::at_start(candidate.run, derivative, at_rest);
    if (!by) return false;
    parameters.push_back({*std::move(by), offset});
    return true;
  };
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const auto derivative = numbers.derivative(i, variables);
    if (!derivative || !add(*derivative, std::nullopt)) return std::nullopt;
  }
  Mechanism none = candidate.run.mechanism();
  for_each_number(none, [](double& number) { number = 0; });
  for (std::size_t i = 0; i < data.where.size(); ++i) {
    if (data.where[i].offset && !add(none, i)) return std::nullopt;
  }
  return parameters;
}

// Derivatives of the drivers' motions in a row by a parameter: an offset of a position is subtracted from it;
// an offset of time makes all drivers earlier.
std::vector<DriverMotion> shift_of(const FitData& data, const std::vector<DriverState>& row,
                                   std::optional<std::size_t> offset) {
  std::vector<DriverMotion> by(row.size(), DriverMotion{0, 0, 0});
  if (offset && data.in_time()) {
    const double per_second = to_si(dimension::kTime, data.model.units()).apply(1);
    for (std::size_t i = 0; i < by.size(); ++i) {
      by[i] = {-per_second * row[i].si.velocity, -per_second * row[i].si.acceleration,
               -per_second * row[i].higher_si[0]};
    }
  } else if (offset) {
    const bool turns = driver_turns(data.model.mechanism(), *offset);
    by[*offset].position = -to_si(coordinate_dimension(turns), data.model.units()).apply(1);
  }
  return by;
}

// Some of the measured columns in row k, for a mechanism displaced in that row.
std::vector<double> measured_of(FitCandidate& candidate, const FitData& data, std::size_t k,
                                const Run& displaced, const std::vector<std::size_t>& wanted) {
  const std::vector<double> all =
      values_of(candidate.columns, data.settings.forces, displaced, candidate.rows[k], candidate.times[k]);
  std::vector<double> values;
  for (const std::size_t c : wanted) values.push_back(all[candidate.slots[c]]);
  return values;
}

}  // namespace

FitMotion::FitMotion(const FitData& data, int branch)
    : data_(data), ranges_(ranges_of(*data.variables)), numbers_(data.model, ranges_), branch_(branch) {}

std::optional<FitCandidate> FitMotion::start(std::span<const double> variables,
                                             std::span<const double> offsets) const {
  return fit_candidate(data_, numbers_.data_of(variables), branch_, offsets);
}

std::optional<FitTable> FitMotion::table(std::span<const double> variables,
                                         std::span<const double> offsets) const {
  auto candidate = start(variables, offsets);
  if (!candidate) return std::nullopt;
  FitTable table(eigen_index(data_.rows()), eigen_index(data_.columns.size()));
  for_each_row(*candidate, [&](std::size_t k, const auto&, const std::vector<double>& values) {
    for (std::size_t c = 0; c < candidate->slots.size(); ++c) {
      table(eigen_index(k), eigen_index(c)) = values[candidate->slots[c]];
    }
  });
  return table;
}

std::optional<std::vector<FitTable>> FitMotion::derivatives(std::span<const double> variables,
                                                            std::span<const double> offsets) const {
  if (exact_) {
    if (auto exact = exact_derivatives(variables, offsets)) return exact;
  }
  return differences(variables, offsets);
}

void FitMotion::choose_derivatives(std::span<const double> variables, std::span<const double> offsets) {
  const auto exact = exact_derivatives(variables, offsets);
  const auto near = exact ? differences(variables, offsets) : std::nullopt;
  exact_ = exact.has_value() && near.has_value();
  for (std::size_t p = 0; exact_ && p < exact->size(); ++p) {
    for (Eigen::Index c = 0; c < (*exact)[p].cols(); ++c) {
      double largest = 0, off = 0;
      for (Eigen::Index k = 0; k < (*exact)[p].rows(); ++k) {
        const double one = (*exact)[p](k, c), other = (*near)[p](k, c);
        if (std::isnan(one) && std::isnan(other)) continue;
        largest = std::max(largest, std::abs(other));
        if (!(std::abs(one - other) <= off)) off = std::abs(one - other);
      }
      exact_ = exact_ && off <= kDerivativesAgree * largest + kNoDerivative;
    }
  }
}

std::optional<std::vector<FitTable>> FitMotion::exact_derivatives(std::span<const double> variables,
                                                                  std::span<const double> offsets) const {
  auto candidate = start(variables, offsets);
  if (!candidate) return std::nullopt;
  const auto parameters = parameters_of(*candidate, data_, numbers_, variables);
  if (!parameters) return std::nullopt;
  const FitColumns closed(candidate->run.mechanism(), data_);
  std::vector<FitTable> tables(
      parameters->size(),
      FitTable::Constant(eigen_index(data_.rows()), eigen_index(data_.columns.size()), kNoValue));
  bool made = true;
  for_each_row(*candidate, [&](std::size_t k, const auto& motions, const std::vector<double>& values) {
    const bool there = std::any_of(candidate->slots.begin(), candidate->slots.end(),
                                   [&](std::size_t slot) { return !std::isnan(values[slot]); });
    for (std::size_t p = 0; made && there && p < parameters->size(); ++p) {
      const auto& [by, offset] = (*parameters)[p];
      const auto of_row =
          by.of_row(candidate->run, motions, shift_of(data_, candidate->rows[k], offset), closed.rates());
      made = of_row.has_value();
      if (!made) return;
      auto row = tables[p].row(eigen_index(k));
      closed.derivatives(candidate->run, by.derivative(), *of_row, row);
      if (closed.others().empty()) continue;
      const std::vector<double> others =
          derivative_along(candidate->run, by, *of_row, [&](const Run& displaced, double /*step*/) {
            return measured_of(*candidate, data_, k, displaced, closed.others());
          });
      for (std::size_t i = 0; i < others.size(); ++i) {
        row(eigen_index(closed.others()[i])) = others[i];
      }
    }
  });
  return made ? std::optional(std::move(tables)) : std::nullopt;
}

std::optional<std::vector<FitTable>> FitMotion::differences(std::span<const double> variables,
                                                            std::span<const double> offsets) const {
  std::vector<FitTable> tables;
  const auto by = [&](std::span<const double> start_x, double h, auto table_at) {
    std::optional<FitTable> sum;
    for (const auto& [steps, weight] : {std::pair(1.0, 8.0), {-1.0, -8.0}, {2.0, -1.0}, {-2.0, 1.0}}) {
      const auto there = table_at(start_x, steps * h);
      if (!there) return false;
      const FitTable part = weight / (12 * h) * *there;
      sum = sum ? FitTable(*sum + part) : part;
    }
    tables.push_back(*std::move(sum));
    return true;
  };
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const bool made =
        by(variables, kFourthOrderStep * numbers_.scale(i), [&](std::span<const double> from, double step) {
          std::vector<double> x(from.begin(), from.end());
          x[i] += step;
          return table(x, offsets);
        });
    if (!made) return std::nullopt;
  }
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (!data_.where[i].offset) continue;
    double h = kOffsetStep;
    if (data_.in_time()) {
      const std::vector<double>& times = data_.where[0].values;
      const auto [first, last] = std::minmax_element(times.begin(), times.end());
      h *= *last > *first ? *last - *first : 1;
    } else if (driver_turns(data_.model.mechanism(), i)) {
      h = from_si(dimension::kAngle, data_.model.units()).apply(h);
    } else {
      h *= from_si(dimension::kLength, data_.model.units()).apply(data_.model.data().plan->size);
    }
    const bool made = by(offsets, h, [&](std::span<const double> from, double step) {
      std::vector<double> moved(from.begin(), from.end());
      moved[i] += step;
      return table(variables, moved);
    });
    if (!made) return std::nullopt;
  }
  return tables;
}

}  // namespace higherpair
