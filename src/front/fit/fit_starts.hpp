#pragma once

#include "fit_problem.hpp"
#include "numeric/least_squares.hpp"

#include <atomic>

namespace higherpair {

/// Where a fit begins.
struct FitStart {
  Eigen::VectorXd x;
  int starts = 1;     ///< number of searches that came to an end
  int different = 1;  ///< number of different ends of these
};

/// The profile's own numbers, or the best end of several searches from random numbers. The noise is not known
/// yet: each column is scaled by its spread.
[[nodiscard]] FitStart best_start(const FitProblem& problem, const FitSettings& settings);

/// Least squares of the residuals, each multiplied by its scale.
[[nodiscard]] LeastSquaresFit minimise(const FitProblem& problem, const Eigen::VectorXd& from,
                                       const Eigen::VectorXd& scales, const std::atomic<bool>* stop);

}  // namespace higherpair
