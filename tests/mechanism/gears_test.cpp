// Gears and belts: mobility, and motion compared with Willis' equation.
#include "drawn_mechanism.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/analyse_mobility.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "support/texts.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;

// Couples two wheels about the pins of two joints, both of which name the carrier first.
int couple(DrawnMechanism& drawn, int carrier, int wheel1, int wheel2, const Vector2d& at, double ratio) {
  const int index = drawn.pin(wheel1, wheel2, at);
  Joint& joint = drawn.mechanism.joints.back();
  joint.name = "mesh";
  joint.type = JointType::kGears;
  joint.carrier = carrier;
  joint.turning_ratio = ratio;
  return index;
}

// Sun (z teeth) and arm on ground, planet on the arm, ring on ground.
constexpr double kSun = 23;
constexpr double kPlanet = 17;
constexpr double kRing = kSun + 2 * kPlanet;

struct Planetary {
  DrawnMechanism drawn;
  int sun = 0, arm = 0, planet = 0, ring = 0;
  int arm_pin = 0, sun_pin = 0;
};

Planetary planetary(bool ring_turns) {
  Planetary gear;
  const Vector2d O = Vector2d::Zero();
  const Vector2d P(0.031, 0.011);
  DrawnMechanism& drawn = gear.drawn;
  gear.sun = drawn.crank("sun", O);
  gear.sun_pin = 0;
  gear.arm = drawn.crank("arm", O);
  gear.arm_pin = 1;
  gear.planet = drawn.body("planet");
  drawn.pin(gear.arm, gear.planet, P);
  if (ring_turns) {
    gear.ring = drawn.crank("ring", O);
  }
  couple(drawn, gear.arm, gear.sun, gear.planet, P, -kSun / kPlanet);
  couple(drawn, gear.arm, gear.ring, gear.planet, P, kRing / kPlanet);
  return gear;
}

TEST(Gears, CountAsJointsOfTwoFreedoms) {
  DrawnMechanism drawn;
  const int one = drawn.crank("one", Vector2d::Zero());
  const int two = drawn.crank("two", {0.07, 0});
  drawn.drive(0);
  couple(drawn, 0, one, two, {0.07, 0}, -0.4);
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.count.mobility(), 1);
  EXPECT_EQ(mobility.freedom, 1);
  EXPECT_TRUE(mobility.drivers_fit());
  EXPECT_TRUE(contains(elements_text(mobility.count), "1 gear pair of 2 freedoms"));
  ASSERT_FALSE(mobility.moving.empty());
  EXPECT_NEAR(mobility.moving[2].omega, -0.4, 1e-12);
}

TEST(Gears, MakeADifferentialOfTwoFreedomsWhereTheRingTurns) {
  const Planetary gear = planetary(true);
  const Mobility mobility = analyse_mobility(gear.drawn.mechanism);
  EXPECT_EQ(mobility.count.mobility(), 2);
  EXPECT_EQ(mobility.freedom, 2);
  EXPECT_EQ(analyse_mobility(planetary(false).drawn.mechanism).freedom, 1);
}

// Willis: (ω_ring - ω_arm)/(ω_sun - ω_arm) = -z_sun/z_ring.
TEST(Gears, OfAPlanetaryGearTurnByWillisEquation) {
  Planetary gear = planetary(false);
  gear.drawn.drive(gear.sun_pin);
  auto run = start_run(gear.drawn.mechanism, {0});
  ASSERT_TRUE(run) << run.error().reason;
  const double arm_per_sun = kSun / (kSun + kRing);
  for (const double sun : {0.3, 2.9, 7.1, -4.4}) {
    move_to(*run, {{sun, 1.7, -0.6}});
    ASSERT_EQ(run->row.status, RowStatus::kOk);
    const BodyMotion& arm = run->row.bodies[gear.arm];
    const BodyMotion& planet = run->row.bodies[gear.planet];
    EXPECT_NEAR(arm.theta, arm_per_sun * sun, 1e-13);
    EXPECT_NEAR(arm.omega, arm_per_sun * 1.7, 1e-13);
    EXPECT_NEAR(arm.alpha, arm_per_sun * -0.6, 1e-13);
    // The planet rolls in the ring: (ω_planet - ω_arm) z_planet = -ω_arm z_ring.
    EXPECT_NEAR((planet.omega - arm.omega) * kPlanet, -arm.omega * kRing, 1e-11);
    // The planet's pin moves with the arm.
    const Vector2d P = arm.X_WB * Vector2d(0.031, 0.011);
    EXPECT_NEAR((planet.X_WB * Vector2d(0.031, 0.011) - P).norm(), 0, 1e-15);
  }
}

TEST(Gears, OfADifferentialAddTheTurningOfBothDrivers) {
  Planetary gear = planetary(true);
  gear.drawn.drive(gear.sun_pin, "sun");
  gear.drawn.drive(gear.arm_pin, "arm");
  auto run = start_run(gear.drawn.mechanism, {0, 0});
  ASSERT_TRUE(run) << run.error().reason;
  move_to(*run, {{1.3, 2.1, 0}, {-0.4, 0.7, 0.2}});
  ASSERT_EQ(run->row.status, RowStatus::kOk);
  const BodyMotion& ring = run->row.bodies[gear.ring];
  const double k = -kSun / kRing;
  EXPECT_NEAR(ring.theta, -0.4 + k * (1.3 + 0.4), 1e-13);
  EXPECT_NEAR(ring.omega, 0.7 + k * (2.1 - 0.7), 1e-13);
  EXPECT_NEAR(ring.alpha, 0.2 + k * (0 - 0.2), 1e-13);
}

TEST(Gears, ThatJamAreTooManyForTheDriver) {
  // Three wheels on ground, each in mesh with both others.
  DrawnMechanism drawn;
  const int a = drawn.crank("a", Vector2d::Zero());
  const int b = drawn.crank("b", {0.05, 0});
  const int c = drawn.crank("c", {0.02, 0.04});
  drawn.drive(0);
  couple(drawn, 0, a, b, {0.05, 0}, -1);
  couple(drawn, 0, b, c, {0.02, 0.04}, -1);
  EXPECT_EQ(analyse_mobility(drawn.mechanism).freedom, 1);
  couple(drawn, 0, c, a, Vector2d::Zero(), -1);
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.freedom, 0);
  EXPECT_TRUE(contains(driver_objection(drawn.mechanism, mobility).value_or(""), "nothing can move"));
}

}  // namespace
}  // namespace higherpair
