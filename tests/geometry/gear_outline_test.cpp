#include "higherpair/geometry/gear_outline.hpp"

#include "geometry/geometry_testing.hpp"
#include "higherpair/geometry/boundary.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kPressureAngle = 20 * kPi / 180;

GearShape shape() {
  GearShape gear;
  gear.tooth = {0.0021, 23, kPressureAngle, 0.17, 0.00011};
  gear.center_B = Vector2d(0.013, -0.007);
  gear.angle = 0.31;
  return gear;
}

TEST(GearOutline, IsOneClosedBoundaryBetweenRootAndTipCircle) {
  const GearShape gear = shape();
  const auto spans = gear_outline(gear);
  EXPECT_EQ(spans.size(), 6U * 23);
  const auto outline = Boundary::make(spans, true, 1e-12);
  ASSERT_TRUE(outline);
  EXPECT_TRUE(outline->is_closed());
  double least = 1, most = 0;
  for (const Boundary::Sample& sample : outline->samples()) {
    const double r = (sample.point.p_B - gear.center_B).norm();
    least = std::min(least, r);
    most = std::max(most, r);
  }
  const double pitch = 0.0021 * 23 / 2;
  EXPECT_NEAR(most, pitch + 1.17 * 0.0021, 1e-15);
  EXPECT_NEAR(least, pitch - (1.25 - 0.17) * 0.0021, 1e-15);
}

// On the pitch circle a tooth is as thick as half the pitch, plus 2 x m tan α for the profile shift, less the
// backlash; its middle is at the angle given by the gear.
TEST(GearOutline, HasTeethOfTheThicknessOfTheTextbook) {
  const GearShape gear = shape();
  const double pitch = 0.0021 * 23 / 2;
  const double roll = std::tan(kPressureAngle);  // where the involute crosses the pitch circle
  const auto spans = gear_outline(gear);
  for (const int tooth : {0, 7, 22}) {
    const auto at = [&](int span, double t) {
      const Vector2d p = spans[6 * tooth + span]->at(t).p_B - gear.center_B;
      EXPECT_NEAR(p.norm(), pitch, 1e-15);
      return std::atan2(p.y(), p.x());
    };
    const double right = at(1, roll);
    const double left = at(3, -roll);
    const double thickness = pitch * std::remainder(left - right, 2 * kPi);
    EXPECT_NEAR(thickness, 0.0021 * (kPi / 2 + 2 * 0.17 * std::tan(kPressureAngle)) - 0.00011, 1e-15);
    const double middle = right + std::remainder(left - right, 2 * kPi) / 2;
    EXPECT_NEAR(std::remainder(middle - 0.31 - tooth * 2 * kPi / 23, 2 * kPi), 0, 1e-13);
  }
}

// The material is inside: every normal of a tip or a root points away from the centre.
TEST(GearOutline, HasItsMaterialInside) {
  const GearShape gear = shape();
  const auto spans = gear_outline(gear);
  for (const std::size_t span : {2U, 5U, 62U, 65U}) {
    const SpanPoint point = spans[span]->at((spans[span]->range().low + spans[span]->range().high) / 2);
    const Vector2d arm = point.p_B - gear.center_B;
    EXPECT_NEAR(point.n_B.dot(arm) / arm.norm(), 1, 1e-14);
  }
}

}  // namespace
}  // namespace higherpair
