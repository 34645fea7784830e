#include "difference_slope.hpp"

#include "front/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// The derivative of a smooth quantity, to fourth order.
double central_slope(const std::array<double, 5>& r, double h) {
  const double one = (r[3] - r[1]) / (2 * h), two = (r[4] - r[0]) / (4 * h);
  return (4 * one - two) / 3;
}

// \param rounding  smaller second differences of the values are rounding
Slope slope_of_step(const std::array<double, 5>& r, double h, double rounding) {
  Slope slope;
  const double bend = std::abs(r[3] - 2 * r[2] + r[1]), wide = std::abs(r[4] - 2 * r[2] + r[0]);
  slope.up = slope.down = central_slope(r, h);
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

}  // namespace

void DifferenceSlope::add(const std::array<double, 5>& values, double h, double largest) {
  Slope slope = slope_of_step(values, h, kKinkRounding * largest);
  const double size = std::max(std::abs(slope.up), std::abs(slope.down));
  needs_shorter_step_ = slope.kind != SlopeKind::kNone &&
                        slope.error > kDifferencesAgree * size + kDifferenceRounding * largest / h;
  const Slope before = std::exchange(last_, slope);
  if (needs_shorter_step_ && steps_ > 0) {
    slope.error = std::max({slope.error, std::abs(slope.up - before.up), std::abs(slope.down - before.down)});
  }
  // The error of the first step says little if there is another one.
  if (steps_ <= 1 || !needs_shorter_step_ || slope.error < best_.error) {
    best_ = slope;
  }
  ++steps_;
}

}  // namespace higherpair
