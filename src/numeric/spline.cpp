#include "numeric/spline.hpp"

#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/tolerances.hpp"
#include "numeric/spline_basis.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>

namespace higherpair {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using spline_basis::Basis;
using spline_basis::LocalRows;
using spline_basis::Polynomial;
using spline_basis::Weights;

constexpr std::uintmax_t kMostTrials = 40;
constexpr int kBitsOfWeight = 20;  // precision of the exponent of the weight

// Powers of x from 0 to the highest degree of a spline.
Polynomial powers_of(double x) {
  Polynomial powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) {
    powers[k] = powers[k - 1] * x;
  }
  return powers;
}

class Interpolation {
public:
  Interpolation(const Basis& basis, const SplineTask& task)
      : basis_(basis),
        task_(task),
        system_(conditions(basis, basis.degree() + 1)),
        right_(MatrixXd::Zero(basis.size(), task.values.cols())) {}

  [[nodiscard]] MatrixXd solve() {
    // The conditions at the beginning come first, which keeps the matrix banded.
    const Index before = basis_.periodic() ? 0 : (basis_.degree() - 1) / 2;
    for (Index i = 0; i < basis_.points(); ++i) {
      add(before + i, derivative_at_point(basis_, i, 0));
      right_.row(before + i) = task_.values.row(i);
    }
    for (Index k = 0; k < before; ++k) {
      const bool outermost = k + 1 == before;
      add_end(k, 0, k, outermost ? task_.first_slope : Eigen::RowVectorXd());
      add_end(basis_.size() - 1 - k, basis_.points() - 1, k,
              outermost ? task_.last_slope : Eigen::RowVectorXd());
    }
    const BandSolver solver(system_);
    if (!solver.is_regular()) {  // a number has overflowed
      return MatrixXd::Constant(right_.rows(), right_.cols(), kNoValue);
    }
    MatrixXd solution = solver.solve(right_);
    solution += solver.solve(right_ - system_.times(solution));
    MatrixXd coefficients(solution.rows(), solution.cols());
    for (Index i = 0; i < basis_.size(); ++i) {
      coefficients.row(i) = solution.row(turned(i));
    }
    return coefficients;
  }

private:
  // Shifts the indices of a periodic spline so that the B-spline that is largest at a point is on the
  // diagonal.
  [[nodiscard]] Index turned(Index index) const {
    return basis_.periodic() ? (index + basis_.size() * basis_.degree() - basis_.degree() / 2) % basis_.size()
                             : index;
  }

  void add(Index row, const std::pair<Index, Weights>& condition, double factor = 1) {
    const auto& [interval, weights] = condition;
    for (int j = 0; j <= basis_.degree(); ++j) {
      system_.add(row, turned(basis_.index(interval, j)), factor * weights[j]);
    }
  }

  // A condition besides the points at an end: a slope, the absence of a knot at the next inner point, or a
  // derivative of 0.
  void add_end(Index row, Index point, Index k, const Eigen::RowVectorXd& slope) {
    if (slope.size() > 0) {
      add(row, derivative_at_point(basis_, point, 1));
      right_.row(row) = basis_.unit() * slope;
    } else if (task_.no_end_knots) {
      const Index within = point == 0 ? k + 1 : point - k - 1;
      add(row, {within - 1, derivative_at(basis_, within - 1, basis_.degree(), 0)}, -1);
      add(row, {within, derivative_at(basis_, within, basis_.degree(), 0)});
    } else {
      add(row, derivative_at_point(basis_, point, (basis_.degree() + 1) / 2 + static_cast<int>(k)));
    }
  }

  const Basis& basis_;
  const SplineTask& task_;
  BandMatrix system_;
  MatrixXd right_;
};

LocalRows values_at_points(const Basis& basis) {
  LocalRows rows(basis);
  for (Index i = 0; i < basis.points(); ++i) {
    const auto [interval, weights] = derivative_at_point(basis, i, 0);
    rows.add(interval, weights);
  }
  return rows;
}

// Rows with Σ (row · c)² = ∫ |s^(m)|² for a spline with coefficients c: its m-th derivative, of degree m - 1,
// at the m points of Gauss' rule in every interval, times the roots of their weights.
LocalRows bending(const Basis& basis) {
  struct Rule {
    std::array<double, 3> place, weight;
  };
  constexpr Rule kTwo{{-0.57735026918962576, 0.57735026918962576, 0}, {1, 1, 0}};
  constexpr Rule kThree{{-0.77459666924148338, 0, 0.77459666924148338}, {5.0 / 9, 8.0 / 9, 5.0 / 9}};
  const int m = (basis.degree() + 1) / 2;
  const Rule& rule = m == 2 ? kTwo : kThree;
  const double factorial = m == 2 ? 2 : 6;
  LocalRows rows(basis);
  for (Index interval = 0; interval < basis.intervals(); ++interval) {
    const double half = basis.length(interval) / 2;
    for (std::size_t g = 0; g < static_cast<std::size_t>(m); ++g) {
      Weights weights = derivative_at(basis, interval, m, half * (1 + rule.place[g]));
      for (double& weight : weights) {
        weight *= factorial * std::sqrt(rule.weight[g] * half);
      }
      rows.add(interval, weights);
    }
  }
  return rows;
}

MatrixXd smoothed(const Basis& basis, const SplineTask& task) {
  const MatrixXd& values = task.values;
  const LocalRows at_points = values_at_points(basis);
  const LocalRows bends = bending(basis);
  const BandMatrix near_points = at_points.normal_matrix();
  const BandMatrix rough = bends.normal_matrix();
  const MatrixXd right = at_points.transpose_times(values);
  std::optional<MatrixXd> best;
  double heaviest = kLightestSmoothing;  // exponent of the heaviest weight that keeps the tolerance
  // Logarithm of the largest distance of a point relative to the tolerance: it grows with the weight.
  const auto share = [&](double exponent) {
    const double weight = std::pow(10.0, exponent);
    const BandSolver solver(near_points.plus(weight, rough), Pivoting::kNone);
    if (!solver.is_regular()) {
      return kHeaviestSmoothing;
    }
    // With a heavy weight the condition number is large: the residuals, computed from the conditions
    // themselves, restore the digits.
    MatrixXd solution = solver.solve(right);
    solution += solver.solve(at_points.transpose_times(values - at_points.times(solution)) -
                             weight * bends.transpose_times(bends.times(solution)));
    const double left = (at_points.times(solution) - values).rowwise().norm().maxCoeff();
    if (left <= task.smoothing && (!best || exponent > heaviest)) {
      heaviest = exponent;
      best = std::move(solution);
    }
    return left > 0 ? std::log(left / task.smoothing) : kLightestSmoothing;
  };
  const double low = share(kLightestSmoothing);
  const double high = share(kHeaviestSmoothing);
  if (low < 0 && high > 0) {
    std::uintmax_t trials = kMostTrials;
    boost::math::tools::toms748_solve(share, kLightestSmoothing, kHeaviestSmoothing, low, high,
                                      boost::math::tools::eps_tolerance<double>(kBitsOfWeight), trials);
  }
  return best ? *std::move(best) : Interpolation(basis, task).solve();
}

}  // namespace

MatrixXd spline_powers(const SplineTask& task) {
  assert((task.degree == 3 || task.degree == 5) && task.x.size() >= 3);
  const Basis basis(task);
  const MatrixXd coefficients =
      task.smoothing > 0 ? smoothed(basis, task) : Interpolation(basis, task).solve();
  const Index terms = task.degree + 1;
  MatrixXd powers = MatrixXd::Zero(basis.intervals() * terms, task.values.cols());
  const Polynomial per_unit = powers_of(1 / basis.unit());
  for (Index column = 0; column < coefficients.cols(); ++column) {
    for (Index interval = 0; interval < basis.intervals(); ++interval) {
      Polynomial sum{};
      for (int j = 0; j <= task.degree; ++j) {
        const Polynomial& own = basis.on(interval)[j];
        const double coefficient = coefficients(basis.index(interval, j), column);
        for (std::size_t k = 0; k < sum.size(); ++k) {
          sum[k] += own[k] * coefficient;
        }
      }
      for (Index k = 0; k < terms; ++k) {
        const auto power = static_cast<std::size_t>(k);
        powers(interval * terms + k, column) = sum[power] * per_unit[power];
      }
    }
  }
  return powers;
}

}  // namespace higherpair
