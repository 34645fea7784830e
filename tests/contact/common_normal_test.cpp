#include "higherpair/contact/common_normal.hpp"

#include "geometry/geometry_testing.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

// The common normal of two circles is the line of centres. Along an axis of ground one component of it is
// nearly 0 and has no relative accuracy of its own.
TEST(CommonNormal, OfCirclesLiesOnTheLineOfCentersInAnyDirection) {
  const Curve disc = make_circle(Vector2d::Zero(), 0.02).value();
  const Curve ring = make_circle(Vector2d::Zero(), 0.06, Side::kOutside).value();
  for (const double direction : {0.0, 0.5, 1.0, 1.5, 0.3}) {
    for (const double turned : {0.0, 3 * kPi / 180, kPi / 12, 1.0}) {
      for (const double guess_off : {0.0, 1e-12, 1e-9, 1e-3, 0.2}) {
        const double angle = direction * kPi;
        const Pose<double> X_W1{Rotation<double>::from_angle(turned), 0.041 * unit_vector(angle)};
        const auto at = find_common_normal(disc, X_W1, ring, Pose<double>{}, unit_vector(angle + guess_off));
        ASSERT_TRUE(at.has_value()) << direction << " " << turned << " " << guess_off;
        EXPECT_AT_MOST((at->n_W - unit_vector(angle)).norm(), 1e-14);
        EXPECT_AT_MOST(std::abs(at->gap() + 0.001), 1e-16);
      }
    }
  }
}

}  // namespace
}  // namespace higherpair
