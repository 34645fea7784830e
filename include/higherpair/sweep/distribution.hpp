#pragma once

#include <limits>
#include <vector>

namespace higherpair {

enum class DistributionKind {
  kUniform,     ///< equally likely between `low` and `high`
  kNormal,      ///< of `mean` and `deviation`; cut off at `low` and `high` where these are finite
  kTriangular,  ///< density rises linearly from `low` to `mode` and falls to `high`
  kValues,      ///< one of `values`, each as likely as the others
};

/// How likely which values of a variable are.
struct Distribution {
  DistributionKind kind = DistributionKind::kUniform;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  double mean = 0;
  double deviation = 0;  ///< > 0, before it is cut off
  double mode = 0;       ///< low <= mode <= high
  std::vector<double> values;

  /// Whether it is a normal one that is cut off.
  [[nodiscard]] bool is_truncated() const;
};

/// The quantile: the value below which the share u of all values lies, 0 < u < 1. Of `values` the one at this
/// share of the list. Never below `low` or above `high`.
[[nodiscard]] double quantile(const Distribution& distribution, double u);

/// The quantile of the normal distribution of mean 0 and deviation 1.
[[nodiscard]] double normal_quantile(double u);

/// The share of a normal distribution that lies between `low` and `high`.
[[nodiscard]] double share_within(const Distribution& distribution);

}  // namespace higherpair
