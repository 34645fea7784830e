// At the start a body that only a rolling contact turns has the angle of its pose, in whatever order the file
// names its joints, contacts and bodies.
#include "geometry/geometry_testing.hpp"
#include "run_testing.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::RunTable;

// "a", "b" or the other way round.
std::string pair_of(const char* a, const char* b, bool exchanged) {
  return exchanged ? fmt::format(R"(["{}", "{}"])", b, a) : fmt::format(R"(["{}", "{}"])", a, b);
}

// A disc of 15 mm, `off` mm off its pin, at the end of an arm or on a slide, rolls on a disc cam of 20 mm
// whose centre is at (5, 0) when the driver is at 0.
std::string roller_profile(bool on_slide, unsigned order, double off) {
  const std::string guide =
      on_slide
          ? R"({ type = "prismatic", between = ["ground.A", "arm.P"], direction = 90 })"
          : fmt::format(R"({{ type = "revolute", between = {} }})", pair_of("ground.B", "arm.O", order & 4U));
  const std::string bodies[] = {fmt::format(R"(
[bodies.arm]
pose = {}
points.O = [0, 0]
points.P = {}
)",
                                            on_slide ? "{ x = 0, y = 38 }" : "{ x = 80, y = 0, angle = -30 }",
                                            on_slide ? "[0, 0]" : "[-60, 0]"),
                                fmt::format(R"(
[bodies.roller]
pose = {{ x = {}, angle = 50 }}
points.O = [0, 0]
curves.k = {{ type = "circle", center = [{}, 0], radius = 15 }}
)",
                                            on_slide ? "0, y = 38" : "28, y = 30", off)};
  return fmt::format(R"(
[bodies.ground]
points.A = [0, 0]
points.B = [80, 0]
[bodies.cam]
points.O = [0, 0]
curves.k = {{ type = "circle", center = [5, 0], radius = 20 }}
{}{}
[joints]
main  = {{ type = "revolute", between = ["ground.A", "cam.O"] }}
guide = {}
pin   = {{ type = "revolute", between = {} }}
[contacts.k]
between = {}
rolling = true
[driver]
joint = "main"
samples = 5
)",
                     bodies[order & 8U ? 1 : 0], bodies[order & 8U ? 0 : 1], guide,
                     pair_of("arm.P", "roller.O", order & 1U), pair_of("cam.k", "roller.k", order & 2U));
}

TEST(RollingPhase, OfARollerIsThatOfItsPoseInWhateverOrderItsPinAndContactAreNamed) {
  const std::complex<double> cam_center(5, 0);
  for (const bool on_slide : {false, true}) {
    for (const double off : {0.0, 1e-9, 0.02, 0.5, 3.0}) {
      for (unsigned order = 0; order < 16; ++order) {
        SCOPED_TRACE(fmt::format("slide {} off {} order {}", on_slide, off, order));
        const RunTable motion = testing::analyze(testing::profile_of(roller_profile(on_slide, order, off)));
        ASSERT_EQ(motion.count(RowStatus::kOk), 5U) << motion.failure();
        EXPECT_NEAR(motion.value(0, "roller.angle"), 50, 1e-12);
        for (std::size_t k = 0; k < motion.size(); ++k) {
          const std::complex<double> center =
              motion.vector(k, "roller.") + std::polar(off, motion.radians(k, "roller.angle"));
          const std::complex<double> turned = cam_center * std::polar(1.0, motion.radians(k, "driver"));
          EXPECT_NEAR(std::abs(center - turned), 35, 1e-11);
        }
      }
    }
  }
}

// Two rollers one after the other, the second on the first; and a wheel on a floor at the end of a rod.
TEST(RollingPhase, IsThatOfItsPoseForEveryRollerOfAChain) {
  for (unsigned order = 0; order < 16; ++order) {
    SCOPED_TRACE(order);
    const RunTable motion = testing::analyze(testing::profile_of(fmt::format(
        R"(
[bodies.ground]
points.A = [0, 0]
points.B = [80, 0]
points.C = [100, 60]
[bodies.cam]
points.O = [0, 0]
curves.k = {{ type = "circle", center = [5, 0], radius = 20 }}
[bodies.arm]
pose = {{ x = 80, y = 0, angle = -28 }}
points.O = [0, 0]
points.P = [-60, 0]
[bodies.roller]
pose = {{ x = 28, y = 29, angle = 50 }}
points.O = [0, 0]
curves.k = {{ type = "circle", center = [3, 0], radius = 15 }}
[bodies.arm2]
pose = {{ x = 100, y = 60, angle = 0 }}
points.O = [0, 0]
points.P = [-55, 0]
[bodies.roller2]
pose = {{ x = 45, y = 60, angle = -70 }}
points.O = [0, 0]
curves.k = {{ type = "circle", center = [2, 0], radius = 20 }}
[joints]
main   = {{ type = "revolute", between = ["ground.A", "cam.O"] }}
pivot  = {{ type = "revolute", between = ["ground.B", "arm.O"] }}
pin    = {{ type = "revolute", between = {} }}
pivot2 = {{ type = "revolute", between = ["ground.C", "arm2.O"] }}
pin2   = {{ type = "revolute", between = {} }}
[contacts]
k  = {{ between = {}, rolling = true }}
k2 = {{ between = {}, rolling = true }}
[driver]
joint = "main"
samples = 3
)",
        pair_of("arm.P", "roller.O", order & 1U), pair_of("arm2.P", "roller2.O", order & 2U),
        pair_of("cam.k", "roller.k", order & 4U), pair_of("roller.k", "roller2.k", order & 8U))));
    ASSERT_EQ(motion.count(RowStatus::kOk), 3U) << motion.failure();
    EXPECT_NEAR(motion.value(0, "roller.angle"), 50, 1e-12);
    EXPECT_NEAR(motion.value(0, "roller2.angle"), -70, 1e-12);
    const auto center = [&](const std::string& body, double off) {
      return motion.vector(0, body + ".") + std::polar(off, motion.radians(0, body + ".angle"));
    };
    EXPECT_NEAR(std::abs(center("roller", 3) - std::complex<double>(5, 0)), 35, 1e-11);
    EXPECT_NEAR(std::abs(center("roller2", 2) - center("roller", 3)), 35, 1e-11);
  }
}

TEST(RollingPhase, OfAWheelOnAFloorIsThatOfItsPose) {
  for (unsigned order = 0; order < 8; ++order) {
    SCOPED_TRACE(order);
    const RunTable motion = testing::analyze(testing::profile_of(fmt::format(
        R"(
[bodies.ground]
points.A = [0, 60]
curves.floor = {{ type = "line", point = [0, 0], normal = 90 }}
[bodies.crank]
pose = {{ x = 0, y = 60 }}
points.O = [0, 0]
points.P = [20, 0]
[bodies.rod]
pose = {{ x = 20, y = 60, angle = -25 }}
points.P = [0, 0]
points.Q = [90, 0]
[bodies.wheel]
pose = {{ x = 102, y = 22, angle = 40 }}
points.O = [0, 0]
curves.k = {{ type = "circle", center = [3, 0], radius = 20 }}
[joints]
main = {{ type = "revolute", between = ["ground.A", "crank.O"] }}
a    = {{ type = "revolute", between = {} }}
b    = {{ type = "revolute", between = {} }}
[contacts]
k = {{ between = {}, rolling = true }}
[driver]
joint = "main"
samples = 3
)",
        pair_of("crank.P", "rod.P", order & 1U), pair_of("rod.Q", "wheel.O", order & 2U),
        pair_of("ground.floor", "wheel.k", order & 4U))));
    ASSERT_EQ(motion.count(RowStatus::kOk), 3U) << motion.failure();
    EXPECT_NEAR(motion.value(0, "wheel.angle"), 40, 1e-12);
    EXPECT_NEAR(motion.value(0, "wheel.O.y") + 3 * std::sin(40 * kPi / 180), 20, 1e-11);
  }
}

}  // namespace
}  // namespace higherpair
