#include "higherpair/linkage/slider_crank_stroke.hpp"

#include "linkage/linkage_testing.hpp"
#include "linkage/slider_crank.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

TEST(SliderCrankStroke, HasKnownValuesWhereTheTrianglesAreInWholeNumbers) {
  // Crank 12, coupler 25, offset 12: right triangles (37, 12, 35) and (13, 12, 5).
  const auto stroke = slider_crank_stroke({12, 25, 12, 0.2}, AssemblyMode::kPlus);
  ASSERT_TRUE(stroke);
  EXPECT_EQ(stroke->outer.r1, 35);
  EXPECT_EQ(stroke->inner.r1, 5);
  EXPECT_EQ(stroke->length, 30);
  const double outer = std::atan2(12, 35), inner = std::atan2(12, 5);
  EXPECT_AT_MOST(angle_error(stroke->outer.theta2, 0.2 + outer), 1e-15);
  EXPECT_AT_MOST(angle_error(stroke->inner.theta2, 0.2 + inner + kPi), 1e-15);
  EXPECT_AT_MOST(std::abs(stroke->turn_in - (kPi + inner - outer)), 1e-15);
  EXPECT_AT_MOST(std::abs(stroke->time_ratio - (kPi + inner - outer) / (kPi - inner + outer)), 2e-15);
  // The other mode is its mirror image.
  const auto other = slider_crank_stroke({12, 25, 12, 0.2}, AssemblyMode::kMinus);
  EXPECT_EQ(other->outer.r1, -35);
  EXPECT_EQ(other->length, 30);
  EXPECT_AT_MOST(std::abs(other->turn_in + stroke->turn_in - 2 * kPi), 2e-15);
  EXPECT_AT_MOST(std::abs(other->time_ratio - stroke->time_ratio), 2e-15);  // slow by fast, whichever is out
}

TEST(SliderCrankStroke, WithoutOffsetIsTwoCranksAndEvenInTime) {
  const auto stroke = slider_crank_stroke({0.031, 0.127, 0, 0}, AssemblyMode::kPlus);
  ASSERT_TRUE(stroke);
  EXPECT_AT_MOST(std::abs(stroke->length - 0.062), 1e-17);
  EXPECT_EQ(stroke->time_ratio, 1);
  EXPECT_EQ(stroke->turn_in, kPi);
  EXPECT_EQ(stroke->outer.theta2, 0);
  EXPECT_EQ(stroke->inner.theta2, kPi);
}

TEST(SliderCrankStroke, TheSliderStandsStillThereAndStaysBetween) {
  Random random(101);
  Worst rest, place, turn;
  int count = 0;
  for (int i = 0; i < 3000; ++i) {
    const SliderCrank linkage{random.between(0.2, 2), random.between(0.2, 3), random.between(-2, 2),
                              random.angle()};
    for (const AssemblyMode mode : kModes) {
      const auto stroke = slider_crank_stroke(linkage, mode);
      ASSERT_EQ(stroke.has_value(), slider_crank_crank_range(linkage).reach == DriverReach::kFullTurn);
      if (!stroke || linkage.r3 < 1.02 * (linkage.r2 + std::abs(linkage.r4))) continue;
      ++count;
      for (const DeadCentre& centre : {stroke->outer, stroke->inner}) {
        const auto motion = slider_crank_by_crank(linkage, {centre.theta2, 1, 0}, mode);
        rest.see(std::abs(motion.rates.value().r1_dot));
        place.see(std::abs(motion.r1 - centre.r1));
      }
      EXPECT_AT_MOST(std::abs(std::abs(stroke->outer.r1 - stroke->inner.r1) - stroke->length), 4e-15);
      turn.see(angle_error(stroke->outer.theta2 + stroke->turn_in, stroke->inner.theta2));
      const double r1 = slider_crank_by_crank(linkage, {random.angle(), 1, 0}, mode).r1;
      EXPECT_TRUE(std::abs(r1) <= std::abs(stroke->outer.r1) + 4e-15);
      EXPECT_TRUE(std::abs(r1) >= std::abs(stroke->inner.r1) - 4e-15);
    }
  }
  EXPECT_GT(count, 500);
  EXPECT_AT_MOST(rest.value(), 1e-13);
  EXPECT_AT_MOST(place.value(), 1e-14);
  EXPECT_AT_MOST(turn.value(), 2e-15);
}

TEST(SliderCrankStroke, NeedsACrankThatTurnsFully) {
  EXPECT_FALSE(slider_crank_stroke({2, 1.5, 0, 0}, AssemblyMode::kPlus));
  EXPECT_FALSE(slider_crank_stroke({0.1, 0.3, 0.2, 0}, AssemblyMode::kPlus));  // a change point
  EXPECT_TRUE(slider_crank_stroke({0.1, 0.3, 0.199, 0}, AssemblyMode::kPlus));
}

}  // namespace
}  // namespace higherpair
