// Reactions when the whole mechanism is scaled or moved to another place.
#include "dynamics/dynamics_testing.hpp"
#include "higherpair/dynamics/reactions.hpp"

#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::Analysis;

// An oscillating follower on an eccentric disc with all lengths times `size` and its origin at (x, y).
Analysis cam(double size, double x, double y) {
  const auto at = [&](double px, double py) { return fmt::format("[{}, {}]", x + size * px, y + size * py); };
  return Analysis(fmt::format(R"([bodies.ground]
points.O = {}
points.Q = {}
[bodies.cam]
points.O = {}
curves.disc = {{ type = "circle", center = {}, radius = {} }}
[bodies.follower]
points.Q = {}
points.P = {}
curves.roller = {{ type = "circle", center = {}, radius = {} }}
[joints]
O = {{ type = "revolute", between = ["ground.O", "cam.O"] }}
Q = {{ type = "revolute", between = ["ground.Q", "follower.Q"] }}
[contacts.touch]
between = ["cam.disc", "follower.roller"]
[driver]
joint = "O"
[loads]
push = {{ body = "follower", point = "P", force = [3, -17] }}
)",
                              at(0, 0), at(0.08, 0), at(0, 0), at(0.01, 0), 0.02 * size, at(0.08, 0),
                              at(0.05, 0.03), at(0.02, 0.033), 0.015 * size));
}

TEST(Scale, ForcesDoNotChangeAndTorquesGrowWithTheSize) {
  Analysis plain = cam(1, 0, 0);
  const Reactions expected = plain.at(0.7, 0, 0);
  for (const double size : {1e-6, 1e-3, 1e3, 1e6}) {
    Analysis scaled = cam(size, 0, 0);
    const Reactions& reactions = scaled.at(0.7, 0, 0);
    EXPECT_NEAR(reactions.contacts[0].force.value(), expected.contacts[0].force.value(), 1e-11);
    EXPECT_NEAR(reactions.joints[1].fx.value(), expected.joints[1].fx.value(), 1e-11);
    EXPECT_NEAR(reactions.drivers[0].effort.value(), size * expected.drivers[0].effort.value(), 1e-12 * size);
    EXPECT_NEAR(reactions.drivers[0].by_power.value(), size * expected.drivers[0].effort.value(),
                1e-12 * size);
  }
}

TEST(Scale, PlaceMeansNothingButDigits) {
  Analysis plain = cam(1, 0, 0);
  const Reactions expected = plain.at(0.7, 0, 0);
  // A hundred sizes away every lever arm has lost two of its sixteen digits.
  Analysis moved = cam(1, 7, -5);
  const Reactions& reactions = moved.at(0.7, 0, 0);
  EXPECT_NEAR(reactions.contacts[0].force.value(), expected.contacts[0].force.value(), 1e-9);
  EXPECT_NEAR(reactions.drivers[0].effort.value(), expected.drivers[0].effort.value(), 1e-10);
}

}  // namespace
}  // namespace higherpair
