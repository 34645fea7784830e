#pragma once

#include "fit_search.hpp"

#include <string>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// Statistics of a fit's unknowns, from its residuals.
struct FitStatistics {
  Eigen::VectorXd errors;                 ///< standard error of each unknown; NaN: none
  double quantile = 0;                    ///< of Student's t: half an interval per standard error
  Eigen::MatrixXd correlation;            ///< NaN where undefined
  std::vector<bool> at_bound;             ///< unknowns that would move beyond their bounds
  std::vector<bool> determined;           ///< unknowns that the columns determine
  std::vector<std::string> undetermined;  ///< the directions that they do not determine, as sentences
  int freedoms = 0;
  double noise_ratio = FitReport::kUndefined;
  double chance = FitReport::kUndefined;
};

/// Half the confidence interval divided by the standard error, from Student's t; NaN without degrees of
/// freedom.
[[nodiscard]] double student_quantile(double freedoms, double confidence);

[[nodiscard]] FitStatistics fit_statistics(const FitProblem& problem, const FitSolution& solution);

/// The directions in which the unknowns x can change without any change of the residuals, as sentences.
/// \param J  ∂r/∂x \param determined  set to false for the unknowns in them
[[nodiscard]] std::vector<std::string> idle_directions(const Eigen::MatrixXd& J, const Eigen::VectorXd& x,
                                                       const std::vector<std::string>& names,
                                                       std::vector<bool>& determined);

/// Autocorrelation of residuals at neighbouring places. It is systematic, not chance, if there are at least
/// 12 residuals, r₁ √n > 4 and r₁ > 0.3.
struct Succession {
  double correlation = FitReport::kUndefined;
  bool systematic = false;
};
[[nodiscard]] Succession succession_of(const std::vector<double>& residuals);

}  // namespace higherpair
