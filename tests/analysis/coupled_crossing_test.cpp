// Motions in which branches of coupled bodies cross, or nearly do.
#include "driven_four_bar.hpp"
#include "run_testing.hpp"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::RunTable;
using testing::Settings;

// A change-point four-bar 30-80-50-100 driven by its coupler against its crank: three bodies move at once.
constexpr const char* kDrivenAtTheMovingPin = R"(
[bodies.ground]
points = { O = [0, 0], Q = [100, 0] }
[bodies.crank]
pose = { angle = 60 }
points = { O = [0, 0], A = [30, 0] }
[bodies.rod]
pose = { x = 15, y = 25.98, angle = 10 }
points = { A = [0, 0], B = [80, 0] }
[bodies.rocker]
pose = { x = 100, angle = 110 }
points = { Q = [0, 0], B = [50, 0] }
[joints]
o = { type = "revolute", between = ["ground.O", "crank.O"] }
a = { type = "revolute", between = ["crank.A", "rod.A"] }
b = { type = "revolute", between = ["rod.B", "rocker.B"] }
q = { type = "revolute", between = ["ground.Q", "rocker.Q"] }
[driver]
joint = "a"
start = -50
end = 310
)";

RunTable run_with(int samples, const char* rocker) {
  return testing::analyze(testing::profile_of(
      kDrivenAtTheMovingPin,
      {fmt::format("driver.samples={}", samples), fmt::format("bodies.rocker.points.B.0={}", rocker)}));
}

// Of the change-point four-bar with another rocker length; continuous over the driver's half turn.
// \param side  the side of line OQ on which B lies
double crank_angle(double driver, double rocker, double side) {
  const std::optional<double> angle = testing::crank_angle({100, 30, 80, rocker}, driver, -side);
  return angle.value_or(NAN) - (driver > kPi ? 2 * kPi : 0);
}

TEST(CoupledCrossings, ArePassedStraightOnWhateverTheRows) {
  for (const int samples : {2, 3, 7, 13, 19, 37, 361}) {
    SCOPED_TRACE(samples);
    const RunTable motion = run_with(samples, "50");
    ASSERT_EQ(motion.failure(), "");
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double driver = motion.radians(k, "driver");
      const bool crossing = motion.value(k, "driver") == 180;
      EXPECT_EQ(motion.status(k), crossing ? RowStatus::kSingular : RowStatus::kOk);
      if (!crossing) {
        EXPECT_NEAR(motion.radians(k, "crank.angle"), crank_angle(driver, 50, driver < kPi ? 1 : -1), 1e-11);
      }
    }
    int dead_points = 0;
    for (const RunEvent& event : motion.events()) {
      EXPECT_NE(event.type, EventType::kLimitPosition);
      if (event.type == EventType::kDeadPoint) {
        ++dead_points;
        EXPECT_NEAR(event.driver, kPi, 1e-11);
      }
    }
    EXPECT_EQ(dead_points, 1);
  }
}

// At a change point the poses need not be exact; the motion leaves it on the branch along which the crank
// turns more slowly.
TEST(CoupledCrossings, AreStartedAt) {
  for (const int samples : {3, 5, 361}) {
    for (const int pose : {180, 175}) {
      SCOPED_TRACE(fmt::format("{} rows, crank posed at {}", samples, pose));
      const RunTable motion = testing::analyze(testing::profile_of(
          kDrivenAtTheMovingPin,
          {"driver.start=180", "driver.end=540", fmt::format("driver.samples={}", samples),
           fmt::format("bodies.crank.pose.angle={}", pose), "bodies.rod.pose={x=-30,y=0,angle=360}",
           "bodies.rocker.pose.angle=180"}));
      ASSERT_EQ(motion.failure(), "");
      EXPECT_EQ(motion.status(0), RowStatus::kSingular);
      EXPECT_NEAR(motion.value(0, "crank.angle"), 180, 1e-10);
      for (std::size_t k = 1; k + 1 < motion.size(); ++k) {
        EXPECT_EQ(motion.status(k), RowStatus::kOk);
        const double expected = crank_angle(motion.radians(k, "driver"), 50, 1);
        EXPECT_NEAR(std::remainder(motion.radians(k, "crank.angle") - expected, 2 * kPi), 0, 1e-10) << k;
      }
    }
  }
}

// With a rocker longer by 1e-10 the links never come into line: B stays on its side.
TEST(CoupledCrossings, BranchesThatNearlyCrossAreKeptApart) {
  for (const char* rocker : {"50.00001", "50.0000001", "50.0000000001"}) {
    for (const int samples : {2, 3, 7, 13, 19, 37, 361}) {
      SCOPED_TRACE(fmt::format("{} {}", rocker, samples));
      const RunTable motion = run_with(samples, rocker);
      ASSERT_EQ(motion.failure(), "");
      EXPECT_EQ(motion.count(RowStatus::kOk), motion.size());
      for (std::size_t k = 0; k < motion.size(); ++k) {
        const double driver = motion.radians(k, "driver");
        if (std::abs(driver - kPi) > 0.01) {
          EXPECT_NEAR(motion.radians(k, "crank.angle"), crank_angle(driver, std::stod(rocker), 1), 1e-11);
        }
      }
    }
  }
}

// With a shorter rocker the links of 30 and 80 would bring B nearer to O than 100 - 49.99999, which is out of
// reach. Beyond the gap, and when the driver comes back, B is on the same side.
TEST(CoupledCrossings, BetweenTwoNearLimitsTheBranchIsLost) {
  const double nearest = 100 - 49.99999;
  const double limit = std::acos((nearest * nearest - 900 - 6400) / 4800);
  const auto expect_branch = [&](const RunTable& motion) {
    for (std::size_t k = 0; k < motion.size(); ++k) {
      const double driver = motion.radians(k, "driver");
      SCOPED_TRACE(driver);
      const bool there = std::abs(std::remainder(driver, 2 * kPi)) < limit;
      ASSERT_EQ(motion.status(k), there ? RowStatus::kOk : RowStatus::kNotAssemblable);
      if (there) {
        const double expected = crank_angle(driver, 49.99999, 1);
        EXPECT_NEAR(std::remainder(motion.radians(k, "crank.angle") - expected, 2 * kPi), 0, 1e-10);
      }
    }
  };
  for (const int samples : {2, 3, 7, 13, 19, 37, 361}) {
    SCOPED_TRACE(samples);
    const RunTable motion = run_with(samples, "49.99999");
    ASSERT_EQ(motion.failure(), "");
    std::vector<double> limits;
    for (const RunEvent& event : motion.events()) {
      if (event.type == EventType::kLimitPosition) limits.push_back(event.driver);
    }
    ASSERT_EQ(limits.size(), 2U);
    EXPECT_NEAR(limits[0], limit, 1e-11);
    EXPECT_NEAR(limits[1], 2 * kPi - limit, 1e-11);
    expect_branch(motion);
  }
  const std::vector<double> positions{-50, 170, 300, 100, 179, 181, 310, 179.9, 180, 179.97, 181, -300};
  const RunTable motion = testing::analyze(testing::profile_of(
      kDrivenAtTheMovingPin, {"bodies.rocker.points.B.0=49.99999",
                              fmt::format("driver.positions=[{}]", fmt::join(positions, ","))}));
  ASSERT_EQ(motion.size(), positions.size()) << motion.failure();
  expect_branch(motion);
}

}  // namespace
}  // namespace higherpair
