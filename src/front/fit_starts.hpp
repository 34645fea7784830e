#pragma once

#include "fit_problem.hpp"
#include "numeric/least_squares.hpp"

#include <atomic>

namespace higherpair {

/// Where a fit begins.
struct FitStart {
  Eigen::VectorXd x;
  int starts = 1;     ///< searches that have come to an end
  int different = 1;  ///< ends of these
};

/// The profile's own numbers, or, of several searches from random numbers, the end of the best. What misses
/// are worth is not known yet: each column counts by its spread.
[[nodiscard]] FitStart best_start(const FitProblem& problem, const FitSettings& settings);

/// Least squares of the residuals, each times its scale.
[[nodiscard]] LeastSquaresFit minimise(const FitProblem& problem, const Eigen::VectorXd& from,
                                       const Eigen::VectorXd& scales, const std::atomic<bool>* stop);

}  // namespace higherpair
