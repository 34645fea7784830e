#include "difference_slope.hpp"

#include "front/tolerances.hpp"

#include <cmath>

namespace higherpair {

double slope_beside(const std::array<double, 4>& r, double h) {
  const double one = (r[2] - r[1]) / (2 * h), two = (r[3] - r[0]) / (4 * h);
  return (4 * one - two) / 3;
}

Slope slope_by_differences(const std::array<double, 5>& r, double h, double rounding) {
  Slope slope;
  const double bend = std::abs(r[3] - 2 * r[2] + r[1]), wide = std::abs(r[4] - 2 * r[2] + r[0]);
  slope.up = slope.down = slope_beside({r[0], r[1], r[3], r[4]}, h);
  if (std::isnan(slope.up)) {
    slope.remark = "with another value the mechanism cannot be run all the way";
    return slope;
  }
  slope.kind = SlopeKind::kDifferences;
  slope.error = std::abs(slope.up - (r[3] - r[1]) / (2 * h));
  // When the step doubles, the second difference grows fourfold for a smooth function, twofold at a kink.
  if (wide < kKinkOfDifference * 4 * bend && bend > kKinkOfSlope * h * std::abs(slope.up) + rounding) {
    slope.kind = SlopeKind::kKink;
    slope.up = (2 * (r[3] - r[2]) - (r[4] - r[2]) / 2) / h;
    slope.down = (2 * (r[2] - r[1]) - (r[2] - r[0]) / 2) / h;
  }
  return slope;
}

}  // namespace higherpair
