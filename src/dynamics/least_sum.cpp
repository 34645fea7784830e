#include "least_sum.hpp"

#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Core>

namespace higherpair {
namespace {

constexpr int kMostPivots = 10000;

// A pivot of the simplex tableau, whose last row holds the reduced costs and last column the right-hand
// sides.
void pivot(Eigen::MatrixXd& tableau, Eigen::Index row, Eigen::Index column) {
  tableau.row(row) /= tableau(row, column);
  for (Eigen::Index i = 0; i < tableau.rows(); ++i) {
    if (i != row) {
      tableau.row(i) -= tableau(i, column) * tableau.row(row);
    }
  }
}

// Bland's rule, which cannot cycle: the first column that improves the objective, and of the rows that limit
// it alike the one with the first basic variable.
Eigen::Index gaining_column(const Eigen::MatrixXd& tableau) {
  const Eigen::Index last = tableau.rows() - 1;
  for (Eigen::Index j = 0; j + 1 < tableau.cols(); ++j) {
    if (tableau(last, j) < -kTableauNothing) {
      return j;
    }
  }
  return -1;
}

Eigen::Index leaving_row(const Eigen::MatrixXd& tableau, const std::vector<Eigen::Index>& basis,
                         Eigen::Index column) {
  const auto limit = [&](Eigen::Index i) {
    return std::pair(tableau(i, tableau.cols() - 1) / tableau(i, column), basis[i]);
  };
  Eigen::Index best = -1;
  for (Eigen::Index i = 0; i + 1 < tableau.rows(); ++i) {
    if (tableau(i, column) > kTableauNothing && (best < 0 || limit(i) < limit(best))) {
      best = i;
    }
  }
  return best;
}

}  // namespace

// With x = x⁺ - x⁻ the dual programme is
//     Σ at_least_i y_i -> max   with   ± Σ_i coefficients_ij y_i <= weights_j,   y >= 0,
// which y = 0 satisfies, so the simplex method can start from it. x⁺ and x⁻ are the reduced costs of its
// slack variables. The programme is scaled so that all weights, the largest coefficient of each condition and
// the largest at_least are 1.
std::optional<std::vector<double>> solve(const LeastSum& programme) {
  const auto n = static_cast<Eigen::Index>(programme.weights.size());
  const auto m = static_cast<Eigen::Index>(programme.conditions.size());
  Eigen::MatrixXd tableau = Eigen::MatrixXd::Zero(2 * n + 1, m + 2 * n + 1);
  double unit = 0;
  for (Eigen::Index i = 0; i < m; ++i) {
    const LeastSum::Condition& condition = programme.conditions[i];
    Eigen::VectorXd scaled(n);
    for (Eigen::Index j = 0; j < n; ++j) {
      scaled(j) = condition.coefficients[j] / programme.weights[j];
    }
    const double largest = scaled.lpNorm<Eigen::Infinity>();
    if (!(largest > 0)) {
      if (condition.at_least > 0) {
        return std::nullopt;
      }
      continue;
    }
    tableau.block(0, i, n, 1) = scaled / largest;
    tableau.block(n, i, n, 1) = -scaled / largest;
    tableau(2 * n, i) = -condition.at_least / largest;
    unit = std::max(unit, condition.at_least / largest);
  }
  if (!std::isfinite(unit)) {
    return std::nullopt;
  }
  std::vector<double> x(programme.weights.size(), 0);
  if (!(unit > 0)) {
    return x;
  }
  tableau.row(2 * n) /= unit;
  tableau.block(0, m, 2 * n, 2 * n).setIdentity();
  tableau.col(m + 2 * n).head(2 * n).setOnes();
  std::vector<Eigen::Index> basis(2 * n);
  std::iota(basis.begin(), basis.end(), m);
  Eigen::Index column = gaining_column(tableau);
  for (int i = 0; i < kMostPivots && column >= 0; ++i) {
    const Eigen::Index row = leaving_row(tableau, basis, column);
    if (row < 0) {
      return std::nullopt;
    }
    pivot(tableau, row, column);
    basis[row] = column;
    column = gaining_column(tableau);
  }
  if (column >= 0) {
    return std::nullopt;
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    const double difference = tableau(2 * n, m + j) - tableau(2 * n, m + n + j);
    x[j] = unit * difference / programme.weights[j];
  }
  return x;
}

}  // namespace higherpair
