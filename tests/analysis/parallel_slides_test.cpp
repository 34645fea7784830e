// A pin that slides on a line of a turning arm and on a fixed line. Where the lines become parallel the pin
// runs off to infinity, unless they coincide there: then the motion goes on, through a change point.
#include "run_testing.hpp"

#include <cmath>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::RunTable;
using testing::Settings;

// The arm turns about the origin, its line passes the origin at a distance of `offset` on its left, the fixed
// line is y = 0: the pin is at x = -offset / sin(driver).
RunTable pin_at(double offset, const Settings& settings) {
  return testing::analyze_text(fmt::format(R"([units]
length = "mm"
angle = "deg"
[bodies.ground]
points.O = [0, 0]
points.A = [10, 0]
[bodies.arm]
points.O = [0, 0]
points.A = [7, {:.17g}]
[bodies.block]
points.C = [0, 0]
[bodies.slider]
points.C = [0, 0]
[joints]
pivot = {{ type = "revolute", between = ["ground.O", "arm.O"] }}
radial = {{ type = "prismatic", between = ["block.C", "arm.A"], direction = 0 }}
pin = {{ type = "revolute", between = ["block.C", "slider.C"] }}
guide = {{ type = "prismatic", between = ["slider.C", "ground.A"], direction = 0 }}
[driver]
joint = "pivot"
start = 100
end = 250
velocity = 1
)",
                                           offset),
                               settings);
}

std::string changes_of(const RunTable& motion) {
  std::string text;
  for (const RunEvent& event : motion.events()) {
    if (event.type == EventType::kStrokeEnd) continue;
    text += fmt::format("{} at {:.7f} ", name_of(event.type), event.driver * 180 / kPi);
  }
  return text;
}

TEST(ParallelSlides, APinRunsOffToInfinityHoweverFewRowsLeadPastIt) {
  for (const double offset : {1e-1, 1e-3, 1e-6, 1e-9}) {
    for (const int rows : {2, 7, 62, 600}) {
      SCOPED_TRACE(fmt::format("{} mm off, {} rows", offset, rows));
      const RunTable motion = pin_at(offset, {fmt::format("driver.samples={}", rows)});
      EXPECT_EQ(changes_of(motion), "limit_position at 180.0000000 ");
      ASSERT_EQ(motion.size(), static_cast<std::size_t>(rows)) << motion.failure();
      for (std::size_t row = 0; row < motion.size(); ++row) {
        ASSERT_EQ(motion.status(row), RowStatus::kOk) << row;
        const double x = -offset / std::sin(motion.radians(row, "driver"));
        EXPECT_NEAR(motion.value(row, "slider.x"), x, 1e-12 * (1 + std::abs(x))) << row;
      }
    }
  }
}

// Next to the pole the driver's last digit decides where the pin is, and the residual is a rounding of its
// distance: on a fixed line through the origin at 33 degrees.
TEST(ParallelSlides, APinIsWhereItBelongsHoweverFarOut) {
  const double u = std::cos(33 * kPi / 180);
  const double v = std::sin(33 * kPi / 180);
  for (const double beside : {1e-2, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10}) {  // [deg]
    SCOPED_TRACE(beside);
    const RunTable motion =
        pin_at(7, {fmt::format("bodies.ground.points.A=[{:.17g}, {:.17g}]", 10 * u, 10 * v),
                   "joints.guide.direction=33", "driver.start=133", "driver.end=283",
                   fmt::format("driver.positions=[133, {:.17g}]", 213 - beside)});
    ASSERT_EQ(motion.size(), 2U) << motion.failure();
    EXPECT_EQ(motion.status(1), RowStatus::kOk);
    const double angle = motion.radians(1, "driver") - 33 * kPi / 180;
    const double x = -7 / std::sin(angle);
    const double vx = 7 * std::cos(angle) / (std::sin(angle) * std::sin(angle)) * kPi / 180;
    const double last_digits = 1e-13 / beside;
    EXPECT_NEAR(motion.value(1, "slider.x") / (x * u), 1, last_digits);
    EXPECT_NEAR(motion.value(1, "slider.y") / (x * v), 1, last_digits);
    EXPECT_NEAR(motion.value(1, "slider.vx") / (vx * u), 1, 2 * last_digits);
    EXPECT_NEAR(motion.value(1, "slider.vy") / (vx * v), 1, 2 * last_digits);
  }
}

TEST(ParallelSlides, APinStaysWhereItIsIfTheLinesCoincide) {
  for (const double offset : {0.0, 1e-16}) {
    for (const int rows : {2, 7, 16, 61, 600}) {
      SCOPED_TRACE(fmt::format("{} mm off, {} rows", offset, rows));
      const RunTable motion = pin_at(offset, {fmt::format("driver.samples={}", rows)});
      EXPECT_EQ(changes_of(motion), "dead_point at 180.0000000 ");
      EXPECT_EQ(motion.count(RowStatus::kNotAssemblable), 0U);
      for (std::size_t row = 0; row < motion.size(); ++row) {
        EXPECT_NEAR(motion.value(row, "slider.x"), 0, 1e-12) << row;
        if (motion.status(row) == RowStatus::kSingular) continue;
        EXPECT_NEAR(motion.value(row, "slider.vx"), 0, 1e-11) << row;
        EXPECT_NEAR(motion.value(row, "radial.acceleration"), 0, 1e-10) << row;
      }
    }
  }
}

// At the start any place on the line closes the loop; the one from which the motion goes on is meant.
TEST(ParallelSlides, AStartWhereTheLinesCoincideIsWhereTheMotionGoesOn) {
  for (const char* guide : {"bodies.ground.points.A=[10, 0]", "bodies.ground.points.A=[2, 0]"}) {
    const RunTable motion = pin_at(0, {"driver.start=180", guide, "driver.samples=8"});
    ASSERT_EQ(motion.size(), 8U) << motion.failure();
    EXPECT_EQ(motion.status(0), RowStatus::kSingular);
    EXPECT_EQ(motion.count(RowStatus::kOk), 7U);
    for (std::size_t row = 0; row < motion.size(); ++row) {
      EXPECT_NEAR(motion.value(row, "slider.x"), 0, 1e-12) << guide << ", row " << row;
    }
  }
}

}  // namespace
}  // namespace higherpair
