// Reactions and driving efforts that can be calculated by hand.
#include "dynamics/dynamics_testing.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "linkage/slider_crank_profile.hpp"

#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::Analysis;

constexpr double kRounding = 1e-12;  // for numbers of about 1 to 100
constexpr double kGravity = 9.81;

// A bar on ground with its centre of mass at 0.31 m; `more` is appended.
std::string bar(const std::string& more = "", const std::string& gravity = "[0, -9.81]") {
  return "gravity = " + gravity + R"(
[bodies.ground]
points.O = [0, 0]
points.S = [0.7, 0.2]
[bodies.bar]
points.O = [0, 0]
points.P = [0.53, 0]
mass = 1.7
center_of_mass = [0.31, 0]
inertia = 0.023
[joints]
pivot = { type = "revolute", between = ["ground.O", "bar.O"] }
[driver]
joint = "pivot"
)" + more;
}

TEST(Pendulum, DrivenWithAnyRateNeedsWhatNewtonAndEulerSay) {
  Analysis pendulum(bar());
  const double m = 1.7, l = 0.31, I = 0.023;
  for (const double theta : {-2.3, 0.0, 0.9, 4.1}) {
    const double omega = 3.7, alpha = -11;
    const Reactions& reactions = pendulum.at(theta, omega, alpha);
    const double c = std::cos(theta), s = std::sin(theta);
    ASSERT_TRUE(reactions.defined);
    EXPECT_NEAR(reactions.drivers[0].effort.value(), (I + m * l * l) * alpha + m * kGravity * l * c,
                kRounding);
    EXPECT_NEAR(reactions.drivers[0].by_power.value(), reactions.drivers[0].effort.value(), kRounding);
    EXPECT_NEAR(reactions.joints[0].fx.value(), -m * l * (alpha * s + omega * omega * c), kRounding * 10);
    EXPECT_NEAR(reactions.joints[0].fy.value(), m * kGravity + m * l * (alpha * c - omega * omega * s),
                kRounding * 10);
    EXPECT_FALSE(reactions.joints[0].moment);
  }
}

TEST(Pendulum, HangingAtRestNeedsNoTorque) {
  Analysis pendulum(bar());
  const Reactions& reactions = pendulum.at(-kPi / 2, 0, 0);
  EXPECT_NEAR(reactions.drivers[0].effort.value(), 0, kRounding);
  EXPECT_NEAR(reactions.joints[0].fx.value(), 0, kRounding);
  EXPECT_NEAR(reactions.joints[0].fy.value(), 1.7 * kGravity, kRounding);
}

TEST(Loads, FollowTheBodyOrStayInGround) {
  Analysis with_body(
      bar("[loads]\nf = { body = \"bar\", point = \"P\", force = [2, 5], frame = \"body\" }\n", "[0, 0]"));
  Analysis in_ground(bar("[loads]\nf = { body = \"bar\", point = \"P\", force = [2, 5] }\n", "[0, 0]"));
  Analysis torque(bar("[loads]\nt = { body = \"bar\", torque = 0.37 }\n", "[0, 0]"));
  for (const double theta : {0.4, 2.9}) {
    const double c = std::cos(theta), s = std::sin(theta);
    EXPECT_NEAR(with_body.at(theta, 0, 0).drivers[0].effort.value(), -0.53 * 5, kRounding);
    EXPECT_NEAR(in_ground.at(theta, 0, 0).drivers[0].effort.value(), -0.53 * (5 * c - 2 * s), kRounding);
    EXPECT_NEAR(torque.at(theta, 0, 0).drivers[0].effort.value(), -0.37, kRounding);
  }
}

TEST(Springs, BetweenPointsPullAlongTheirLineAndDampItsRate) {
  Analysis lever(
      bar("[springs]\ns = { between = [\"ground.S\", \"bar.P\"], stiffness = 130, free_length = "
          "0.25, damping = 7 }\n",
          "[0, 0]"));
  const double d = std::hypot(0.7, 0.2), a = 0.53;
  for (const double theta : {-0.8, 0.5, 2.2}) {
    const double beta = theta - std::atan2(0.2, 0.7);
    const double length = std::sqrt(a * a + d * d - 2 * a * d * std::cos(beta));
    const double per_angle = a * d * std::sin(beta) / length;
    const double omega = 2.6;
    const double at_rest = lever.at(theta, 0, 0).drivers[0].effort.value();
    EXPECT_NEAR(at_rest, 130 * (length - 0.25) * per_angle, kRounding * 10);
    // Centripetal forces have no moment about the pivot.
    EXPECT_NEAR(lever.at(theta, omega, 0).drivers[0].effort.value() - at_rest,
                7 * per_angle * per_angle * omega, kRounding * 10);
  }
}

TEST(Springs, OfZeroLengthHaveNoDirectionAndNoForce) {
  Analysis lever(
      bar("[springs]\ns = { between = [\"ground.O\", \"bar.O\"], stiffness = 130, free_length = "
          "0.25 }\n",
          "[0, 0]"));
  const Reactions& reactions = lever.at(0.7, 0, 0);
  ASSERT_TRUE(reactions.defined);
  EXPECT_EQ(reactions.drivers[0].effort.value(), 0);
}

TEST(Springs, OnAPivotActOnItsAngleAndAreNotPartOfItsReaction) {
  Analysis lever(bar(
      "[springs]\ns = { joint = \"pivot\", stiffness = 4.1, free_angle = 0.3, damping = 0.2 }\n", "[0, 0]"));
  const Reactions& reactions = lever.at(1.9, 0.5, 0);
  EXPECT_NEAR(reactions.drivers[0].effort.value(), 4.1 * (1.9 - 0.3) + 0.2 * 0.5, kRounding);
  EXPECT_NEAR(reactions.joints[0].fx.value(), -1.7 * 0.31 * 0.25 * std::cos(1.9), kRounding);
}

TEST(Slide, DrivenAlongAnInclineLiftsWeightInertiaSpringAndDamper) {
  const double angle = 0.6;
  Analysis slide(fmt::format(R"(gravity = [0, -9.81]
[bodies.ground]
points.O = [0, 0]
[bodies.block]
points.P = [0, 0]
points.T = [0, 0.05]
mass = 2.3
center_of_mass = [0.04, 0]
inertia = 0.1
[joints]
slide = {{ type = "prismatic", between = ["ground.O", "block.P"], direction = {} }}
[driver]
joint = "slide"
end = 1
[springs]
s = {{ joint = "slide", stiffness = 55, free_length = -0.2, damping = 3 }}
)",
                             angle));
  const double x = 0.17, v = 0.9, a = 4;
  const Reactions& reactions = slide.at(x, v, a);
  const double m = 2.3, c = std::cos(angle), s = std::sin(angle);
  EXPECT_NEAR(reactions.drivers[0].effort.value(), m * (a + kGravity * s) + 55 * (x + 0.2) + 3 * v,
              kRounding * 10);
  EXPECT_NEAR(reactions.drivers[0].by_power.value(), reactions.drivers[0].effort.value(), kRounding * 10);
  // The guide carries the weight across it. About P the weight and the inertia at 0.04 m (the block's frame
  // coincides with ground's) have the moment (0, -m g - m a s)·0.04, and the guide's forces have none.
  EXPECT_NEAR(reactions.joints[0].fx.value(), -m * kGravity * c * s, kRounding * 10);
  EXPECT_NEAR(reactions.joints[0].fy.value(), m * kGravity * c * c, kRounding * 10);
  EXPECT_NEAR(reactions.joints[0].moment.value(), m * 0.04 * (kGravity + a * s), kRounding * 10);
}

TEST(SliderCrank, HoldsAForceOnItsSliderByTheTorqueOfTheTextbook) {
  Analysis press(testing::slider_crank_profile(0.05, 0.17, "points.T = [0.02, 0.013]") + R"([driver]
joint = "main"
start = 0.4
[loads]
gas = { body = "piston", point = "T", force = [-310, 0] }
)");
  const double r = 0.05, l = 0.17, F = 310;
  for (const double theta : {0.4, 1.3, 2.8, 4.4}) {
    const Reactions& reactions = press.at(theta, 0, 0);
    const double phi = std::asin(r / l * std::sin(theta));
    const double torque = -F * r * std::sin(theta + phi) / std::cos(phi);
    EXPECT_NEAR(reactions.drivers[0].effort.value(), torque, 1e-11);
    EXPECT_NEAR(reactions.drivers[0].by_power.value(), torque, 1e-11);
    // The rod is a two-force member: it pushes the piston with F along x and -F tan φ along y.
    const JointReaction& on_piston = reactions.joints[press.joint("small_end")];
    EXPECT_NEAR(on_piston.fx.value(), F, 1e-10);
    EXPECT_NEAR(on_piston.fy.value(), -F * std::tan(phi), 1e-10);
    const JointReaction& guide = reactions.joints[press.joint("cylinder")];
    EXPECT_EQ(guide.fx.value(), 0);
    EXPECT_NEAR(guide.fy.value(), F * std::tan(phi), 1e-10);
    EXPECT_NEAR(guide.moment.value(), -F * 0.013, 1e-11);
  }
}

TEST(Slot, PushesAcrossItsLineOnly) {
  // A pin on a crank runs in the slot of a lever that a torque holds back.
  Analysis shaper(R"([bodies.ground]
points.O = [0, 0]
points.Q = [0, -0.2]
[bodies.crank]
points.O = [0, 0]
points.A = [0.06, 0]
[bodies.lever]
pose = { x = 0, y = -0.2, angle = 1.3 }
points.Q = [0, 0]
[joints]
O    = { type = "revolute", between = ["ground.O", "crank.O"] }
Q    = { type = "revolute", between = ["ground.Q", "lever.Q"] }
slot = { type = "slot", between = ["lever.Q", "crank.A"], direction = [1, 0] }
[driver]
joint = "O"
[loads]
work = { body = "lever", torque = 4.5 }
)");
  const double theta = 0.8;
  const Reactions& reactions = shaper.at(theta, 0, 0);
  const double x = 0.06 * std::cos(theta), y = 0.2 + 0.06 * std::sin(theta);
  const double distance = std::hypot(x, y);
  // The crank's pin carries 4.5 N m at that distance from Q, at right angles to the lever.
  const double force = 4.5 / distance;
  const JointReaction& slot = reactions.joints[shaper.joint("slot")];
  EXPECT_NEAR(slot.fx.value(), force * -y / distance, 1e-11);
  EXPECT_NEAR(slot.fy.value(), force * x / distance, 1e-11);
  EXPECT_FALSE(slot.moment);
  EXPECT_NEAR(reactions.drivers[0].effort.value(),
              -(0.06 * std::cos(theta) * slot.fy.value() - 0.06 * std::sin(theta) * slot.fx.value()), 1e-11);
}

// A follower on an eccentric disc with a roller of 15 mm, either fixed to it or on a pin of its own.
std::string roller_follower(bool pinned) {
  const std::string circle = "curves.c = { type = \"circle\", center = [0, 0], radius = 0.015 }\n";
  return R"(gravity = [0, -9.81]
[bodies.ground]
points.O = [0, 0]
points.G = [0.004, 0]
[bodies.cam]
points.O = [0, 0]
curves.c = { type = "circle", center = [0.01, 0], radius = 0.03 }
[bodies.follower]
pose = { x = 0.004, y = 0.044 }
points.P = [0, 0]
mass = 0.7
center_of_mass = [0.02, 0.03]
inertia = 2e-4
)" + (pinned ? "[bodies.roller]\npose = { x = 0.004, y = 0.044 }\npoints.P = [0, 0]\n" : std::string()) +
         circle +
         (pinned ? "mass = 0.1\ncenter_of_mass = [0, 0]\ninertia = 3e-5\n[joints.axle]\ntype = \"revolute\"\n"
                   "between = [\"follower.P\", \"roller.P\"]\n"
                 : std::string()) +
         R"([joints]
O     = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.G", "follower.P"], direction = [0, 1] }
[contacts.touch]
between = ["cam.c", ")" +
         (pinned ? "roller" : "follower") + ".c\"]\n[driver]\njoint = \"O\"\n";
}

TEST(Roller, OnItsOwnPinPassesTheContactForceOn) {
  Analysis pinned(roller_follower(true));
  // The same mass in the same place, on the follower itself.
  std::string text = roller_follower(false);
  const std::string mass = "mass = 0.7\ncenter_of_mass = [0.02, 0.03]";
  text.replace(text.find(mass), mass.size(), "mass = 0.8\ncenter_of_mass = [0.0175, 0.02625]");
  Analysis fixed(text);
  for (const double theta : {0.3, 2.0, 4.5}) {
    const Reactions& reactions = pinned.at(theta, 12, 3);
    const Reactions& expected = fixed.at(theta, 12, 3);
    ASSERT_TRUE(reactions.defined);
    const double N = expected.contacts[0].force.value();
    EXPECT_NEAR(reactions.contacts[0].force.value(), N, 1e-11);
    EXPECT_NEAR(reactions.drivers[0].effort.value(), expected.drivers[0].effort.value(), 1e-12);
    EXPECT_NEAR(reactions.drivers[0].by_power.value(), expected.drivers[0].effort.value(), 1e-12);
    // Balance of the roller: axle force, contact force, weight and inertia.
    const Vector2d n = pinned.run.row.contacts[0].at.n_W;
    const JointReaction& axle = reactions.joints[pinned.joint("axle")];
    EXPECT_NEAR(axle.fx.value(), -N * n.x(), 1e-11);
    EXPECT_NEAR(axle.fy.value(),
                0.1 * (kGravity + pinned.run.row.bodies[pinned.body("roller")].a_WB.y()) - N * n.y(), 1e-11);
  }
}

TEST(Unloaded, MechanismsWithoutMassHaveNoForces) {
  Analysis cam(R"([bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
curves.disc = { type = "circle", center = [0.01, 0], radius = 0.03 }
[bodies.follower]
pose = { y = 0.03 }
points.P = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = [0, -1] }
[joints]
O     = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.O", "follower.P"], direction = [0, 1] }
[contacts.touch]
between = ["cam.disc", "follower.face"]
[driver]
joint = "O"
)");
  const Reactions& reactions = cam.at(1, 20, 5);
  EXPECT_EQ(reactions.contacts[0].force.value(), 0);
  EXPECT_FALSE(reactions.opens());
  EXPECT_EQ(reactions.drivers[0].effort.value(), 0);
}

}  // namespace
}  // namespace higherpair
