#include "difference_slope.hpp"

#include "tolerances.hpp"

#include <cmath>

namespace higherpair {

Slope slope_by_differences(const std::array<double, 5>& r, double h, double rounding) {
  Slope slope;
  const double one = (r[3] - r[1]) / (2 * h), two = (r[4] - r[0]) / (4 * h);
  const double bend = std::abs(r[3] - 2 * r[2] + r[1]), wide = std::abs(r[4] - 2 * r[2] + r[0]);
  slope.up = slope.down = (4 * one - two) / 3;
  if (std::isnan(slope.up)) {
    slope.remark = "with another value the mechanism cannot be run all the way";
    return slope;
  }
  slope.kind = SlopeKind::kDifferences;
  slope.error = std::abs(slope.up - one);
  // When the step doubles, the second difference grows fourfold for a smooth function, twofold at a kink.
  if (wide < kKinkOfDifference * 4 * bend && bend > kKinkOfSlope * h * std::abs(slope.up) + rounding) {
    slope.kind = SlopeKind::kKink;
    slope.up = (2 * (r[3] - r[2]) - (r[4] - r[2]) / 2) / h;
    slope.down = (2 * (r[2] - r[1]) - (r[2] - r[0]) / 2) / h;
  }
  return slope;
}

}  // namespace higherpair
