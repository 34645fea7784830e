#pragma once

#include "fit_problem.hpp"
#include "numeric/least_squares.hpp"

#include <vector>

namespace higherpair {

/// Where a fit has come to.
struct FitSolution {
  Eigen::VectorXd x;
  Eigen::VectorXd residuals;       ///< in units of columns
  std::vector<double> noise;       ///< of each column, in its unit; by which residuals are measured
  std::vector<double> deviations;  ///< the same estimated, also where one is given
  Eigen::VectorXd weights;         ///< what the loss leaves of each residual
  std::vector<bool> constant;      ///< columns that no unknown changes: without a part in the fit
  int missing = 0;
  int starts = 0;
  int different = 0;
  int iterations = 0;
  FitEnd end = FitEnd::kNotConverged;
  bool started = false;  ///< false: no candidate could be started
};

/// Looks for the least loss: from the profile's numbers, and from random ones where all variables have
/// bounds. The noise of columns that have none given and the weights of the loss are found along with it.
[[nodiscard]] FitSolution solve_fit(const FitProblem& problem, const FitSettings& settings);

/// Residuals in units of noise, with √weight of columns and loss; of columns without a part 0.
[[nodiscard]] Eigen::VectorXd scales_of(const FitProblem& problem, const FitSolution& solution);

}  // namespace higherpair
