#pragma once

#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// A spline in one parameter x, with a knot at every point.
struct SplineTask {
  std::vector<double> x;   ///< parameters of the points, ascending; at least 3
  Eigen::MatrixXd values;  ///< one row per point, any number of columns
  int degree = 5;          ///< 3 or 5
  /// > x.back() - x.front(): periodic; 0: natural, i.e. the derivatives from the (degree+1)/2-th to the last
  /// but one vanish at both ends.
  double period = 0;
  double smoothing = 0;  ///< largest distance of a point from the spline; 0: interpolation
  /// For an interpolating spline that is not periodic: no knots at the (degree - 1)/2 points next to each
  /// end, instead of the natural conditions, which reduce its accuracy there.
  bool no_end_knots = false;
  /// Derivatives at its ends, each replacing the innermost of those conditions; empty: free.
  Eigen::RowVectorXd first_slope = {};
  Eigen::RowVectorXd last_slope = {};
};

/// Powers of t = x - x_i on the i-th interval: row i (degree + 1) + k has the coefficients of tᵏ of all
/// columns. There are as many intervals as points if periodic, otherwise one less.
///
/// Interpolation solves the banded system of the B-splines' values at the points. Smoothing minimises
///     Σ |s(x_i) - s_i|² + λ ∫ |s^(m)|² dx,   m = (degree + 1)/2,
/// with the largest λ for which no point is farther from the spline than the tolerance.
/// de Boor, A Practical Guide to Splines, IX and XIV.
[[nodiscard]] Eigen::MatrixXd spline_powers(const SplineTask& task);

}  // namespace higherpair
