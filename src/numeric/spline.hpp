#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// A spline in one parameter x, with a knot at every point.
struct SplineTask {
  std::vector<double> x;   ///< of the points, ascending; at least 3
  Eigen::MatrixXd values;  ///< one row a point, any number of columns
  int degree = 5;          ///< 3 or 5
  double period = 0;       ///< > x.back() - x.front(): periodic; 0: natural, which is that of all splines
                           ///< derivatives from the (degree+1)/2-th to the last but one vanish at both ends
  double smoothing = 0;    ///< no point is left by more than this; 0: interpolation
  /// Of an interpolating spline that is not periodic: no knots at the (degree - 1)/2 points next to each end,
  /// in place of the natural conditions, which hold back its error there.
  bool no_end_knots = false;
  /// Derivatives at its ends, each in place of one of those conditions, the innermost; empty: free.
  Eigen::RowVectorXd first_slope = {};
  Eigen::RowVectorXd last_slope = {};
};

/// Powers of t = x - x_i on the i-th interval: row i (degree + 1) + k has the coefficients of tᵏ of all
/// columns. As many intervals as points where periodic, else one less.
///
/// Interpolation solves the banded system of the B-splines' values at the points. Smoothing takes of all
/// splines that leave no point by more than the tolerance the one with the least weight λ⁻¹ on the points
/// that does:
///     Σ |s(x_i) - s_i|² + λ ∫ |s^(m)|² dx -> min,   m = (degree + 1)/2.
/// de Boor, A Practical Guide to Splines, IX and XIV.
[[nodiscard]] Eigen::MatrixXd spline_powers(const SplineTask& task);

}  // namespace higherpair
