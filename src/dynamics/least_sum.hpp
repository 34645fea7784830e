#pragma once

#include <optional>
#include <vector>

namespace higherpair {

/// The linear programme
///     Σ weights_j |x_j| -> min   with   Σ coefficients_ij x_j >= at_least_i   for all i.
struct LeastSum {
  struct Condition {
    std::vector<double> coefficients;
    double at_least = 0;
  };
  std::vector<double> weights;  ///< > 0
  std::vector<Condition> conditions;
};

/// Solves it by the simplex method; none if no x meets all conditions.
[[nodiscard]] std::optional<std::vector<double>> solve(const LeastSum& programme);

}  // namespace higherpair
