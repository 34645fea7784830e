#include "drawing/outline.hpp"

#include "drawing/sketch.hpp"
#include "higherpair/geometry/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

// By the equation of the curve, which is negative in the material.
TEST(Material, OfOpenConicsBeginsOnTheCurveAndIsBehindIt) {
  for (const Side side : {Side::kInside, Side::kOutside}) {
    for (const Curve& curve :
         {*make_hyperbola({3, -2}, {4, 3}, 0.7, side), *make_parabola({-1, 5}, 2, 2.1, side)}) {
      const std::vector<double> path = material(curve, 1.5, {-6, 9});
      const std::array<double, 6> k = implicit_coefficients(curve);
      const auto F = [&](std::size_t i) {
        const double x = path[2 * i], y = path[2 * i + 1];
        return k[0] * x * x + k[1] * y * y + k[2] * x * y + k[3] * x + k[4] * y + k[5];
      };
      const std::size_t count = path.size() / 2;
      for (std::size_t i = 0; i + 2 < count; ++i) EXPECT_NEAR(F(i), 0, 1e-12);
      EXPECT_LT(std::max(F(count - 2), F(count - 1)), -1);
    }
  }
}

TEST(Wheels, OfABeltDoNotMeetWhicheverIsLarger) {
  Joint belt;
  belt.type = JointType::kBelt;
  for (const double k : {3.0, -3.0, 0.25}) {
    belt.turning_ratio = k;
    const auto [first, second] = wheel_radii(belt, 10);
    EXPECT_NEAR(first / second, std::abs(k), 1e-15);
    EXPECT_NEAR(std::max(first, second), 4, 1e-15);
  }
}

}  // namespace
}  // namespace higherpair
