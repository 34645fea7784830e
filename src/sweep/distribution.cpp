#include "higherpair/sweep/variants.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <boost/math/special_functions/erf.hpp>

namespace higherpair {
namespace {

constexpr double kRoot2 = 1.4142135623730950488;

// The cumulative distribution function of the standard normal distribution.
double normal_share(double z) {
  return std::erfc(-z / kRoot2) / 2;
}

// An interval above the mean is mirrored, as shares near 1 have lost digits.
double truncated_normal_quantile(double low, double high, double u) {
  if (low + high > 0) {
    return -truncated_normal_quantile(-high, -low, 1 - u);
  }
  const double below = normal_share(low);
  return normal_quantile(below + u * (normal_share(high) - below));
}

double triangular_quantile(const Distribution& d, double u) {
  const double width = d.high - d.low;
  const double rise = d.mode - d.low;
  const double fall = d.high - d.mode;
  return u * width < rise ? d.low + std::sqrt(u * width * rise) : d.high - std::sqrt((1 - u) * width * fall);
}

double unclamped_quantile(const Distribution& d, double u) {
  switch (d.kind) {
    case DistributionKind::kUniform:
      break;
    case DistributionKind::kNormal:
      return d.mean + d.deviation * (d.is_truncated()
                                         ? truncated_normal_quantile((d.low - d.mean) / d.deviation,
                                                                     (d.high - d.mean) / d.deviation, u)
                                         : normal_quantile(u));
    case DistributionKind::kTriangular:
      return triangular_quantile(d, u);
    case DistributionKind::kValues: {
      const auto count = static_cast<double>(d.values.size());
      return d.values[static_cast<std::size_t>(std::min(std::floor(u * count), count - 1))];
    }
  }
  return std::lerp(d.low, d.high, u);
}

}  // namespace

bool Distribution::is_truncated() const {
  return kind == DistributionKind::kNormal && (std::isfinite(low) || std::isfinite(high));
}

double normal_quantile(double u) {
  assert(u > 0 && u < 1);
  return -kRoot2 * boost::math::erfc_inv(2 * u);
}

double quantile(const Distribution& distribution, double u) {
  assert(u > 0 && u < 1);
  // Only rounding could put it outside.
  return std::clamp(unclamped_quantile(distribution, u), distribution.low, distribution.high);
}

double share_within(const Distribution& d) {
  const double low = (d.low - d.mean) / d.deviation;
  const double high = (d.high - d.mean) / d.deviation;
  return low + high > 0 ? normal_share(-low) - normal_share(-high) : normal_share(high) - normal_share(low);
}

}  // namespace higherpair
