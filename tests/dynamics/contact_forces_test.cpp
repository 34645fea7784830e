// A flat-faced follower on an eccentric disc, whose contact force is known in closed form:
//     N = m g + k (L - h + y) - c v - m e ω² sin θ,  y = r + e sin θ,  v = e ω cos θ,
// with the spring of free length L and damping c that presses down from the height h.
#include "higherpair/dynamics/contact_forces.hpp"

#include "dynamics/dynamics_testing.hpp"
#include "higherpair/dynamics/reactions.hpp"

#include <cmath>
#include <optional>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::Analysis;

constexpr double kM = 0.31, kE = 0.011, kR = 0.032, kG = 9.81, kK = 830, kL = 0.083, kH = 0.107;

// A cam that turns lifts a follower.
const char* const kJoints = R"([joints.O]
type = "revolute"
between = ["ground.O", "cam.O"]
[joints.guide]
type = "prismatic"
between = ["ground.O", "follower.P"]
direction = [0, 1]
)";

// All lengths are multiplied by `size`; the spring keeps its force in newtons.
std::string cam(const std::string& springs, double gravity = -kG, double size = 1) {
  return fmt::format(R"(gravity = [0, {}]
[bodies.ground]
points.O = [0, 0]
points.S = [0, {}]
[bodies.cam]
points.O = [0, 0]
curves.disc = {{ type = "circle", center = [{}, 0], radius = {} }}
[bodies.follower]
pose = {{ x = 0, y = {} }}
points.P = [0, 0]
curves.face = {{ type = "line", point = [0, 0], normal = [0, -1] }}
mass = 0.31
center_of_mass = [0, {}]
inertia = 1e-4
{}[contacts.touch]
between = ["cam.disc", "follower.face"]
[driver]
joint = "O"
{})",
                     gravity, kH * size, kE * size, kR * size, kR * size, 0.02 * size, kJoints, springs);
}

const char* const kSpring =
    "[springs]\nback = { between = [\"follower.P\", \"ground.S\"], stiffness = 830, free_length = 0.083 }\n";

double force(double theta, double omega) {
  const double y = kR + kE * std::sin(theta);
  return kM * kG + kK * (kL - kH + y) - kM * kE * omega * omega * std::sin(theta);
}

// The angle at which N = a - b sin θ first passes through 0.
double opening(double omega) {
  const double a = kM * kG + kK * (kL - kH + kR), b = kM * kE * omega * omega - kK * kE;
  return std::asin(a / b);
}

ContactForces follow(const Analysis& analysis, double from, double to, double omega) {
  return follow_contact_forces(analysis.run, straight_path({{from, omega, 0}}, {{to, omega, 0}}),
                               preloads_of(analysis.run.mechanism(), analysis.run.plan()));
}

std::optional<std::vector<double>> smallest(const Analysis& analysis, const ContactForces& forces) {
  return smallest_preloads(forces, analysis.run.mechanism(), analysis.run.plan().size);
}

// The smallest force among all contacts, in the motion of `text`.
double lowest_of(const std::string& text, double from, double to, double omega) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& one : follow(Analysis(text), from, to, omega).lowest) {
    lowest = std::min(lowest, one.value().force);
  }
  return lowest;
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
    // The contact point is e cos θ off the centre; the guide carries the tilting moment.
    const JointReaction& guide = reactions.joints[analysis.joint("guide")];
    EXPECT_NEAR(guide.moment.value(), -N * kE * std::cos(theta), 1e-12);
    EXPECT_NEAR(guide.fx.value(), 0, 1e-11);
  }
}

TEST(ContactOpening, IsFoundAboveTheSpeedOfLiftOffAndNotBelow) {
  const double lift_off = std::sqrt((kM * kG + kK * (kL - kH + kR + kE)) / (kM * kE));
  const Analysis analysis(cam(kSpring));
  for (const double share : {0.999, 1 - 1e-9, 1 + 1e-9, 1.001}) {
    EXPECT_EQ(follow(analysis, 0, 2 * kPi, share * lift_off).openings.size(), share < 1 ? 0U : 1U) << share;
  }
}

TEST(ContactOpening, IsTheRootOfTheForceToTheLastDigits) {
  const double omega = 95;
  const Analysis analysis(cam(kSpring));
  for (const double to : {1.2, kPi, 2 * kPi, 6.7}) {
    const auto openings = follow(analysis, 0, to, omega).openings;
    ASSERT_EQ(openings.size(), 1U);
    EXPECT_EQ(openings[0].kind, ContactOpening::Kind::kRoot);
    EXPECT_EQ(openings[0].contact, 0U);
    EXPECT_NEAR(openings[0].driver, opening(omega), 1e-14);
    EXPECT_NEAR(openings[0].at * to, opening(omega), 1e-14);
  }
}

// The force is negative for a ten-thousandth of a radian.
TEST(ContactOpening, IsFoundHoweverShortItIs) {
  for (const double width : {1e-2, 1e-4}) {
    const double a = kM * kG + kK * (kL - kH + kR);
    const double omega = std::sqrt((a / std::cos(width / 2) + kK * kE) / (kM * kE));
    const Analysis analysis(cam(kSpring));
    const auto openings = follow(analysis, 0.1, 7, omega).openings;
    ASSERT_EQ(openings.size(), 1U);
    EXPECT_NEAR(openings[0].driver, kPi / 2 - width / 2, 1e-14 / width);
  }
}

TEST(ContactOpening, IsFoundInEveryTurnAndGoingBackwards) {
  const double omega = 95;
  const Analysis analysis(cam(kSpring));
  const auto turns = follow(analysis, 0, 10 * kPi, omega).openings;
  ASSERT_EQ(turns.size(), 5U);
  for (std::size_t k = 0; k < turns.size(); ++k) {
    EXPECT_NEAR(turns[k].driver, opening(omega) + 2 * kPi * static_cast<double>(k), 1e-13);
  }
  const auto back = follow(analysis, 0, -2 * kPi, omega).openings;
  ASSERT_EQ(back.size(), 1U);
  EXPECT_NEAR(back[0].driver, -kPi - opening(omega), 1e-14);
}

TEST(ContactOpening, DependsOnTheSpeedOfEveryPosition) {
  // ω grows in proportion to θ from 0 to 250 rad/s over one turn.
  const Analysis analysis(cam(kSpring));
  const auto forces = follow_contact_forces(analysis.run, straight_path({{0, 0, 0}}, {{2 * kPi, 250, 0}}));
  ASSERT_FALSE(forces.openings.empty());
  const double theta = forces.openings[0].driver;
  EXPECT_NEAR(force(theta, 125 * theta / kPi), 0, 1e-11);
  EXPECT_GT(force(theta - 1e-3, 125 * (theta - 1e-3) / kPi), 0);
}

TEST(ContactOpening, TakesWhatDampersDo) {
  const double c = 3.7, omega = 70;
  const Analysis analysis(cam(
      "[springs]\nback = { between = [\"follower.P\", \"ground.S\"], stiffness = 830, free_length = 0.083, "
      "damping = 3.7 }\n"));
  // N = a - b sin θ + d cos θ = a - sqrt(b² + d²) sin(θ - atan(d/b)): the damper presses while it is being
  // compressed.
  const double a = kM * kG + kK * (kL - kH + kR), b = kM * kE * omega * omega - kK * kE, d = c * kE * omega;
  const auto forces = follow(analysis, 0, 2 * kPi, omega);
  EXPECT_NEAR(forces.lowest[0].value().force, a - std::hypot(b, d), 1e-12);
  EXPECT_NEAR(forces.lowest[0].value().driver, kPi / 2 + std::atan2(d, b), 1e-11);
  EXPECT_FALSE(highest_speed(forces));
}

TEST(ContactOpening, CountsFromTheStartWhereTheContactPullsThere) {
  // The weight acts upwards.
  for (const double to : {0.0, 2 * kPi}) {
    const auto openings = follow(Analysis(cam("", kG)), 0, to, 1).openings;
    ASSERT_EQ(openings.size(), 1U);
    EXPECT_EQ(openings[0].kind, ContactOpening::Kind::kPulled);
    EXPECT_EQ(openings[0].driver, 0);
  }
}

TEST(ContactOpening, IsNoneWhereNothingActs) {
  // No weight, and no motion, hence no inertia.
  const auto forces = follow(Analysis(cam("", 0)), 0, 2 * kPi, 0);
  EXPECT_TRUE(forces.openings.empty());
  EXPECT_EQ(forces.lowest[0].value().force, 0);
}

TEST(LowestForce, IsThatOfTheTopAndItsFirstPosition) {
  const double omega = 95;
  const Analysis analysis(cam(kSpring));
  const auto lowest = follow(analysis, 0, 6 * kPi, omega).lowest[0].value();
  EXPECT_NEAR(lowest.force, force(kPi / 2, omega), 1e-13);
  EXPECT_NEAR(lowest.driver, kPi / 2, 1e-12);
  EXPECT_NEAR(lowest.at, kPi / 2 / (6 * kPi), 1e-13);
  // At an end of the path.
  EXPECT_NEAR(follow(analysis, 0, 1, omega).lowest[0].value().driver, 1, 1e-15);
  EXPECT_NEAR(follow(analysis, 0, 1, omega).lowest[0].value().force, force(1, omega), 1e-12);
}

TEST(ContactForces, FollowTheSizeOfTheMechanism) {
  const double omega = 95;
  for (const double size : {1e-6, 1e-3, 1e3, 1e6}) {
    // Forces are the same if stiffness and gravity scale with the size and the mass with 1/size.
    const std::string springs = fmt::format(
        "[springs]\nback = {{ between = [\"follower.P\", \"ground.S\"], stiffness = {}, free_length = {} "
        "}}\n",
        kK / size, kL * size);
    std::string text = cam(springs, -kG * size, size);
    text.replace(text.find("mass = 0.31"), 11, fmt::format("mass = {}", kM / size));
    const Analysis analysis(text);
    const auto forces = follow(analysis, 0, 2 * kPi, omega);
    ASSERT_EQ(forces.openings.size(), 1U) << size;
    EXPECT_NEAR(forces.openings[0].driver, opening(omega), 1e-13);
    EXPECT_NEAR(forces.lowest[0].value().force, force(kPi / 2, omega), 1e-11);
    EXPECT_NEAR(smallest(analysis, forces).value().at(0), force(kPi / 2, omega), 1e-11);
  }
}

TEST(ContactForces, OfAMirroredMechanismAreThoseOfTheMechanismTurnedTheOtherWay) {
  // Mirrored at the vertical: θ -> π - θ.
  std::string text = cam(kSpring);
  text.replace(text.find("center = [0.011, 0]"), 19, "center = [-0.011, 0]");
  const double omega = 95;
  const auto forces = follow(Analysis(text), 0, -2 * kPi, -omega);
  ASSERT_EQ(forces.openings.size(), 1U);
  EXPECT_NEAR(forces.openings[0].driver, -opening(omega), 1e-14);
}

// A centred ellipse under a flat face: y = sqrt(a² sin² + b² cos²), with two lifts per turn.
TEST(ContactForces, OfAnEllipseOpenTwiceATurn) {
  std::string text = cam("");
  const std::string disc = R"({ type = "circle", center = [0.011, 0], radius = 0.032 })";
  text.replace(text.find(disc), disc.size(),
               R"({ type = "ellipse", center = [0, 0], semi_axes = [0.043, 0.032] })");
  const double a = 0.043, b = 0.032, omega = 38;
  const auto N = [&](double theta) {
    const double s = std::sin(theta), c = std::cos(theta);
    const double y = std::hypot(a * s, b * c), d = a * a - b * b;
    const double acceleration = (d * (c * c - s * s) - (d * s * c / y) * (d * s * c / y)) / y;
    return kM * (kG + acceleration * omega * omega);
  };
  const auto forces = follow(Analysis(text), 0, 2 * kPi, omega);
  ASSERT_EQ(forces.openings.size(), 2U);
  for (const ContactOpening& one : forces.openings) {
    EXPECT_NEAR(N(one.driver), 0, 1e-12);
    EXPECT_GT(N(one.driver - 1e-3), 0);
  }
  EXPECT_NEAR(forces.openings[1].driver - forces.openings[0].driver, kPi, 1e-13);
  EXPECT_NEAR(forces.lowest[0].value().force, N(kPi / 2), 1e-12);
  EXPECT_NEAR(highest_speed(forces).value() * omega, std::sqrt(kG * a / (a * a - b * b)), 1e-10);
}

// The equivalent four-bar 80 / 20 / 60 / 40 has all links in line at 180 degrees, where its branches cross.
// There the contact force of a follower with a constant torque passes through infinity.
TEST(ContactOpening, AtADeadPointIsNoLiftOff) {
  const Analysis analysis(R"([bodies.ground]
points.O = [0, 0]
points.Q = [0.08, 0]
[bodies.cam]
points.O = [0, 0]
curves.disc = { type = "circle", center = [0.02, 0], radius = 0.035 }
[bodies.follower]
pose = { x = 0.08, y = 0, angle = -0.9 }
points.Q = [0, 0]
curves.roller = { type = "circle", center = [-0.04, 0], radius = 0.025 }
[joints]
O = { type = "revolute", between = ["ground.O", "cam.O"] }
Q = { type = "revolute", between = ["ground.Q", "follower.Q"] }
[contacts.touch]
between = ["cam.disc", "follower.roller"]
[driver]
joint = "O"
start = 2.9
[loads]
twist = { body = "follower", torque = 1.3 }
)");
  const auto forces = follow(analysis, 2.9, 3.5, 1);
  ASSERT_EQ(forces.openings.size(), 1U);
  EXPECT_EQ(forces.openings[0].kind, ContactOpening::Kind::kPole);
  // Within the square root of rounding from the crossing the two branches cannot be distinguished.
  EXPECT_NEAR(forces.openings[0].driver, kPi, 1e-5);
  EXPECT_EQ(highest_speed(forces), 0);  // beyond it the torque pulls at rest already
}

// Two discs that lock at the angle where the crank 50 and the coupler 35 + 40 come into line; before that the
// acceleration of the follower grows as d^(-3/2) with the distance d from the limit.
constexpr const char* kLockUp = R"([bodies.ground]
points.O = [0, 0]
points.Q = [0.08, 0]
[bodies.cam]
points.O = [0, 0]
curves.disc = { type = "circle", center = [0.05, 0], radius = 0.02 }
[bodies.follower]
pose = { x = 0.08, y = 0, angle = -1.01 }
points.Q = [0, 0]
curves.disc = { type = "circle", center = [-0.04, 0], radius = 0.015 }
mass = 0.2
center_of_mass = [-0.02, 0]
inertia = 3e-5
[joints]
O = { type = "revolute", between = ["ground.O", "cam.O"] }
Q = { type = "revolute", between = ["ground.Q", "follower.Q"] }
[contacts.touch]
between = ["cam.disc", "follower.disc"]
[driver]
joint = "O"
[loads]
twist = { body = "follower", torque = {} }
)";

TEST(ContactOpening, IsFoundShortlyBeforeALimitWhateverLiesBeyond) {
  const double limit = std::acos((0.05 * 0.05 + 0.08 * 0.08 - 0.075 * 0.075) / (2 * 0.05 * 0.08));
  for (const double torque : {-2.0, 2.0}) {
    std::string text = kLockUp;
    text.replace(text.find("{}"), 2, std::to_string(torque));
    std::vector<double> found;
    for (const double to : {limit - 1e-5, limit + 0.2, 3.0}) {
      for (const ContactOpening& one : follow(Analysis(text), 0.3, to, 3).openings) {
        EXPECT_LT(one.driver, limit);
        found.push_back(one.driver);
        Analysis analysis(text);
        const double scale = std::abs(analysis.at(0.3, 3, 0).contacts[0].force.value());
        const auto force_at = [&](double theta) {
          return analysis.at(theta, 3, 0).contacts[0].force.value();
        };
        const double d = limit - one.driver;
        if (one.kind == ContactOpening::Kind::kPulled) {
          EXPECT_EQ(one.driver, 0.3);
          EXPECT_LT(force_at(0.3), 0);
          continue;
        }
        EXPECT_GT(force_at(one.driver - 1e-6 * d), -1e-8 * scale);
        EXPECT_LT(force_at(one.driver + 1e-6 * d), 1e-8 * scale);
      }
    }
    for (const double one : found) {
      EXPECT_NEAR(one, found.front(), 1e-12);
    }
    // Inertia is unbounded towards the limit: no preload is sufficient, and no speed is known to be.
    const Analysis analysis(text);
    const auto forces = follow(analysis, 0.3, 3.0, 3);
    EXPECT_FALSE(smallest(analysis, forces));
    const bool pulls_at_rest = found.at(0) == 0.3;
    EXPECT_EQ(highest_speed(forces), pulls_at_rest ? std::optional(0.0) : std::nullopt);
  }
}

TEST(SmallestPreloads, OfASpringAreTheForceThatIsMissing) {
  const double omega = 95;
  const Analysis analysis(cam(kSpring));
  const auto forces = follow(analysis, 0.3, 4, omega);
  ASSERT_EQ(forces.preloads.size(), 1U);
  EXPECT_EQ(forces.preloads[0].on, Preload::On::kSpring);
  // This spring pushes: more contact force needs less tension.
  EXPECT_NEAR(smallest(analysis, forces).value().at(0), force(kPi / 2, omega), 1e-12);
}

// A cam lifts a sprung roller; `curve` is its outline.
std::string sprung_roller(const std::string& curve, const std::string& more = "") {
  return fmt::format(R"(gravity = [0, -9.81]
[bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
curves.outline = {}
[bodies.follower]
pose = {{ x = 0, y = 0.047 }}
points.P = [0, 0]
curves.roller = {{ type = "circle", center = [0, 0], radius = 0.009 }}
mass = 0.31
center_of_mass = [0, 0.02]
{}[contacts.touch]
between = ["cam.outline", "follower.roller"]
[driver]
joint = "O"
[springs]
back = {{ joint = "guide", stiffness = 530, free_length = 0.055 }}
{})",
                     curve, kJoints, more);
}

// Dwells, and joins at which the jerk of the law jumps.
std::string dwelling_roller(const char* rise, const char* fall) {
  return sprung_roller(R"({ type = "cam", law = "lift", contact = "touch" })", fmt::format(R"([laws.lift]
segments = [ {{ over = "37 deg", law = "dwell" }},
  {{ over = "103 deg", law = "{}", rise = 0.013 }}, {{ over = "41 deg", law = "dwell" }},
  {{ over = "91 deg", law = "{}", rise = -0.013 }}, {{ over = "88 deg", law = "dwell" }} ]
)",
                                                                                           rise, fall));
}

TEST(LowestForce, InADwellIsThatOfTheDwell) {
  const double rest = kM * kG + 530 * (0.047 - 0.055);
  for (const char* const rise : {"cycloidal", "modified-sine", "polynomial-345"}) {
    for (const char* const fall : {"modified-trapezoid", "polynomial-345"}) {
      const Analysis analysis(dwelling_roller(rise, fall));
      const auto forces = follow(analysis, 0, 2 * kPi, 20);
      EXPECT_NEAR(forces.lowest[0].value().force, rest, 1e-10) << rise << ' ' << fall;
      EXPECT_NEAR(smallest(analysis, forces).value_or(std::vector<double>{0}).at(0), -rest, 1e-10)
          << rise << ' ' << fall;
      for (const ForcePiece& piece : forces.pieces) {
        EXPECT_FALSE(piece.singular_from || piece.singular_to) << rise << ' ' << fall;
      }
    }
  }
}

// Nothing is left out at the points of the spline, where the slopes of forces jump.
TEST(ContactForces, OfASplineOfTheThirdDegreeAreResolvedBetweenItsPoints) {
  std::string points;
  for (int k = 0; k < 180; ++k) {
    const double u = k * 2 * kPi / 180, r = 0.024 + 0.004 * std::cos(u) + 0.0015 * std::cos(2 * u);
    points += fmt::format("{}[{:.17g}, {:.17g}]", k == 0 ? "" : ", ", r * std::cos(u), r * std::sin(u));
  }
  const Analysis analysis(sprung_roller("{ type = \"spline\", degree = 3, points = [" + points + "] }"));
  const auto forces = follow(analysis, 0, 2 * kPi, 10);
  for (const ForcePiece& piece : forces.pieces) {
    EXPECT_FALSE(piece.singular_from || piece.singular_to);
  }
  const double lowest = forces.lowest[0].value().force;
  EXPECT_LT(lowest, -10);
  EXPECT_NEAR(smallest(analysis, forces).value_or(std::vector<double>{0}).at(0), -lowest, 2e-3);
}

TEST(SmallestPreloads, ActOnTheJointOfTheFollowerWhereThereIsNoSpring) {
  const double omega = 40;
  const Analysis analysis(cam(""));
  const auto forces = follow(analysis, 0, 2 * kPi, omega);
  ASSERT_EQ(forces.preloads.size(), 1U);
  EXPECT_EQ(forces.preloads[0].on, Preload::On::kJoint);
  EXPECT_EQ(forces.preloads[0].index, static_cast<int>(analysis.joint("guide")));
  EXPECT_NEAR(smallest(analysis, forces).value().at(0), kM * (kG - kE * omega * omega), 1e-12);
}

TEST(SmallestPreloads, AreZeroWhereNothingOpens) {
  const Analysis analysis(cam(kSpring));
  EXPECT_EQ(smallest(analysis, follow(analysis, 0, 2 * kPi, 50)).value().at(0), 0);
}

TEST(SmallestPreloads, LeaveDampersAlone) {
  const Analysis analysis(
      cam("[springs]\noil = { between = [\"follower.P\", \"ground.S\"], damping = 2 }\n"));
  const auto preloads = preloads_of(analysis.run.mechanism(), analysis.run.plan());
  ASSERT_EQ(preloads.size(), 1U);
  EXPECT_EQ(preloads[0].on, Preload::On::kJoint);
}

TEST(SmallestPreloads, StopAtAFreeLengthOfZero) {
  // Pulled down by a spring from below, of stiffness 50: it can pull with at most 50 free_length more.
  const double omega = 95;
  for (const double free : {0.001, 0.3}) {
    std::string text =
        cam(fmt::format("[springs]\ndown = {{ between = [\"follower.P\", \"ground.S\"], stiffness = 50, "
                        "free_length = {} }}\n",
                        free));
    text.replace(text.find("points.S = [0, 0.107]"), 21, "points.S = [0, -0.107]");
    const Analysis analysis(text);
    const auto forces = follow(analysis, 0, 2 * kPi, omega);
    const double missing = kM * (kE * omega * omega - kG) - 50 * (0.107 + kR + kE - free);
    if (50 * free < missing) {
      EXPECT_FALSE(smallest(analysis, forces));
    } else {
      EXPECT_NEAR(smallest(analysis, forces).value().at(0), missing, 1e-11);
    }
  }
}

TEST(SmallestPreloads, AreRoundedToNumbersThatKeepTheContactClosed) {
  const double omega = 95;
  const Analysis analysis(cam(kSpring));
  const auto forces = follow(analysis, 0, 2 * kPi, omega);
  const double least = force(kPi / 2, omega);
  for (const double unit : {1.0, 1e-3, 1e-9}) {
    PreloadRounding rounding;
    rounding.margin = {unit / 2};
    rounding.round = [&](std::size_t, double x) { return std::round(x / unit) * unit; };
    const double x = smallest_preloads(forces, analysis.run.mechanism(), analysis.run.plan().size, &rounding)
                         .value()
                         .at(0);
    EXPECT_LE(x, least);
    EXPECT_GT(x, least - 1.001 * unit);
  }
}

TEST(HighestSpeed, OfAPreloadedSpringIsTheClosedForm) {
  // e = 10 mm, 0.5 kg, 2 N/mm, preloaded by 5 mm at the lowest position, no weight: 100 rad/s.
  std::string text = cam(
      "[springs]\nback = { between = [\"follower.P\", \"ground.S\"], stiffness = 2000, free_length = 0.1 }\n",
      0);
  text.replace(text.find("center = [0.011, 0], radius = 0.032"), 35, "center = [0.01, 0], radius = 0.03");
  text.replace(text.find("mass = 0.31"), 11, "mass = 0.5");
  text.replace(text.find("points.S = [0, 0.107]"), 21, "points.S = [0, 0.115]");
  const Analysis analysis(text);
  for (const double omega : {0.7, 99.0, 350.0}) {
    const auto forces = follow(analysis, 0, 2 * kPi, omega);
    EXPECT_NEAR(highest_speed(forces).value() * omega, 100, 1e-10);
    EXPECT_EQ(forces.openings.empty(), omega < 100);
  }
}

TEST(HighestSpeed, IsZeroWhereTheContactPullsAtRestAndInfiniteWithoutMass) {
  EXPECT_EQ(highest_speed(follow(Analysis(cam("", kG)), 0, 2 * kPi, 1)), 0);
  std::string text = cam(kSpring);
  text.replace(text.find("free_length = 0.083"), 19, "free_length = 0.1");
  text.replace(text.find("mass = 0.31"), 11, "mass = 0");
  text.replace(text.find("inertia = 1e-4"), 14, "inertia = 0");
  EXPECT_EQ(highest_speed(follow(Analysis(text), 0, 2 * kPi, 1)), std::numeric_limits<double>::infinity());
}

// A second flat-faced follower on a knob of the first one, 0.05 above it. Both have the same acceleration a =
// -e ω² sin θ; with the forces P by which springs press down,
//     N2 = m2 (g + a) + P2,   N1 = (m1 + m2) (g + a) + P1 + P2.
constexpr double kM2 = 0.17;

std::string chain(const std::string& springs) {
  std::string text = cam(springs);
  text.replace(text.find("points.P = [0, 0]"), 17,
               "points.P = [0, 0]\ncurves.knob = { type = \"circle\", center = [0, 0.04], radius = 0.01 }");
  return text + R"([bodies.second]
pose = { x = 0, y = 0.082 }
points.P = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = [0, -1] }
mass = 0.17
center_of_mass = [0, 0]
[joints]
second_guide = { type = "prismatic", between = ["ground.O", "second.P"], direction = [0, 1] }
[contacts.second]
between = ["follower.knob", "second.face"]
)";
}

// Springs from the first follower to ground, from the second one to ground, and between the two.
std::string spring(const std::string& name) {
  const std::string ends = name == "first"    ? "\"follower.P\", \"ground.S\""
                           : name == "second" ? "\"second.P\", \"ground.S\""
                                              : "\"follower.P\", \"second.P\"";
  const double length = name == "between" ? 0.05 : name == "first" ? kH - kR : kH - 0.082;
  return fmt::format("{} = {{ between = [{}], stiffness = 100, free_length = {} }}\n", name, ends, length);
}

double missing(double mass, double omega) {
  return mass * (kE * omega * omega - kG);
}

TEST(SmallestPreloads, OfAChainAreOneAnswerForAllContacts) {
  const double omega = 40;
  // The second spring presses both contacts: most at the top, by k e.
  const Analysis analysis(chain("[springs]\n" + spring("first") + spring("second")));
  const auto forces = follow(analysis, 0, 2 * kPi, omega);
  ASSERT_EQ(forces.openings.size(), 2U);
  const auto x = smallest(analysis, forces).value();
  const double at_top = 100 * kE;
  EXPECT_EQ(x[0], 0);
  EXPECT_NEAR(x[1], -std::max(missing(kM2, omega) - at_top, missing(kM + kM2, omega) - 2 * at_top), 1e-12);
}

TEST(SmallestPreloads, OfAChainAreSeveralWhereOneAloneCannotDoIt) {
  const double omega = 40;
  const Analysis analysis(chain("[springs]\n" + spring("first") + spring("between")));
  const auto forces = follow(analysis, 0, 2 * kPi, omega);
  const auto x = smallest(analysis, forces).value();
  // The spring between them pulls, the other pushes; a force between the followers does not change the first
  // contact.
  EXPECT_NEAR(x[0], -(missing(kM + kM2, omega) - 100 * kE), 1e-12);
  EXPECT_NEAR(x[1], missing(kM2, omega), 1e-12);
}

TEST(SmallestPreloads, OfAChainAreNoneWhereNoSpringPressesOneOfTheContacts) {
  for (const char* name : {"first", "between"}) {
    const Analysis analysis(chain("[springs]\n" + spring(name)));
    EXPECT_FALSE(smallest(analysis, follow(analysis, 0, 2 * kPi, 40))) << name;
  }
}

// A see-saw: the contacts are on either side of its pivot, so that what presses the second contact lifts the
// first.
std::string see_saw(double torque, double second) {
  return fmt::format(R"([bodies.ground]
points.O1 = [0, 0]
points.O2 = [0.08, 0]
points.O3 = [0.15, -0.075]
[bodies.cam]
points.O = [0, 0]
curves.disc = {{ type = "circle", center = [0.01, 0], radius = 0.025 }}
[bodies.arm]
pose = {{ x = 0.08, y = 0, angle = 2.618 }}
points.O = [0, 0]
curves.in = {{ type = "circle", center = [0.06, 0], radius = 0.01 }}
curves.out = {{ type = "circle", center = [-0.04, 0.015], radius = 0.012 }}
mass = 0.3
center_of_mass = [0, 0]
inertia = 2e-4
[bodies.second_arm]
pose = {{ x = 0.15, y = -0.075, angle = 2.05 }}
points.O = [0, 0]
curves.roller = {{ type = "circle", center = [0.05, 0], radius = 0.009 }}
mass = 0.2
center_of_mass = [0.02, 0]
inertia = 1e-4
[joints]
cam_pivot    = {{ type = "revolute", between = ["ground.O1", "cam.O"] }}
arm_pivot    = {{ type = "revolute", between = ["ground.O2", "arm.O"] }}
second_pivot = {{ type = "revolute", between = ["ground.O3", "second_arm.O"] }}
[contacts.first]
between = ["cam.disc", "arm.in"]
[contacts.second]
between = ["arm.out", "second_arm.roller"]
[driver]
joint = "cam_pivot"
[springs]
coil = {{ joint = "second_pivot", stiffness = 0.8, free_angle = {} }}
[loads]
hold = {{ body = "arm", torque = {} }}
)",
                     second, torque);
}

TEST(SmallestPreloads, OfASeeSawAreJustEnoughAndDoNotOpenTheOtherContact) {
  const double omega = 12;
  int solved = 0, refused = 0;
  for (const double torque : {0.02, 0.3, 1.0}) {
    for (const double free : {1.0, 2.0, 3.0}) {
      const Analysis analysis(see_saw(torque, free));
      const auto forces = follow(analysis, 0, 2 * kPi, omega);
      const auto x = smallest(analysis, forces);
      if (forces.openings.empty()) {
        EXPECT_EQ(x.value().at(0), 0);
        continue;
      }
      if (!x) {
        ++refused;
        // Whatever the spring's preload, one of the contacts opens.
        for (double other = -8; other <= 8; other += 0.5) {
          EXPECT_LT(lowest_of(see_saw(torque, other), 0, 2 * kPi, omega), 0);
        }
        continue;
      }
      ++solved;
      const auto changed = [&](double share) {
        return lowest_of(see_saw(torque, free - share * x->at(0) / 0.8), 0, 2 * kPi, omega);
      };
      EXPECT_NEAR(changed(1), 0, 1e-10);
      EXPECT_LT(changed(0.999), 0);
    }
  }
  EXPECT_GT(solved, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace higherpair
