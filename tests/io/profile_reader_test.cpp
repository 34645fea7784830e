#include "higherpair/io/profile_reader.hpp"

#include "io/profile_testing.hpp"

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::crank_profile;
using testing::kCamProfile;
using testing::read;
using testing::slider_profile;

TEST(ProfileReader, ReadsTheBodiesOfTheExample) {
  const Profile profile = read(kCamProfile);
  const Mechanism& mechanism = profile.mechanism;
  EXPECT_EQ(mechanism.title, "Eccentric disc cam, oscillating disc follower");
  EXPECT_EQ(mechanism.gravity_W, Vector2d(0, -9.81));
  EXPECT_EQ(profile.units, Units{});
  ASSERT_EQ(mechanism.bodies.size(), 3U);

  const Body& ground = mechanism.bodies[0];
  EXPECT_EQ(ground.name, "ground");
  ASSERT_EQ(ground.points.size(), 2U);
  EXPECT_EQ(ground.points[0].name, "O1");
  EXPECT_EQ(ground.points[0].p_B, Vector2d(0, 0));
  EXPECT_EQ(ground.points[1].name, "O2");
  EXPECT_EQ(ground.points[1].p_B, Vector2d(0.08, 0));
  EXPECT_FALSE(ground.mass);

  const Body& cam = mechanism.bodies[1];
  EXPECT_EQ(cam.name, "cam");
  EXPECT_EQ(cam.guess_p_WB, Vector2d(0, 0));
  ASSERT_EQ(cam.curves.size(), 1U);
  EXPECT_EQ(cam.curves[0].name, "disc");
  EXPECT_EQ(cam.curves[0].curve.kind, CurveKind::kCircle);
  EXPECT_EQ(cam.curves[0].curve.semi_latus, 0.02);
  EXPECT_TRUE(center(cam.curves[0].curve).isApprox(Vector2d(0.01, 0)));
  EXPECT_FALSE(cam.mass);

  const Body& follower = mechanism.bodies[2];
  EXPECT_EQ(follower.name, "follower");
  EXPECT_EQ(follower.guess_p_WB, Vector2d(0.08, 0));
  EXPECT_DOUBLE_EQ(follower.guess_theta, -35 * kPi / 180);
  ASSERT_EQ(follower.points.size(), 2U);
  EXPECT_EQ(follower.points[1].p_B, Vector2d(-0.06, 0.025));
  ASSERT_TRUE(follower.mass);
  EXPECT_EQ(follower.mass->mass, 0.4);
  EXPECT_EQ(follower.mass->center_of_mass_B, Vector2d(-0.03, 0));
  EXPECT_EQ(follower.mass->inertia, 2.1e-4);
}

TEST(ProfileReader, ReadsTheJointsAndTheContactOfTheExample) {
  const Mechanism mechanism = read(kCamProfile).mechanism;
  ASSERT_EQ(mechanism.joints.size(), 2U);
  const Joint& joint = mechanism.joints[1];
  EXPECT_EQ(mechanism.joints[0].name, "cam_pivot");
  EXPECT_EQ(joint.name, "follower_pivot");
  EXPECT_EQ(joint.type, JointType::kRevolute);
  EXPECT_EQ(joint.first.body, 0);
  EXPECT_EQ(joint.first.point, 1);
  EXPECT_EQ(joint.second.body, 2);
  EXPECT_EQ(joint.second.point, 0);

  ASSERT_EQ(mechanism.contacts.size(), 1U);
  const Contact& contact = mechanism.contacts[0];
  EXPECT_EQ(contact.name, "touch");
  EXPECT_EQ(contact.first.body, 1);
  EXPECT_EQ(contact.first.curve, 0);
  EXPECT_EQ(contact.second.body, 2);
  EXPECT_EQ(contact.second.curve, 0);
  EXPECT_FALSE(contact.rolling);
  EXPECT_EQ(contact.approach, Approach::kNearest);
  EXPECT_TRUE(contact.jump);
}

TEST(ProfileReader, ReadsTheDriverOfTheExampleInItsOwnUnits) {
  const Profile profile = read(kCamProfile);
  ASSERT_EQ(profile.mechanism.drivers.size(), 1U);
  EXPECT_EQ(profile.mechanism.drivers[0].name, "");
  EXPECT_EQ(profile.mechanism.drivers[0].joint, 0);
  ASSERT_EQ(profile.programs.size(), 1U);
  const DriverProgram& program = profile.programs[0];
  EXPECT_EQ(program.start, 0);
  EXPECT_EQ(program.end, 360);
  EXPECT_EQ(program.samples, 361);
  EXPECT_TRUE(program.positions.empty());
  EXPECT_EQ(program.velocity, 60);
  EXPECT_EQ(program.acceleration, 0);
  EXPECT_EQ(program.duration, 6);
  EXPECT_EQ(program.time_step, 0.01);
  EXPECT_EQ(program.place.source, "test.toml");
  EXPECT_EQ(program.place.line, 43);
}

TEST(ProfileReader, ReadsTheLoadsAndSpringsOfTheExample) {
  const Mechanism mechanism = read(kCamProfile).mechanism;
  ASSERT_EQ(mechanism.loads.size(), 2U);
  const Load& push = mechanism.loads[0];
  EXPECT_EQ(push.name, "push");
  EXPECT_EQ(push.body, 2);
  EXPECT_EQ(push.p_B, Vector2d(-0.06, 0.025));
  EXPECT_EQ(push.force, Vector2d(0, -12));
  EXPECT_EQ(push.frame, LoadFrame::kGround);
  const Load& twist = mechanism.loads[1];
  EXPECT_EQ(twist.name, "twist");
  EXPECT_EQ(twist.torque, 0.04);
  EXPECT_EQ(twist.force, Vector2d(0, 0));

  ASSERT_EQ(mechanism.springs.size(), 2U);
  const Spring& line = mechanism.springs[0];
  EXPECT_EQ(line.name, "s1");
  EXPECT_FALSE(line.joint);
  EXPECT_EQ(line.first.body, 0);
  EXPECT_EQ(line.first.point, 0);
  EXPECT_EQ(line.second.body, 2);
  EXPECT_EQ(line.second.point, 1);
  EXPECT_EQ(line.stiffness, 1500);
  EXPECT_EQ(line.free, 0.04);
  const Spring& pivot = mechanism.springs[1];
  EXPECT_EQ(pivot.joint, 1);
  EXPECT_DOUBLE_EQ(pivot.stiffness, 30e-3 * 180 / kPi);
  EXPECT_EQ(pivot.free, 0);
}

TEST(ProfileReader, KeepsTheOrderOfTheFile) {
  const Mechanism mechanism = read(R"(
[bodies.zebra]
points.z = [1, 0]
points.a = [2, 0]
[bodies.ape.points]
m = [3, 0]
[bodies.ground]
points.x = [0, 0]
[bodies.zebra.curves]
q.type = "point"
q.at = [0, 0]
b = { type = "point", at = [0, 0] }
[joints.second-one]
type = "revolute"
between = ["ground.x", "zebra.z"]
[joints.first]
type = "revolute"
between = ["zebra.a", "ape.m"]
[driver]
joint = "first"
)")
                                  .mechanism;
  ASSERT_EQ(mechanism.bodies.size(), 3U);
  EXPECT_EQ(mechanism.bodies[0].name, "ground");
  EXPECT_EQ(mechanism.bodies[1].name, "zebra");
  EXPECT_EQ(mechanism.bodies[2].name, "ape");
  EXPECT_EQ(mechanism.bodies[1].points[0].name, "z");
  EXPECT_EQ(mechanism.bodies[1].points[1].name, "a");
  EXPECT_EQ(mechanism.bodies[1].curves[0].name, "q");
  EXPECT_EQ(mechanism.bodies[1].curves[1].name, "b");
  EXPECT_EQ(mechanism.joints[0].name, "second-one");
  EXPECT_EQ(mechanism.joints[1].name, "first");
}

TEST(ProfileReader, NumbersMayBeIntegersDecimalsOrQuantitiesInAnyUnit) {
  const Mechanism mechanism = read(crank_profile(R"([bodies.other]
pose = { x = "1 in", y = 2.5, angle = "0.25 rev" }
points.P = ["0.5 m", -3]
)"))
                                  .mechanism;
  const Body& other = mechanism.bodies[2];
  EXPECT_EQ(other.guess_p_WB, Vector2d(0.0254, 0.0025));
  EXPECT_EQ(other.guess_theta, kPi / 2);
  EXPECT_EQ(other.points[0].p_B, Vector2d(0.5, -0.003));
}

TEST(ProfileReader, EveryNumberIsInTheUnitsOfTheProfile) {
  const Profile profile =
      read(crank_profile("start = 0.25\nvelocity = 30\n[loads]\ntwist = { body = \"crank\", torque = 2 }\n",
                         R"(gravity = [0, -386]
[units]
length = "in"
angle = "rev"
mass = "lb"
time = "min"
force = "lbf"
)"));
  const Mechanism& mechanism = profile.mechanism;
  EXPECT_DOUBLE_EQ(mechanism.bodies[0].points[1].p_B.x(), 127 * 0.0254);
  EXPECT_DOUBLE_EQ(mechanism.gravity_W.y(), -386 * 0.0254 / 3600);
  EXPECT_DOUBLE_EQ(mechanism.loads[0].torque, 2 * 0.1129848290276167);
  EXPECT_EQ(profile.programs[0].start, 0.25);
  EXPECT_EQ(profile.programs[0].velocity, 30);
}

TEST(ProfileReader, APrismaticJointTakesItsAngleFromThePosesUnlessItIsGiven) {
  const auto joint = [](const std::string& key) {
    return read(R"([bodies.a]
pose.angle = 30
points.P = [0, 0]
[bodies.b]
pose.angle = 77
points.P = [0, 0]
[joints.slide]
type = "prismatic"
between = ["a.P", "b.P"]
direction = [-3, 4]
)" + key + "[driver]\njoint = \"slide\"\n")
        .mechanism.joints[0];
  };
  EXPECT_EQ(joint("").type, JointType::kPrismatic);
  EXPECT_TRUE(joint("").direction_A.isApprox(Vector2d(-0.6, 0.8), 1e-15));
  const Scaling degrees = to_si(dimension::kAngle, Units{});
  EXPECT_EQ(joint("").relative_angle, degrees.apply(77) - degrees.apply(30));
  EXPECT_EQ(joint("angle = 90\n").relative_angle, kPi / 2);
}

TEST(ProfileReader, DirectionsAreAnglesOrVectorsAndQuarterTurnsAreExact) {
  const auto direction = [](const std::string& text) {
    return read(slider_profile("", text)).mechanism.joints[0].direction_A;
  };
  EXPECT_EQ(direction("0"), Vector2d(1, 0));
  EXPECT_EQ(direction("90"), Vector2d(0, 1));
  EXPECT_EQ(direction("180.0"), Vector2d(-1, 0));
  EXPECT_EQ(direction("-90"), Vector2d(0, -1));
  EXPECT_EQ(direction("630"), Vector2d(0, -1));
  EXPECT_EQ(direction("\"0.25 rev\""), Vector2d(0, 1));
  EXPECT_EQ(direction("[0, -31]"), Vector2d(0, -1));
  EXPECT_EQ(direction("[1e200, 0]"), Vector2d(1, 0));
  EXPECT_TRUE(direction("30").isApprox(Vector2d(std::sqrt(0.75), 0.5), 1e-15));
  EXPECT_TRUE(direction("[1e-300, 1e-300]").isApprox(Vector2d(1, 1) / std::sqrt(2), 1e-15));
}

TEST(ProfileReader, ASlotHasADirectionAndLeavesTheAngleFree) {
  const Mechanism mechanism = read(crank_profile(R"([bodies.lever]
points.O = [0, 0]
[joints.guide]
type = "slot"
between = ["lever.O", "crank.P"]
direction = "1 rad"
)"))
                                  .mechanism;
  EXPECT_EQ(mechanism.joints[1].type, JointType::kSlot);
  EXPECT_TRUE(mechanism.joints[1].direction_A.isApprox(unit_vector(1), 1e-15));
}

TEST(ProfileReader, ContactsRollApproachAndStayAsTold) {
  const auto contact = [](const std::string& keys) {
    return read(crank_profile(R"([bodies.crank.curves]
disc = { type = "circle", center = [0, 0], radius = 7 }
[bodies.ground.curves]
face = { type = "line", point = [0, -7], normal = 90 }
[contacts.k]
between = ["ground.face", "crank.disc"]
)" + keys))
        .mechanism.contacts[0];
  };
  EXPECT_TRUE(contact("rolling = true\n").rolling);
  EXPECT_EQ(contact("approach = \"+\"\n").approach, Approach::kPositive);
  EXPECT_EQ(contact("approach = \"-\"\n").approach, Approach::kNegative);
  EXPECT_FALSE(contact("jump = false\n").jump);
}

TEST(ProfileReader, LoadsMayTurnWithTheirBody) {
  const Mechanism mechanism = read(crank_profile(R"([loads]
pull = { body = "crank", point = "P", force = ["1 kN", 0], frame = "body", torque = "1 N m" }
)"))
                                  .mechanism;
  EXPECT_EQ(mechanism.loads[0].frame, LoadFrame::kBody);
  EXPECT_EQ(mechanism.loads[0].force, Vector2d(1000, 0));
  EXPECT_EQ(mechanism.loads[0].torque, 1);
}

TEST(ProfileReader, ASpringOnASlideHasAStiffnessPerLength) {
  const Mechanism mechanism = read(slider_profile(R"([springs]
a = { joint = "slide", stiffness = 2, free_length = -5, damping = "3 N s/m" }
b = { joint = "slide", damping = 1 }
)"))
                                  .mechanism;
  EXPECT_EQ(mechanism.springs[0].stiffness, 2000);
  EXPECT_EQ(mechanism.springs[0].free, -0.005);
  EXPECT_EQ(mechanism.springs[0].damping, 3);
  EXPECT_EQ(mechanism.springs[1].damping, 1000);
  EXPECT_EQ(mechanism.springs[1].stiffness, 0);
}

TEST(ProfileReader, ADriverStartsWhereThePosesAre) {
  EXPECT_EQ(read(crank_profile("[bodies.crank.pose]\nangle = 37.7\n")).programs[0].start, 37.7);
  EXPECT_EQ(read(crank_profile("[bodies.crank.pose]\nangle = -400\n")).programs[0].start, -400);
  EXPECT_EQ(read(slider_profile()).programs[0].start, 14.5);  // 140 + 1.5 - 127
  EXPECT_EQ(read(slider_profile("", "180")).programs[0].start, -14.5);
  EXPECT_EQ(read(slider_profile("start = \"2 cm\"\n")).programs[0].start, 20);
}

TEST(ProfileReader, ADriverWithoutVelocityTurnsOneRadianOrSlidesOneUnitPerSecond) {
  EXPECT_DOUBLE_EQ(read(crank_profile()).programs[0].velocity, 180 / kPi);
  EXPECT_EQ(read(slider_profile()).programs[0].velocity, 1);
  const testing::Overrides minutes = {"units.time=min", "units.angle=rad"};
  const auto turning = read_profile_text(crank_profile(), "", minutes);
  const auto sliding = read_profile_text(slider_profile(), "", minutes);
  EXPECT_EQ(turning->programs[0].velocity, 60);
  EXPECT_EQ(sliding->programs[0].velocity, 60);
}

TEST(ProfileReader, PositionsKeepTheirDigits) {
  const Profile profile = read(crank_profile("positions = [0.1, 77.7, \"0.25 rev\", -3]\n"));
  EXPECT_EQ(profile.programs[0].positions, (std::vector<double>{0.1, 77.7, 90, -3}));
}

TEST(ProfileReader, SeveralDriversHaveNames) {
  const Profile profile = read(R"([bodies.ground]
points.A = [0, 0]
[bodies.crank]
points.A = [0, 0]
points.B = [31, 0]
[bodies.arm]
points.B = [0, 0]
[joints.one]
type = "revolute"
between = ["ground.A", "crank.A"]
[joints.two]
type = "revolute"
between = ["crank.B", "arm.B"]
[drivers.wrist]
joint = "two"
end = 10
[drivers.driver]
joint = "one"
end = 20
)");
  ASSERT_EQ(profile.mechanism.drivers.size(), 2U);
  EXPECT_EQ(profile.mechanism.drivers[0].name, "wrist");
  EXPECT_EQ(profile.mechanism.drivers[0].joint, 1);
  EXPECT_EQ(profile.mechanism.drivers[1].name, "driver");
  EXPECT_EQ(profile.programs[1].end, 20);
}

TEST(ProfileReader, TitleAndDescriptionAreFreeTexts) {
  const Mechanism mechanism =
      read(crank_profile("", "title = \"Größe\"\ndescription = \"\"\"two\nlines\"\"\"\n")).mechanism;
  EXPECT_EQ(mechanism.title, "Größe");
  EXPECT_EQ(mechanism.description, "two\nlines");
}

TEST(ProfileReader, IntegersMayBeWrittenAsDecimals) {
  EXPECT_EQ(read(crank_profile("samples = 1e3\n")).programs[0].samples, 1000);
}

TEST(ProfileReader, MassMayBeZeroAndInertiaLeftOut) {
  const Mechanism mechanism =
      read(crank_profile("[bodies.w]\nmass = 0\ncenter_of_mass = [1, 2]\n")).mechanism;
  ASSERT_TRUE(mechanism.bodies[2].mass);
  EXPECT_EQ(mechanism.bodies[2].mass->mass, 0);
  EXPECT_EQ(mechanism.bodies[2].mass->inertia, 0);
}

}  // namespace
}  // namespace higherpair
