#include "higherpair/linkage/angles.hpp"
#include "linkage/linkage_testing.hpp"

namespace higherpair {
namespace {

TEST(AngleRange, JoinsOrSplitsAtBothEnds) {
  const CosineLine<double> always{1, 1, 1, 0};
  const CosineLine<double> up_to_60{1, -1, -3, -2};  // 2 cos ψ - 1
  const CosineLine<double> from_30{1 - 2 / std::sqrt(3), 1, 1 + 2 / std::sqrt(3), 2 / std::sqrt(3)};
  EXPECT_EQ(angle_range(always, always, 0).reach, DriverReach::kFullTurn);

  const DriverRange middle = angle_range(up_to_60, always, 0.2);
  ASSERT_EQ(middle.count, 1);
  EXPECT_NEAR(middle.intervals[0].begin, 0.2 - kPi / 3, 1e-15);
  EXPECT_NEAR(middle.intervals[0].end, 0.2 + kPi / 3, 1e-15);

  const DriverRange far_side = angle_range(always, from_30, 0.2);
  ASSERT_EQ(far_side.count, 1);
  EXPECT_NEAR(far_side.intervals[0].begin, 0.2 + kPi / 6, 1e-15);
  EXPECT_NEAR(far_side.intervals[0].end, 0.2 + 2 * kPi - kPi / 6, 2e-15);

  const DriverRange both = angle_range(up_to_60, from_30, 3);
  ASSERT_EQ(both.count, 2);
  EXPECT_NEAR(both.intervals[0].begin, 3 - kPi / 3, 1e-15);
  EXPECT_NEAR(both.intervals[0].end, 3 - kPi / 6, 1e-15);
  EXPECT_NEAR(both.intervals[1].begin, 3 + kPi / 6 - 2 * kPi, 1e-15);
  EXPECT_NEAR(both.intervals[1].end, 3 + kPi / 3 - 2 * kPi, 2e-15);

  EXPECT_EQ(angle_range({-1, -2, -3, -1}, always, 0).reach, DriverReach::kNever);
  EXPECT_EQ(angle_range(always, {-3, -2, -1, 1}, 0).reach, DriverReach::kNever);
}

TEST(SlideRange, IsEmptyOneOrTwoIntervals) {
  EXPECT_EQ(slide_range(-1, -0.5).reach, DriverReach::kNever);
  EXPECT_EQ(slide_range(-1, 4).count, 1);
  EXPECT_EQ(slide_range(-1, 4).intervals[0].begin, -2);
  EXPECT_EQ(slide_range(0, 4).count, 1);
  const DriverRange two = slide_range(1, 4);
  ASSERT_EQ(two.count, 2);
  EXPECT_EQ(two.intervals[0].end, -1);
  EXPECT_EQ(two.intervals[1].begin, 1);
}

}  // namespace
}  // namespace higherpair
