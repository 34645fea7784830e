// Motions that begin at a limit, end next to one, or just touch one: the limit is found or passed in a few
// steps, whatever the rows.
#include "run_testing.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::RunTable;
using testing::Settings;

// A four-bar whose rocker and coupler are in line when the crank is at 30 degrees, to within 2e-14 rad.
constexpr double kCrankLength = 211.74772024520621, kCouplerLength = 177.78306280704766,
                 kRockerLength = 312.54698989395007;
constexpr double kFrameLength = 100;

RunTable four_bar_with(double rocker, const Settings& settings) {
  Settings all = {fmt::format("bodies.crank.points.A.0={}", kCrankLength),
                  fmt::format("bodies.coupler.points.B.0={}", kCouplerLength),
                  fmt::format("bodies.rocker.points.B.0={}", rocker)};
  all.insert(all.end(), settings.begin(), settings.end());
  return testing::analyze(testing::shipped("design_log_generator", all));
}

// The rocker's angle by the triangle of the two links and the diagonal. side: +1 on the left of the diagonal
double rocker_angle(double crank_angle, double side) {
  const testing::Complex diagonal = std::polar(kCrankLength, crank_angle) - kFrameLength;
  const double d = std::abs(diagonal);
  const double open = std::acos((kRockerLength * kRockerLength + d * d - kCouplerLength * kCouplerLength) /
                                (2 * kRockerLength * d));
  return std::arg(diagonal) + side * open;
}

int limits_in(const RunTable& motion) {
  return static_cast<int>(
      std::count_if(motion.events().begin(), motion.events().end(),
                    [](const RunEvent& event) { return event.type == EventType::kLimitPosition; }));
}

// The rocker's pose is at 60 degrees, and both branches lead away from 51.8: the run takes the one nearer to
// the pose, before the limit, at it, and at any distance beyond it.
TEST(TouchedLimits, AStartBesideALimitGoesOnTheBranchOfThePose) {
  for (const double beside :
       {-1e-12, -1e-13, 0.0, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-4}) {
    for (const int rows : {7, 13, 61}) {
      SCOPED_TRACE(fmt::format("{} degrees behind the limit, {} rows", beside, rows));
      const RunTable motion = four_bar_with(kRockerLength, {fmt::format("driver.start={:.17g}", 30 + beside),
                                                            fmt::format("driver.samples={}", rows)});
      ASSERT_EQ(motion.size(), static_cast<std::size_t>(rows)) << motion.failure();
      EXPECT_EQ(motion.count(RowStatus::kNotAssemblable), 0U);
      EXPECT_LE(limits_in(motion), 1);  // possibly the start itself
      for (std::size_t row = 1; row < motion.size(); ++row) {
        EXPECT_EQ(motion.status(row), RowStatus::kOk) << row;
        EXPECT_NEAR(motion.radians(row, "rocker.angle"), rocker_angle(motion.radians(row, "driver"), 1),
                    1e-9);
      }
      EXPECT_NEAR(motion.value(0, "rocker.angle"), 51.778, 0.02 + 100 * std::sqrt(std::abs(beside)));
    }
  }
}

// The rocker's angle stays in the turn of the pose, although the rates are unbounded at the limit.
TEST(TouchedLimits, AStartBesideALimitKeepsItsTurn) {
  const RunTable motion =
      four_bar_with(kRockerLength, {"bodies.rocker.pose.angle=-300", "bodies.coupler.pose.angle=760"});
  ASSERT_EQ(motion.size(), 13U) << motion.failure();
  EXPECT_NEAR(motion.value(0, "rocker.angle"), 51.778 - 360, 0.01);
  EXPECT_NEAR(motion.value(0, "coupler.angle"), 51.778 + 720, 0.01);
}

// Closer to the limit than a step can be judged, from the side that can be assembled.
TEST(TouchedLimits, ARowJustBeforeALimitIsReached) {
  for (const double before : {1e-9, 1e-11, 1e-12, 5e-13, 2e-13, 1e-13, 0.0}) {
    SCOPED_TRACE(before);
    const RunTable motion =
        four_bar_with(kRockerLength, {fmt::format("driver.positions=[60, {:.17g}, 31, 60]", 30 + before)});
    ASSERT_EQ(motion.size(), 4U) << motion.failure();
    EXPECT_EQ(motion.count(RowStatus::kNotAssemblable), 0U);
    EXPECT_NEAR(motion.value(1, "rocker.angle"), 51.7785, 1e-3);
    EXPECT_NEAR(motion.value(3, "rocker.angle"), motion.value(0, "rocker.angle"), 1e-10);
  }
}

// Where the rocker is as long as the coupler and the shortest diagonal together, the two limits of a gap
// merge at 0: a slightly longer rocker has a gap, a slightly shorter one none.
TEST(TouchedLimits, TwoLimitsThatFallTogetherAreFoundOrPassedWhateverTheRows) {
  for (const double off : {0.0, 1e-13, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2}) {
    for (const double sign : {1.0, -1.0}) {
      const double shortest = (kCrankLength - kFrameLength) * (1 + sign * off);
      const double gap = std::acos(
          std::min(1.0, (kCrankLength * kCrankLength + kFrameLength * kFrameLength - shortest * shortest) /
                            (2 * kFrameLength * kCrankLength)));
      for (const int rows : {7, 13, 61}) {
        SCOPED_TRACE(fmt::format("{} off, {} rows", sign * off, rows));
        const RunTable motion =
            four_bar_with(kCouplerLength + shortest,
                          {"driver.start=60", "driver.end=-60", fmt::format("driver.samples={}", rows)});
        ASSERT_EQ(motion.size(), static_cast<std::size_t>(rows)) << motion.failure();
        const bool has_gap = sign > 0 && off > 1e-13;
        std::size_t inside = 0;
        for (std::size_t row = 0; row < motion.size(); ++row) {
          inside += std::abs(motion.radians(row, "driver")) < gap ? 1 : 0;
        }
        EXPECT_EQ(motion.count(RowStatus::kNotAssemblable), has_gap ? inside : 0U);
        for (const RunEvent& event : motion.events()) {
          if (has_gap && event.type == EventType::kLimitPosition) {
            EXPECT_NEAR(std::abs(event.driver), gap, 1e-12 / gap);
          }
        }
        EXPECT_EQ(limits_in(motion), has_gap ? 2 : 0);
        EXPECT_EQ(motion.status(0), RowStatus::kOk);
        EXPECT_EQ(motion.status(motion.size() - 1), RowStatus::kOk);
      }
    }
  }
}

}  // namespace
}  // namespace higherpair
