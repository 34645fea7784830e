#pragma once

#include "fit_search.hpp"

#include <string>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// What a fit's residuals say of its numbers.
struct FitStatistics {
  Eigen::VectorXd errors;                 ///< standard error of each unknown; NaN: none
  double quantile = 0;                    ///< of Student's t: half an interval over its standard error
  Eigen::MatrixXd correlation;            ///< NaN where undefined
  std::vector<bool> at_bound;             ///< unknowns that would go on beyond their bounds
  std::vector<bool> determined;           ///< unknowns that the columns say
  std::vector<std::string> undetermined;  ///< the directions that they do not, as sentences
  int freedoms = 0;
  double noise_ratio = FitReport::kUndefined;
  double chance = FitReport::kUndefined;
};

/// Half the interval of this confidence over the standard error, of Student's t; NaN without freedoms.
[[nodiscard]] double student_quantile(double freedoms, double confidence);

[[nodiscard]] FitStatistics fit_statistics(const FitProblem& problem, const FitSolution& solution);

/// The directions in which unknowns x can go without any change of the residuals, named.
/// \param J  ∂r/∂x \param determined  is set to false for the unknowns in them
[[nodiscard]] std::vector<std::string> idle_directions(const Eigen::MatrixXd& J, const Eigen::VectorXd& x,
                                                       const std::vector<std::string>& names,
                                                       std::vector<bool>& determined);

/// Autocorrelation of residuals at neighbouring places, with the share of it that is no chance: of at least
/// 12 residuals, r₁ √n above 4 and r₁ above 0.3.
struct Succession {
  double correlation = FitReport::kUndefined;
  bool systematic = false;
};
[[nodiscard]] Succession succession_of(const std::vector<double>& residuals);

}  // namespace higherpair
