// Torques of gears and belts by hand.
#include "dynamics/dynamics_testing.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::Analysis;

constexpr double kRounding = 1e-12;  // of numbers of the order of 1 to 100

// A motor wheel and a driven one with inertia and a load; `coupling` are the keys of the joint between them.
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

// Power: torque on the motor wheel times its rate is what the inertias and the load take up.
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
    EXPECT_NEAR(reactions.joints[joint].moment.value(), on_drum, kRounding);
    EXPECT_NEAR(reactions.drivers[0].effort.value(), 0.02 * alpha + k * on_drum, kRounding);
    EXPECT_NEAR(reactions.drivers[0].by_power.value(), reactions.drivers[0].effort.value(), kRounding);
    // Torque only: what the teeth or the belt pull on the bearings is not part of the model.
    EXPECT_EQ(reactions.joints[joint].fx.value(), 0);
    EXPECT_NEAR(reactions.joints[train_of.joint("drum_pivot")].fx.value(), 0, kRounding);
  }
}

// Sun in, ring held, arm out: the arm's torque is (1 + z_ring/z_sun) times the sun's, and the ring takes up
// the difference.
TEST(Gears, OfAPlanetaryGearMultiplyTheTorque) {
  const double sun = 23, planet = 17, ring = sun + 2 * planet;
  Analysis gear(fmt::format(R"([bodies.ground]
points.O = [0, 0]
[bodies.sun]
points.O = [0, 0]
[bodies.arm]
points.O = [0, 0]
points.P = [0.04, 0]
[bodies.planet]
points.P = [0.04, 0]
mass = 0.3
center_of_mass = [0.04, 0]
inertia = 2e-5
[joints.sun_pivot]
type = "revolute"
between = ["ground.O", "sun.O"]
[joints.arm_pivot]
type = "revolute"
between = ["ground.O", "arm.O"]
[joints.planet_pivot]
type = "revolute"
between = ["arm.P", "planet.P"]
[joints.sun_planet]
type = "gears"
between = ["sun.O", "planet.P"]
ratio = {}
[joints.planet_ring]
type = "gears"
between = ["ground.O", "planet.P"]
internal = true
ratio = {}
[driver]
joint = "sun_pivot"
[loads]
brake = {{ body = "arm", torque = -7 }}
)",
                            sun / planet, ring / planet));
  for (const double theta : {0.0, 2.2, 9.1}) {
    const Reactions& reactions = gear.at(theta, 3, 0);
    ASSERT_TRUE(reactions.defined);
    EXPECT_NEAR(reactions.drivers[0].effort.value(), 7 / (1 + ring / sun), kRounding);
    EXPECT_NEAR(reactions.drivers[0].by_power.value(), 7 / (1 + ring / sun), kRounding);
    // The centripetal force of the planet, on the arm's pin alone.
    const double arm_rate = 3 * sun / (sun + ring);
    const JointReaction& pin = gear.dynamics.solve(gear.run).joints[gear.joint("planet_pivot")];
    EXPECT_NEAR(std::hypot(pin.fx.value(), pin.fy.value()), 0.3 * 0.04 * arm_rate * arm_rate, kRounding);
  }
}

}  // namespace
}  // namespace higherpair
