#pragma once

#include "higherpair/numeric/special_values.hpp"

#include <atomic>
#include <functional>

#include <Eigen/Core>

namespace higherpair {

/// Numbers x that minimise a sum of squares.
struct LeastSquaresProblem {
  /// Writes r(x); false where x has no residuals.
  std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd& r)> residuals;
  /// Writes ∂r/∂x at an x that has residuals; false where they cannot be differentiated.
  std::function<bool(const Eigen::VectorXd& x, Eigen::MatrixXd& J)> jacobian;
  Eigen::VectorXd low, high;  ///< bounds, ±infinity where there is none; empty: no bounds
};

struct LeastSquaresOptions {
  int iterations = 200;  ///< largest number of Jacobians
  /// Size of a residual that is rounding: if all are no larger, or no step could gain more, the sum is at its
  /// minimum.
  double rounding = 0;
  const std::atomic<bool>* stop = nullptr;
};

enum class LeastSquaresEnd {
  kConverged,   ///< the best step would gain less than 1e-22 of the sum, or no more than rounding
  kIterations,  ///< not within the permitted number of iterations
  kStuck,       ///< no step gains what the derivatives predict: r is not smooth, or J is wrong
  kUndefined,   ///< the start has no residuals, or they cannot be differentiated
  kStopped,
};

struct LeastSquaresFit {
  Eigen::VectorXd x;  ///< the best found; the start if kUndefined
  Eigen::VectorXd r;  ///< there
  Eigen::MatrixXd J;  ///< there, or at the step before
  double sum = kInf;  ///< ‖r‖²
  int iterations = 0;
  LeastSquaresEnd end = LeastSquaresEnd::kUndefined;
};

/// The method of Levenberg and Marquardt with bounds: variables are scaled by the columns of J, steps end at
/// the bounds, and variables that would leave them are held there. Where J does not have full rank the
/// variables move no farther from the start than necessary.
/// Moré, The Levenberg-Marquardt algorithm, 1978; Nielsen, Damping parameter in Marquardt's method, 1999.
[[nodiscard]] LeastSquaresFit least_squares(const LeastSquaresProblem& problem, const Eigen::VectorXd& start,
                                            const LeastSquaresOptions& options = {});

/// The factor R of matrix = Q R, with no more rows than columns.
[[nodiscard]] Eigen::MatrixXd triangular_factor(const Eigen::MatrixXd& matrix);

}  // namespace higherpair
