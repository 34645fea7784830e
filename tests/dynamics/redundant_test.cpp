// Mechanisms with more conditions than coordinates: what the balance determines is given, the rest is empty.
#include "dynamics/dynamics_testing.hpp"
#include "higherpair/dynamics/reactions.hpp"

#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::Analysis;

// Two friction discs, 40 and 100 mm, on fixed pivots; the second one works against a torque of 6 N m and
// weighs 3 kg.
std::string discs(double direction) {
  const double x = 0.14 * std::cos(direction), y = 0.14 * std::sin(direction);
  return fmt::format(R"(gravity = [0, -9.81]
[bodies.ground]
points.A = [0, 0]
points.B = [{}, {}]
[bodies.small]
points.A = [0, 0]
curves.c = {{ type = "circle", center = [0, 0], radius = 0.04 }}
[bodies.large]
pose = {{ x = {}, y = {}, angle = 0 }}
points.B = [0, 0]
curves.c = {{ type = "circle", center = [0, 0], radius = 0.1 }}
mass = 3
center_of_mass = [0, 0]
inertia = 0.02
[joints]
A = {{ type = "revolute", between = ["ground.A", "small.A"] }}
B = {{ type = "revolute", between = ["ground.B", "large.B"] }}
[contacts.touch]
between = ["small.c", "large.c"]
rolling = true
[driver]
joint = "A"
[loads]
lift = {{ body = "large", torque = 6 }}
)",
                     x, y, x, y);
}

TEST(Redundant, RollingDiscsHaveAFrictionForceButNoKnownNormalForce) {
  Analysis pair(discs(0));
  const double alpha = 5;
  const Reactions& reactions = pair.at(0.3, 2, alpha);
  ASSERT_TRUE(reactions.defined);
  // ω₂ = -0.4 ω₁; the friction along t = +y has a lever of -0.1 m about the large disc's pivot.
  const double alpha2 = -0.4 * alpha;
  const double friction = (6 - 0.02 * alpha2) / 0.1;
  EXPECT_NEAR(reactions.contacts[0].friction.value(), friction, 1e-11);
  EXPECT_FALSE(reactions.contacts[0].force);
  EXPECT_FALSE(reactions.contacts[0].pulls);
  EXPECT_NEAR(reactions.drivers[0].effort.value(), 0.04 * friction, 1e-12);
  EXPECT_NEAR(reactions.drivers[0].by_power.value(), 0.04 * friction, 1e-12);
  // The normal force acts along the line of pivots only, here x.
  EXPECT_FALSE(reactions.joints[0].fx);
  EXPECT_FALSE(reactions.joints[1].fx);
  EXPECT_NEAR(reactions.joints[0].fy.value(), friction, 1e-11);
  EXPECT_NEAR(reactions.joints[1].fy.value(), 3 * 9.81 - friction, 1e-11);
}

TEST(Redundant, AnInclinedLineOfPivotsLeavesBothComponentsOpen) {
  Analysis pair(discs(0.7));
  const Reactions& reactions = pair.at(0.3, 2, 0);
  ASSERT_TRUE(reactions.defined);
  EXPECT_FALSE(reactions.joints[0].fx);
  EXPECT_FALSE(reactions.joints[0].fy);
  EXPECT_NEAR(reactions.contacts[0].friction.value(), 60, 1e-10);
  EXPECT_NEAR(reactions.drivers[0].effort.value(), 2.4, 1e-12);
}

// A platform on three parallel cranks of 0.1 m, one of which is redundant.
TEST(Redundant, ParallelCranksShareTheirLoadInAnUnknownWayButTheTorqueIsKnown) {
  Analysis platform(R"(gravity = [0, -9.81]
[bodies.ground]
points.A = [0, 0]
points.B = [0.3, 0]
points.C = [0.5, 0]
[bodies.a]
points.A = [0, 0]
points.P = [0.1, 0]
[bodies.b]
pose = { x = 0.3, y = 0, angle = 0.9 }
points.B = [0, 0]
points.Q = [0.1, 0]
[bodies.c]
pose = { x = 0.5, y = 0, angle = 0.9 }
points.C = [0, 0]
points.R = [0.1, 0]
[bodies.platform]
pose = { x = 0.0621609968, y = 0.0783326910, angle = 0 }
points.P = [0, 0]
points.Q = [0.3, 0]
points.R = [0.5, 0]
mass = 4
center_of_mass = [0.21, 0.02]
inertia = 0.1
[joints]
A = { type = "revolute", between = ["ground.A", "a.A"] }
B = { type = "revolute", between = ["ground.B", "b.B"] }
C = { type = "revolute", between = ["ground.C", "c.C"] }
P = { type = "revolute", between = ["a.P", "platform.P"] }
Q = { type = "revolute", between = ["b.Q", "platform.Q"] }
R = { type = "revolute", between = ["c.R", "platform.R"] }
[driver]
joint = "A"
start = 0.9
)");
  for (const double theta : {0.9, 1.1}) {
    const double alpha = 3;
    const Reactions& reactions = platform.at(theta, 2, alpha);
    ASSERT_TRUE(reactions.defined);
    // The platform moves on a circle without rotating.
    const double torque = 4 * 9.81 * 0.1 * std::cos(theta) + 4 * 0.01 * alpha;
    EXPECT_NEAR(reactions.drivers[0].effort.value(), torque, 1e-10);
    EXPECT_NEAR(reactions.drivers[0].by_power.value(), torque, 1e-10);
    for (const JointReaction& joint : reactions.joints) {
      EXPECT_FALSE(joint.fx);
      EXPECT_FALSE(joint.fy);
    }
  }
}

// A piston in two guides, one of which would be sufficient.
TEST(Redundant, APistonInTwoGuidesMovesAndDrivesAsInOne) {
  Analysis press(R"([bodies.ground]
points.O = [0, 0]
points.G = [0, 0.4]
points.H = [0.3, 0.4]
[bodies.crank]
points.O = [0, 0]
points.P = [0.12, 0]
[bodies.rod]
pose = { x = 0.12, angle = 1.8 }
points.P = [0, 0]
points.Q = [0.45, 0]
[bodies.piston]
pose = { y = 0.45 }
points.Q = [0, 0]
points.R = [0.3, 0]
[joints]
O = { type = "revolute", between = ["ground.O", "crank.O"] }
P = { type = "revolute", between = ["crank.P", "rod.P"] }
Q = { type = "revolute", between = ["rod.Q", "piston.Q"] }
G = { type = "prismatic", between = ["ground.G", "piston.Q"], direction = [0, 1] }
H = { type = "prismatic", between = ["ground.H", "piston.R"], direction = [0, -1] }
[driver]
joint = "O"
[loads]
press = { body = "piston", point = "Q", force = [0, -100] }
)");
  for (const double theta : {0.0, 0.7, 2.5, 4.0}) {
    const Reactions& reactions = press.at(theta, 2, 0);
    ASSERT_EQ(press.run.row.status, RowStatus::kOk);
    const double c = std::cos(theta), s = std::sin(theta);
    const double along = std::sqrt(0.45 * 0.45 - 0.12 * 0.12 * c * c);
    EXPECT_NEAR(press.run.row.bodies[press.body("piston")].X_WB.p_WB.y(), 0.12 * s + along, 1e-15);
    const double rate = 0.12 * c + 0.12 * 0.12 * c * s / along;
    EXPECT_NEAR(reactions.drivers[0].effort.value(), 100 * rate, 1e-12);
    EXPECT_FALSE(reactions.joints[press.joint("G")].fx);
    EXPECT_EQ(reactions.joints[press.joint("G")].fy.value_or(-1), 0);  // no guide carries along itself
    // Everything between crank and load is determined.
    EXPECT_NEAR(reactions.joints[press.joint("Q")].fy.value(), 100, 1e-11);
  }
}

TEST(Singular, RowsHaveNoReactions) {
  // The parallelogram has all links in line at 0: its branches cross.
  Analysis loop(R"([bodies.ground]
points.A = [0, 0]
points.D = [0.2, 0]
[bodies.crank]
points.A = [0, 0]
points.B = [0.1, 0]
[bodies.coupler]
pose = { x = 0.0540302306, y = 0.0841470985 }
points.B = [0, 0]
points.C = [0.2, 0]
[bodies.rocker]
pose = { x = 0.2, y = 0, angle = 1 }
points.D = [0, 0]
points.C = [0.1, 0]
[joints]
A = { type = "revolute", between = ["ground.A", "crank.A"] }
B = { type = "revolute", between = ["crank.B", "coupler.B"] }
C = { type = "revolute", between = ["coupler.C", "rocker.C"] }
D = { type = "revolute", between = ["ground.D", "rocker.D"] }
[driver]
joint = "A"
start = 1
[loads]
twist = { body = "rocker", torque = 1 }
)");
  EXPECT_NEAR(loop.at(1, 1, 0).drivers[0].effort.value(), -1, 1e-12);
  EXPECT_NEAR(loop.at(-1, 1, 0).drivers[0].effort.value(), -1, 1e-12);
  const Reactions& flat = loop.at(0, 1, 0);
  EXPECT_EQ(loop.run.row.status, RowStatus::kSingular);
  EXPECT_FALSE(flat.defined);
  EXPECT_FALSE(flat.joints[1].fx);
  EXPECT_FALSE(flat.drivers[0].effort);
  EXPECT_FALSE(flat.drivers[0].by_power);
}

}  // namespace
}  // namespace higherpair
