// Torques of gears and belts, calculated by hand.
#include "dynamics/dynamics_testing.hpp"
#include "higherpair/dynamics/reactions.hpp"

#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::Analysis;

constexpr double kGearRounding = 1e-12;  // for numbers of about 1 to 100

// A motor wheel, and a driven wheel with inertia and a load; `coupling` contains the keys of the joint
// between them.
std::string train(const std::string& coupling) {
  return R"([bodies.ground]
points.A = [0, 0]
points.B = [0.3, 0.1]
[bodies.motor]
points.A = [0, 0]
mass = 0
center_of_mass = [0, 0]
inertia = 0.02
[bodies.drum]
pose = { x = 0.3, y = 0.1, angle = 0.2 }
points.B = [0, 0]
mass = 5
center_of_mass = [0, 0]
inertia = 0.7
[joints.motor_pivot]
type = "revolute"
between = ["ground.A", "motor.A"]
[joints.drum_pivot]
type = "revolute"
between = ["ground.B", "drum.B"]
[joints.coupling]
between = ["motor.A", "drum.B"]
ratio = 0.25
)" + coupling +
         R"([driver]
joint = "motor_pivot"
[loads]
hoist = { body = "drum", torque = -3 }
)";
}

// Power balance: the torque on the motor wheel times its speed is the power of the inertias and the load.
TEST(Gears, TransformTheTorqueByTheirRatio) {
  const struct {
    const char* keys;
    double ratio;
  } couplings[] = {{"type = \"gears\"\n", -0.25},
                   {"type = \"gears\"\ninternal = true\n", 0.25},
                   {"type = \"belt\"\n", 0.25},
                   {"type = \"belt\"\ncrossed = true\n", -0.25}};
  for (const auto& coupling : couplings) {
    Analysis train_of(train(coupling.keys));
    const double k = coupling.ratio;
    const double alpha = 8.5;
    const Reactions& reactions = train_of.at(0.7, 31, alpha);
    ASSERT_TRUE(reactions.defined);
    const BodyMotion& drum = train_of.run.row.bodies[train_of.body("drum")];
    EXPECT_NEAR(drum.theta, 0.2 + k * 0.7, 1e-15);
    EXPECT_NEAR(drum.omega, k * 31, 1e-13);
    EXPECT_NEAR(drum.alpha, k * alpha, 1e-13);
    const double on_drum = 0.7 * k * alpha + 3;
    const std::size_t joint = train_of.joint("coupling");
    EXPECT_NEAR(reactions.joints[joint].moment.value(), on_drum, kGearRounding);
    EXPECT_NEAR(reactions.drivers[0].effort.value(), 0.02 * alpha + k * on_drum, kGearRounding);
    EXPECT_NEAR(reactions.drivers[0].by_power.value(), reactions.drivers[0].effort.value(), kGearRounding);
    // Torque only: the forces of teeth or belt on the bearings are not modelled here.
    EXPECT_EQ(reactions.joints[joint].fx.value(), 0);
    EXPECT_NEAR(reactions.joints[train_of.joint("drum_pivot")].fx.value(), 0, kGearRounding);
  }
}

constexpr double kSun = 23, kPlanet = 17, kRing = kSun + 2 * kPlanet;  // numbers of teeth

// Input by the sun, ring held, output by the arm; with further keys of the planet and of both meshes.
Analysis planetary_gear(const std::string& planet, const std::string& at_sun, const std::string& at_ring) {
  return Analysis(fmt::format(R"([bodies.ground]
points.O = [0, 0]
[bodies.sun]
points.O = [0, 0]
[bodies.arm]
points.O = [0, 0]
points.P = [0.04, 0]
[bodies.planet]
points.P = [0.04, 0]
{}[joints]
sun_pivot    = {{ type = "revolute", between = ["ground.O", "sun.O"] }}
arm_pivot    = {{ type = "revolute", between = ["ground.O", "arm.O"] }}
planet_pivot = {{ type = "revolute", between = ["arm.P", "planet.P"] }}
sun_planet   = {{ type = "gears", between = ["sun.O", "planet.P"], ratio = {}{} }}
planet_ring  = {{ type = "gears", between = ["ground.O", "planet.P"], internal = true, ratio = {}{} }}
[driver]
joint = "sun_pivot"
[loads]
brake = {{ body = "arm", torque = -7 }}
)",
                              planet, kSun / kPlanet, at_sun, kRing / kPlanet, at_ring));
}

// The arm's torque is (1 + z_ring/z_sun) times the sun's, and the ring carries the difference.
void expect_effort_of_planetary_gear(const Reactions& reactions) {
  ASSERT_TRUE(reactions.defined);
  EXPECT_NEAR(reactions.drivers[0].effort.value(), 7 / (1 + kRing / kSun), kGearRounding);
  EXPECT_NEAR(reactions.drivers[0].by_power.value(), 7 / (1 + kRing / kSun), kGearRounding);
}

TEST(Gears, OfAPlanetaryGearMultiplyTheTorque) {
  Analysis gear = planetary_gear("mass = 0.3\ncenter_of_mass = [0.04, 0]\ninertia = 2e-5\n", "", "");
  for (const double theta : {0.0, 2.2, 9.1}) {
    const Reactions& reactions = gear.at(theta, 3, 0);
    expect_effort_of_planetary_gear(reactions);
    // The centripetal force of the planet, which acts on the arm's pin only.
    const double arm_rate = 3 * kSun / (kSun + kRing);
    const JointReaction& pin = gear.dynamics.solve(gear.run).joints[gear.joint("planet_pivot")];
    EXPECT_NEAR(std::hypot(pin.fx.value(), pin.fy.value()), 0.3 * 0.04 * arm_rate * arm_rate, kGearRounding);
  }
}

Vector2d force_of(const Reactions& reactions, std::size_t joint) {
  return {reactions.joints[joint].fx.value(), reactions.joints[joint].fy.value()};
}

// Textbook: the tangential force is the torque divided by the pitch radius; the radial one is tan α times
// that, towards the centre of the wheel; the pins carry both.
TEST(GearTeeth, PressAtTheirPressureAngle) {
  const double alpha = 0.349;
  const Vector2d c2(0.3, 0.1);  // c1 is at 0
  const double a = c2.norm();
  const Vector2d u = c2 / a;
  for (const double load : {-3.0, 3.0}) {
    Analysis of(train(fmt::format("type = \"gears\"\npressure_angle = {}\n", alpha)));
    Mechanism loaded = of.run.mechanism();
    loaded.loads[0].torque = load;
    of.run.model = make_run_model(std::move(loaded), of.run.plan());
    const Reactions& reactions = of.at(0.7, 0, 0);
    ASSERT_TRUE(reactions.defined);
    const double r2 = a / 1.25;  // r1 = r2/4
    const double tangential = 3 / r2;
    const std::size_t teeth = of.joint("coupling");
    const Vector2d on_drum = force_of(reactions, teeth);
    EXPECT_NEAR(on_drum.dot(u), tangential * std::tan(alpha), kGearRounding);
    // About the drum's centre the tooth force gives the torque that holds the load.
    EXPECT_NEAR(cross(Vector2d(-r2 * u), on_drum), -load, kGearRounding);
    EXPECT_NEAR(reactions.joints[teeth].moment.value(), -load, kGearRounding);
    EXPECT_NEAR((force_of(reactions, of.joint("drum_pivot")) + on_drum).norm(), 0, kGearRounding);
    EXPECT_NEAR((force_of(reactions, of.joint("motor_pivot")) - on_drum).norm(), 0, kGearRounding);
    EXPECT_NEAR(reactions.drivers[0].effort.value(), -0.25 * -load, kGearRounding);
    EXPECT_NEAR(reactions.drivers[0].by_power.value(), -0.25 * -load, kGearRounding);
  }
}

// In a ring twice its size the pinion is pushed towards the ring's centre, and the ring away from it.
TEST(GearTeeth, OfARingPushItOut) {
  const double alpha = 0.349;
  const Vector2d c2(0.3, 0.1);
  const double a = c2.norm();
  for (const double ratio : {0.25, 4.0}) {  // the drum is the ring, or the pinion
    std::string text = train(fmt::format("type = \"gears\"\ninternal = true\npressure_angle = {}\n", alpha));
    text.replace(text.find("ratio = 0.25"), 12, fmt::format("ratio = {}", ratio));
    Analysis of(text);
    const Reactions& reactions = of.at(0.7, 0, 0);
    const Vector2d on_drum = force_of(reactions, of.joint("coupling"));
    const Vector2d u = c2 / a;
    const double r2 = a / std::abs(ratio - 1);
    const double tangential = 3 / r2;
    EXPECT_NEAR(on_drum.dot(u), -tangential * std::tan(alpha), kGearRounding) << ratio;
    EXPECT_NEAR(std::abs(on_drum.dot(perp(u))), tangential, kGearRounding);
    const Vector2d pitch_point = ratio > 1 ? Vector2d(c2 + r2 * u) : Vector2d(c2 - r2 * u);
    EXPECT_NEAR(cross(Vector2d(pitch_point - c2), on_drum), 3, kGearRounding);
  }
}

// Each body of a planetary gear is in equilibrium, with the forces applied at their actual points.
TEST(GearTeeth, HoldAPlanetaryGearInEquilibrium) {
  Analysis gear = planetary_gear("", ", pressure_angle = 0.349, carrier = \"arm\"",
                                 ", pressure_angle = 0.4, carrier = \"arm\"");
  for (const double theta : {0.0, 2.2, 9.1}) {
    const Reactions& reactions = gear.at(theta, 3, 0);
    expect_effort_of_planetary_gear(reactions);
    const Vector2d P = 0.04 * unit_vector(theta * kSun / (kSun + kRing));
    const Vector2d u = P.normalized();
    const double r_planet = 0.04 * kPlanet / (kSun + kPlanet);
    const Vector2d by_sun = force_of(reactions, gear.joint("sun_planet"));
    const Vector2d by_ring = force_of(reactions, gear.joint("planet_ring"));
    const Vector2d by_arm = force_of(reactions, gear.joint("planet_pivot"));
    EXPECT_NEAR((by_sun + by_ring + by_arm).norm(), 0, 1e-11);
    EXPECT_NEAR(cross(Vector2d(-r_planet * u), by_sun) + cross(Vector2d(r_planet * u), by_ring), 0,
                kGearRounding);
    EXPECT_NEAR(std::abs(by_sun.dot(u) / by_sun.dot(perp(u))), std::tan(0.349), kGearRounding);
    EXPECT_NEAR(std::abs(by_ring.dot(u) / by_ring.dot(perp(u))), std::tan(0.4), kGearRounding);
    EXPECT_GT(by_sun.dot(u), 0);
    EXPECT_LT(by_ring.dot(u), 0);
    // The arm's torque is transmitted by its pins alone.
    EXPECT_NEAR(cross(P, Vector2d(-by_arm)), 7, kGearRounding);
    EXPECT_NEAR((force_of(reactions, gear.joint("arm_pivot")) - by_arm).norm(), 0, 1e-11);
    EXPECT_NEAR((force_of(reactions, gear.joint("sun_pivot")) - by_sun).norm(), 0, 1e-11);
  }
}

// The pressure angle affects the bearings only.
TEST(GearTeeth, ChangeNoTorqueAndNoEffort) {
  const auto efforts = [](const std::string& keys) {
    Analysis of(train("type = \"gears\"\n" + keys));
    std::vector<double> found;
    for (const double at : {0.1, 1.7, 4.4}) {
      const Reactions& reactions = of.at(at, 31, 8.5);
      found.push_back(reactions.drivers[0].effort.value());
      found.push_back(reactions.joints[of.joint("coupling")].moment.value());
    }
    return found;
  };
  const std::vector<double> plain = efforts("");
  const std::vector<double> toothed = efforts("pressure_angle = 0.349\nmodule = 0.002\n");
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_NEAR(toothed[i], plain[i], kGearRounding);
  }
}

}  // namespace
}  // namespace higherpair
