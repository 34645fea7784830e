// A flat-faced follower on an eccentric disc, whose contact force is known in closed form:
//     N = m g + k (L - h + y) - m e ω² sin θ,  y = r + e sin θ,
// with the spring of free length L that presses down from the height h.
#include "higherpair/dynamics/contact_watch.hpp"

#include "dynamics/dynamics_testing.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::Analysis;

constexpr double kM = 0.31, kE = 0.011, kR = 0.032, kG = 9.81, kK = 830, kL = 0.083, kH = 0.107;

std::string cam(const std::string& springs, double gravity = -kG) {
  return fmt::format(R"(gravity = [0, {}]
[bodies.ground]
points.O = [0, 0]
points.S = [0, 0.107]
[bodies.cam]
points.O = [0, 0]
curves.disc = {{ type = "circle", center = [0.011, 0], radius = 0.032 }}
[bodies.follower]
pose = {{ x = 0, y = 0.032 }}
points.P = [0, 0]
curves.face = {{ type = "line", point = [0, 0], normal = [0, -1] }}
mass = 0.31
center_of_mass = [0, 0.02]
inertia = 1e-4
[joints.O]
type = "revolute"
between = ["ground.O", "cam.O"]
[joints.guide]
type = "prismatic"
between = ["ground.O", "follower.P"]
direction = [0, 1]
[contacts.touch]
between = ["cam.disc", "follower.face"]
[driver]
joint = "O"
{})",
                     gravity, springs);
}

const char* const kSpring =
    "[springs]\nback = { between = [\"follower.P\", \"ground.S\"], stiffness = 830, free_length = 0.083 }\n";

double force(double theta, double omega) {
  const double y = kR + kE * std::sin(theta);
  return kM * kG + kK * (kL - kH + y) - kM * kE * omega * omega * std::sin(theta);
}

// Runs a turn and returns where contacts opened.
std::vector<ContactOpening> turn(Analysis& analysis, ContactWatch& watch, double omega, double step = 0.1) {
  std::vector<ContactOpening> found;
  for (int k = 0; k * step < 6.3; ++k) {
    const std::vector<DriverMotion> drivers{{k * step, omega, 0}};
    const Reactions& reactions = analysis.at(drivers);
    for (const ContactOpening& opening : watch.look(analysis.run, drivers, analysis.dynamics, reactions)) {
      found.push_back(opening);
    }
  }
  return found;
}

TEST(ContactForce, OfAnEccentricDiscUnderAFlatFollowerIsTheClosedForm) {
  Analysis analysis(cam(kSpring));
  for (const double theta : {0.0, 1.1, 2.9, 5.2}) {
    const double omega = 60;
    const Reactions& reactions = analysis.at(theta, omega, 0);
    const double N = force(theta, omega);
    EXPECT_NEAR(reactions.contacts[0].force.value(), N, 1e-11);
    EXPECT_EQ(reactions.contacts[0].friction.value(), 0);
    EXPECT_NEAR(reactions.drivers[0].effort.value(), N * kE * std::cos(theta), 1e-12);
    EXPECT_NEAR(reactions.drivers[0].by_power.value(), N * kE * std::cos(theta), 1e-12);
    // The contact point runs e cos θ to the side; the guide holds against the tilting moment.
    const JointReaction& guide = reactions.joints[analysis.joint("guide")];
    EXPECT_NEAR(guide.moment.value(), -N * kE * std::cos(theta), 1e-12);
    EXPECT_NEAR(guide.fx.value(), 0, 1e-11);
  }
}

TEST(ContactWatch, FindsNothingBelowTheSpeedOfLiftOff) {
  const double lift_off = std::sqrt((kM * kG + kK * (kL - kH + kR + kE)) / (kM * kE));
  for (const double share : {0.999, 1.001}) {
    Analysis analysis(cam(kSpring));
    ContactWatch watch(analysis.run);
    EXPECT_EQ(turn(analysis, watch, share * lift_off, kPi / 36).size(), share < 1 ? 0U : 1U);
    EXPECT_EQ(watch.needs().front().opened, share > 1);
  }
}

TEST(ContactWatch, LocatesTheOpeningToTheLastDigits) {
  const double omega = 95;
  const double a = kM * kG + kK * (kL - kH + kR), b = kM * kE * omega * omega - kK * kE;
  const double root = std::asin(a / b);
  // Whatever the rows.
  for (const double step : {0.01, 0.1, 0.7}) {
    Analysis analysis(cam(kSpring));
    ContactWatch watch(analysis.run);
    const auto openings = turn(analysis, watch, omega, step);
    ASSERT_EQ(openings.size(), 1U);
    EXPECT_EQ(openings[0].kind, ContactOpening::Kind::kRoot);
    EXPECT_NEAR(openings[0].driver, root, 1e-13);
  }
}

// The force is negative for some 60 degrees about the top: between two of these rows.
TEST(ContactWatch, SeesAContactOpenAndCloseBetweenTwoRows) {
  const double omega = 95;
  const double a = kM * kG + kK * (kL - kH + kR), b = kM * kE * omega * omega - kK * kE;
  Analysis analysis(cam(kSpring));
  ContactWatch watch(analysis.run);
  const auto openings = turn(analysis, watch, omega, kPi);
  ASSERT_EQ(openings.size(), 1U);
  EXPECT_EQ(openings[0].kind, ContactOpening::Kind::kRoot);
  EXPECT_NEAR(openings[0].driver, std::asin(a / b), 1e-13);
  // Looked at every 5 degrees, the top itself among them.
  EXPECT_NEAR(watch.needs().front().smallest().value(), force(kPi / 2, omega), 1e-10);
}

TEST(ContactWatch, FindsTheOpeningGoingBackwardsAsWell) {
  const double omega = 95;
  const double a = kM * kG + kK * (kL - kH + kR), b = kM * kE * omega * omega - kK * kE;
  Analysis analysis(cam(kSpring));
  ContactWatch watch(analysis.run);
  std::vector<ContactOpening> found;
  for (const double theta : {3.0, 2.5, 2.0, 1.5}) {
    const std::vector<DriverMotion> drivers{{theta, omega, 0}};
    const Reactions& reactions = analysis.at(drivers);
    for (const ContactOpening& opening : watch.look(analysis.run, drivers, analysis.dynamics, reactions)) {
      found.push_back(opening);
    }
  }
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].driver, kPi - std::asin(a / b), 1e-13);
}

TEST(ContactWatch, SaysWhereAContactPullsFromTheStart) {
  // Weight upwards.
  Analysis analysis(cam("", kG));
  ContactWatch watch(analysis.run);
  const auto openings = turn(analysis, watch, 1);
  ASSERT_EQ(openings.size(), 1U);
  EXPECT_EQ(openings[0].kind, ContactOpening::Kind::kPulled);
  EXPECT_EQ(openings[0].driver, 0);
}

// The equivalent four-bar 80 / 20 / 60 / 40 is flat at 180 degrees, where its branches cross. There the
// contact force of a follower with a constant torque passes through infinity.
TEST(ContactWatch, TellsADeadPointFromALiftOff) {
  Analysis analysis(R"([bodies.ground]
points.O = [0, 0]
points.Q = [0.08, 0]
[bodies.cam]
points.O = [0, 0]
curves.disc = { type = "circle", center = [0.02, 0], radius = 0.035 }
[bodies.follower]
pose = { x = 0.08, y = 0, angle = -0.9 }
points.Q = [0, 0]
curves.roller = { type = "circle", center = [-0.04, 0], radius = 0.025 }
[joints.O]
type = "revolute"
between = ["ground.O", "cam.O"]
[joints.Q]
type = "revolute"
between = ["ground.Q", "follower.Q"]
[contacts.touch]
between = ["cam.disc", "follower.roller"]
[driver]
joint = "O"
start = 3.0
[loads]
twist = { body = "follower", torque = 1.3 }
)");
  ContactWatch watch(analysis.run);
  std::vector<ContactOpening> found;
  double first = 0;
  for (const double theta : {3.0, 3.1, 3.2, 3.3}) {
    const std::vector<DriverMotion> drivers{{theta, 1, 0}};
    const Reactions& reactions = analysis.at(drivers);
    ASSERT_TRUE(reactions.defined);
    first = theta == 3.0 ? reactions.contacts[0].force.value() : first;
    for (const ContactOpening& opening : watch.look(analysis.run, drivers, analysis.dynamics, reactions)) {
      found.push_back(opening);
    }
  }
  ASSERT_GT(first, 0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, ContactOpening::Kind::kPole);
  // Within the square root of rounding of the crossing the two branches are one.
  EXPECT_NEAR(found[0].driver, kPi, 1e-5);
  EXPECT_FALSE(watch.needs().front().smallest());
}

TEST(ContactWatch, TellsTheLeastPreloadOfTheSpring) {
  const double omega = 95;
  Analysis analysis(cam(kSpring));
  ContactWatch watch(analysis.run);
  (void)turn(analysis, watch, omega, kPi / 180);
  ASSERT_EQ(watch.needs().size(), 1U);
  const PreloadNeed& need = watch.needs().front();
  EXPECT_EQ(need.preload.on, Preload::On::kSpring);
  EXPECT_TRUE(need.opened);
  // Least at the top, which is a row; the spring has to push, its tension becomes less.
  ASSERT_TRUE(need.smallest());
  EXPECT_NEAR(need.smallest().value(), force(kPi / 2, omega), 1e-10);
  EXPECT_LT(need.smallest().value(), 0);
}

TEST(ContactWatch, AsksTheJointOfTheFollowerWhereThereIsNoSpring) {
  const double omega = 40;
  Analysis analysis(cam(""));
  ContactWatch watch(analysis.run);
  (void)turn(analysis, watch, omega, kPi / 180);
  const PreloadNeed& need = watch.needs().front();
  EXPECT_EQ(need.preload.on, Preload::On::kJoint);
  EXPECT_EQ(need.preload.index, static_cast<int>(analysis.joint("guide")));
  EXPECT_NEAR(need.smallest().value(), kM * (kG - kE * omega * omega), 1e-10);
}

TEST(ContactWatch, ThePreloadItNamesIsJustEnough) {
  const double omega = 95;
  const double push = -force(kPi / 2, omega);
  for (const double share : {0.999, 1.001}) {
    Analysis analysis(
        cam(fmt::format("[springs]\nback = {{ between = [\"follower.P\", \"ground.S\"], stiffness = 830, "
                        "free_length = {} }}\n",
                        kL + share * push / kK)));
    ContactWatch watch(analysis.run);
    EXPECT_EQ(turn(analysis, watch, omega, kPi / 180).size(), share < 1 ? 1U : 0U);
  }
}

TEST(PreloadNeed, IsBoundedFromBothSides) {
  PreloadNeed need;
  need.low = 2;
  EXPECT_EQ(need.smallest(), 2);
  need.high = 1;
  EXPECT_FALSE(need.smallest());
  need.low = -5;
  EXPECT_EQ(need.smallest(), 0);
  need.high = -3;
  EXPECT_EQ(need.smallest(), -3);
}

}  // namespace
}  // namespace higherpair
