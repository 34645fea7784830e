#pragma once

#include "fit_problem.hpp"

#include <vector>

namespace higherpair {

/// The result of a fit.
struct FitSolution {
  Eigen::VectorXd x;
  Eigen::VectorXd residuals;       ///< in units of columns
  std::vector<double> noise;       ///< for each column, in its unit; residuals are divided by it
  std::vector<double> deviations;  ///< the same as estimated from the residuals, even where it is given
  Eigen::VectorXd weights;         ///< factor by which the loss reduces each residual's weight
  std::vector<bool> constant;      ///< columns that no unknown changes; they have no part in the fit
  int missing = 0;
  int starts = 0;
  int different = 0;
  int iterations = 0;
  FitEnd end = FitEnd::kNotConverged;
  bool started = false;  ///< false: no candidate could be started
};

/// Minimises the loss: from the profile's numbers, and from random ones where all variables have bounds. The
/// noise of columns for which none is given and the weights of the loss are estimated along with it.
[[nodiscard]] FitSolution solve_fit(const FitProblem& problem, const FitSettings& settings);

/// Standard deviation of a column's noise estimated from the median size of its residuals, which a few wrong
/// values hardly change.
[[nodiscard]] double robust_noise(const FitProblem& problem, const Eigen::VectorXd& residuals,
                                  std::size_t column);

/// Factors that give residuals in units of noise, with √weight of columns; 0 for columns that have no part in
/// the fit. \param weights  of the values, such as those that the loss gives them
[[nodiscard]] Eigen::VectorXd scales_of(const FitProblem& problem, const FitSolution& solution,
                                        const Eigen::VectorXd& weights);

}  // namespace higherpair
