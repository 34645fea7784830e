#include "fit_problem.hpp"

#include "fit_columns.hpp"
#include "front/tolerances.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

using Kind = FitUnknown::Kind;

constexpr int kPlaces = 36;  // values tried for the unknown zero of a driver

}  // namespace

FitProblem::FitProblem(const FitData& data, const FitMotion& motion)
    : data_(data), motion_(motion), measurement_(data) {
  for (std::size_t k = 0; k < data.rows(); ++k) {
    for (std::size_t c = 0; c < data.columns.size(); ++c) {
      if (!std::isnan(data.columns[c].values[k])) values_.push_back({k, c});
    }
  }
  for (const FitColumn& column : data.columns) {
    double sum = 0, count = 0, largest = 0;
    for (const double value : column.values) {
      if (std::isnan(value)) continue;
      sum += value;
      count += 1;
      largest = std::max(largest, std::abs(value));
    }
    double spread = 0;
    for (const double value : column.values) {
      if (!std::isnan(value)) spread = std::max(spread, std::abs(value - sum / count));
    }
    largest_.push_back(largest > 0 ? largest : 1);
    spreads_.push_back(spread > kNoSpread * largest ? spread : largest_.back());
  }
  spread_scales_.resize(eigen_index(values_.size()));
  for (std::size_t i = 0; i < values_.size(); ++i) {
    spread_scales_(eigen_index(i)) = 1 / spread(values_[i].column);
  }
  const std::vector<DesignTask::Variable>& variables = data.variables->variables;
  low_ = Eigen::VectorXd::Constant(size(), -kInf);
  high_ = Eigen::VectorXd::Constant(size(), kInf);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    low_(eigen_index(i)) = variables[i].range.low;
    high_(eigen_index(i)) = variables[i].range.high;
  }
}

Eigen::VectorXd FitProblem::residuals_of(const FitTable& fitted, int* missing) const {
  Eigen::VectorXd r(eigen_index(values_.size()));
  if (missing != nullptr) *missing = 0;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const Value& value = values_[i];
    const double own = fitted(eigen_index(value.row), eigen_index(value.column));
    r(eigen_index(i)) =
        std::isfinite(own) ? data_.columns[value.column].values[value.row] - own : spread(value.column);
    if (missing != nullptr && !std::isfinite(own)) ++*missing;
  }
  return r;
}

std::optional<Eigen::VectorXd> FitProblem::residuals(const Eigen::VectorXd& x, int* missing) const {
  auto table = motion_.table(measurement_.variables_in(x), measurement_.offsets_in(x));
  if (!table) return std::nullopt;
  measurement_.show(x, *table);
  return residuals_of(*table, missing);
}

std::optional<Eigen::MatrixXd> FitProblem::jacobian(const Eigen::VectorXd& x) const {
  const std::vector<double> variables = measurement_.variables_in(x), offsets = measurement_.offsets_in(x);
  const auto table = motion_.table(variables, offsets);
  auto by_motion = motion_.derivatives(variables, offsets);
  if (!table || !by_motion) return std::nullopt;
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(eigen_index(values_.size()), size());
  std::size_t moved = 0;  // unknowns that the motion depends on come first
  for (std::size_t p = 0; p < unknowns().size(); ++p) {
    const Kind kind = unknowns()[p].kind;
    const bool moves = kind == Kind::kVariable || kind == Kind::kWhere;
    const FitTable by = moves ? measurement_.change_shown(x, std::move((*by_motion)[moved++]))
                              : measurement_.derivative(x, *table, unknowns()[p]);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double slope = by(eigen_index(values_[i].row), eigen_index(values_[i].column));
      const bool there = std::isfinite((*table)(eigen_index(values_[i].row), eigen_index(values_[i].column)));
      J(eigen_index(i), eigen_index(p)) = there && std::isfinite(slope) ? -slope : 0;
    }
  }
  clear_rounding(J);
  return J;
}

// Sets to 0 what a number of the profile changes in a column, if it is nothing but rounding in all rows.
void FitProblem::clear_rounding(Eigen::MatrixXd& J) const {
  for (std::size_t p = 0; p < data_.variables->variables.size(); ++p) {
    std::vector<double> effects(data_.columns.size(), 0);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      double& effect = effects[values_[i].column];
      effect = std::max(effect, std::abs(J(eigen_index(i), eigen_index(p))) * motion_.scale(p));
    }
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const std::size_t column = values_[i].column;
      if (effects[column] <= kNoFitEffect * largest(column)) J(eigen_index(i), eigen_index(p)) = 0;
    }
  }
}

std::vector<double> FitProblem::unwrapped(std::size_t column, const Eigen::VectorXd& x) const {
  std::vector<double> values = data_.columns[column].values;
  const double turn = full_turn(data_.model.units());
  const auto r = residuals(x);
  if (data_.columns[column].unit != unit_text(dimension::kAngle, data_.model.units()) || !r) return values;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (values_[i].column != column) continue;
    const double off = std::remainder((*r)(eigen_index(i)), turn);
    if (!(std::abs(off) <= turn / 4)) return data_.columns[column].values;
    values[values_[i].row] += off - (*r)(eigen_index(i));
  }
  return values;
}

Eigen::VectorXd FitProblem::start() const {
  const std::vector<double> variables = start_values(*data_.variables);
  auto x = start_from(variables);
  return x ? *std::move(x) : unmeasured(variables);
}

Eigen::VectorXd FitProblem::unmeasured(std::span<const double> variables) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(size());
  std::copy(variables.begin(), variables.end(), x.begin());
  for (std::size_t i = 0; i < unknowns().size(); ++i) {
    if (unknowns()[i].kind == Kind::kScale) x(eigen_index(i)) = 1;
  }
  return x;
}

std::optional<Eigen::VectorXd> FitProblem::start_from(std::span<const double> variables) const {
  std::optional<Eigen::VectorXd> best;
  double least = kInf;
  const auto try_at = [&](double share) {
    Eigen::VectorXd x = unmeasured(variables);
    for (std::size_t i = 0; i < unknowns().size(); ++i) {
      if (unknowns()[i].kind != Kind::kWhere) continue;
      const std::vector<double>& where = data_.where[unknowns()[i].index].values;
      const auto [first, last] = std::minmax_element(where.begin(), where.end());
      const bool turns = !data_.in_time() && driver_turns(data_.model.mechanism(), unknowns()[i].index);
      x(eigen_index(i)) = share * (turns ? full_turn(data_.model.units()) : *last - *first);
    }
    auto table = motion_.table(measurement_.variables_in(x), measurement_.offsets_in(x));
    if (!table) return;
    measurement_.place_nearest(*table, x);
    measurement_.show(x, *table);
    const double sum = squares(residuals_of(*table, nullptr));
    if (sum < least) {
      least = sum;
      best = x;
    }
  };
  try_at(0);
  const bool unknown_zero = std::any_of(unknowns().begin(), unknowns().end(),
                                        [](const FitUnknown& u) { return u.kind == Kind::kWhere; });
  for (int k = 1; unknown_zero && k < kPlaces; ++k) {
    try_at((k % 2 == 0 ? 0.5 : -0.5) * (k + 1) / kPlaces);
  }
  return best;
}

}  // namespace higherpair
