#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using ::testing::IsEmpty;
using testing::lines_are;
using testing::messages;

// An arm on ground carries a planet; a sun turns about the arm's pivot. `gears` begins at line 22.
std::string planetary(const std::string& gears) {
  return R"([bodies.ground]
points.O = [0, 0]
[bodies.arm]
points.O = [0, 0]
points.P = [40, 0]
[bodies.sun]
points.O = [0, 0]
[bodies.planet]
pose = { x = 40, y = 0, angle = 10 }
points.P = [0, 0]
points.Q = [5, 0]
[joints.mesh]
)" + gears +
         R"([joints.arm_pivot]
type = "revolute"
between = ["ground.O", "arm.O"]
[joints.sun_pivot]
type = "revolute"
between = ["arm.O", "sun.O"]
[joints.planet_pivot]
type = "revolute"
between = ["arm.P", "planet.P"]
[driver]
joint = "arm_pivot"
)";
}

TEST(ProfileGears, FindTheArmThatCarriesBothWheels) {
  const Profile profile =
      testing::read(planetary("type = \"gears\"\nbetween = [\"sun.O\", \"planet.P\"]\nratio = 1.5\n"));
  const Joint& joint = profile.mechanism.joints.front();
  EXPECT_EQ(joint.type, JointType::kGears);
  EXPECT_EQ(profile.mechanism.bodies[joint.carrier].name, "arm");
  EXPECT_EQ(joint.turning_ratio, -1.5);
  // As in the poses.
  EXPECT_NEAR(joint.relative_angle, 10 * kPi / 180, 1e-16);
}

TEST(ProfileGears, TurnAlikeInARingAndInAnOpenBelt) {
  const auto ratio_of = [](const std::string& keys) {
    const Profile profile =
        testing::read(planetary(keys + "between = [\"ground.O\", \"planet.P\"]\nratio = 3\n"));
    return profile.mechanism.joints.front().turning_ratio;
  };
  EXPECT_EQ(ratio_of("type = \"gears\"\ninternal = true\n"), 3);
  EXPECT_EQ(ratio_of("type = \"belt\"\n"), 3);
  EXPECT_EQ(ratio_of("type = \"belt\"\ncrossed = true\n"), -3);
}

TEST(ProfileGears, SayWhatIsMissing) {
  EXPECT_TRUE(
      lines_are(messages(planetary("type = \"gears\"\nbetween = [\"sun.O\", \"planet.P\"]\nratio = -2\n")),
                {"test.toml:15:9: joints.mesh.ratio = -2: must be > 0"}));
  EXPECT_TRUE(
      lines_are(messages(planetary("type = \"gears\"\nbetween = [\"sun.O\", \"planet.P\"]\nratio = 1.1e9\n")),
                {"test.toml:15:9: joints.mesh.ratio = 1100000000: must be between 1e-9 and 1e9"}));
  EXPECT_TRUE(lines_are(messages(planetary("type = \"belt\"\nbetween = [\"sun.O\", \"planet.P\"]\n")),
                        {"test.toml:12:1: joints.mesh.ratio is missing: expected a number"}));
  EXPECT_TRUE(
      lines_are(messages(planetary("type = \"gears\"\nbetween = [\"sun.O\", \"planet.Q\"]\nratio = 2\n")),
                {"test.toml:14:11: joints.mesh.between = [\"sun.O\", \"planet.Q\"]: no body carries "
                 "both wheels: expected revolute "
                 "joints at these two points to one body, the arm or ground"}));
  EXPECT_TRUE(lines_are(
      messages(planetary(
          "type = \"gears\"\nbetween = [\"sun.O\", \"planet.P\"]\nratio = 2\ncarrier = \"ground\"\n")),
      {"test.toml:16:11: joints.mesh.carrier = \"ground\": expected a body that carries both wheels "
       "on pins at these points"}));
  EXPECT_TRUE(lines_are(
      messages(
          planetary("type = \"belt\"\nbetween = [\"sun.O\", \"planet.P\"]\nratio = 2\ninternal = true\n")),
      {"test.toml:16:1: joints.mesh.internal: unknown key; there are type, between, ratio, "
       "crossed, carrier"}));
}

const std::string kMesh = "type = \"gears\"\nbetween = [\"sun.O\", \"planet.P\"]\nratio = 1.5\n";

TEST(ProfileGears, HaveTeethWhereTheirPressureAngleOrModuleIsGiven) {
  const auto teeth_of = [](const std::string& keys) {
    return testing::read(planetary(kMesh + keys)).mechanism.joints.front().teeth;
  };
  EXPECT_FALSE(teeth_of(""));
  EXPECT_NEAR(teeth_of("pressure_angle = 25\n")->pressure_angle, 25 * kPi / 180, 1e-16);
  EXPECT_EQ(teeth_of("pressure_angle = 25\n")->module, 0);
  EXPECT_NEAR(teeth_of("module = 2\n")->pressure_angle, 20 * kPi / 180, 1e-16);
  EXPECT_EQ(teeth_of("module = 2\n")->module, 0.002);
}

TEST(ProfileGears, SayWhatTeethCannotBe) {
  EXPECT_TRUE(
      lines_are(messages(planetary(kMesh + "pressure_angle = 90\n")),
                {"test.toml:16:18: joints.mesh.pressure_angle = 90: must be below 90 deg; that of most "
                 "gears is 20 deg"}));
  EXPECT_TRUE(lines_are(messages(planetary(kMesh + "pressure_angle = 0\n")),
                        {"test.toml:16:18: joints.mesh.pressure_angle = 0 deg: must be > 0"}));
  EXPECT_TRUE(lines_are(messages(planetary(kMesh + "module = -2\n")),
                        {"test.toml:16:10: joints.mesh.module = -2 mm: must be > 0"}));
  EXPECT_TRUE(lines_are(
      messages(planetary("type = \"belt\"\nbetween = [\"sun.O\", \"planet.P\"]\nratio = 2\nmodule = 2\n")),
      {"test.toml:16:10: joints.mesh.module = 2: is of the teeth of gears; a belt passes on its "
       "torque alone"}));
  EXPECT_TRUE(lines_are(
      messages(planetary("type = \"gears\"\ninternal = true\nbetween = [\"ground.O\", \"planet.P\"]\n"
                         "ratio = 1\nmodule = 2\n")),
      {"test.toml:17:10: joints.mesh.module = 2: gears in a ring of the same size have one "
       "centre, and no teeth that could mesh"}));
}

TEST(ProfileGears, TeethOfWheelsWithOneCentreCannotMesh) {
  const std::string coaxial = R"([bodies.ground]
points.O = [0, 0]
[bodies.a]
points.O = [0, 0]
[bodies.b]
points.O = [0, 0]
[joints]
a_pivot = { type = "revolute", between = ["ground.O", "a.O"] }
b_pivot = { type = "revolute", between = ["ground.O", "b.O"] }
[joints.mesh]
type = "gears"
between = ["a.O", "b.O"]
ratio = 2
)";
  const std::string driver = "[driver]\njoint = \"a_pivot\"\n";
  EXPECT_THAT(messages(coaxial + driver), IsEmpty());
  EXPECT_TRUE(
      lines_are(messages(coaxial + "pressure_angle = 20\n" + driver),
                {"test.toml:12:11: joints.mesh.between = [\"a.O\", \"b.O\"]: both wheels turn about one "
                 "point: their teeth cannot mesh, so leave `pressure_angle` and `module` out"}));
}

TEST(ProfileGears, NotePartsOfTeeth) {
  const auto notes_of = [](const std::string& keys) {
    std::vector<std::string> notes;
    for (const Diagnostic& note : testing::read(planetary(kMesh + keys)).notes)
      notes.push_back(to_string(note));
    return notes;
  };
  EXPECT_THAT(notes_of("module = 2\n"), IsEmpty());  // 24 and 16 teeth
  EXPECT_THAT(notes_of("pressure_angle = 22\n"), IsEmpty());
  EXPECT_TRUE(
      lines_are(notes_of("module = 1.8\n"),
                {"test.toml:16:10: joints.mesh.module: makes wheels of 26.6667 and 17.7778 teeth; of a pair "
                 "with profile shift give `pressure_angle` as it is at the pitch circles, and no "
                 "`module`"}));
}

// No carrier is looked for, because it may depend on the pin that is wrong.
TEST(ProfileGears, WaitForPinsWhoseNamesAreRight) {
  std::string profile = planetary("type = \"gears\"\nbetween = [\"sun.O\", \"planet.P\"]\nratio = 2\n");
  profile.replace(profile.find("[\"ground.O\""), 11, "[\"ground.X\"");
  EXPECT_TRUE(
      lines_are(messages(profile), {"test.toml:18:12: joints.arm_pivot.between.0 = \"ground.X\": body "
                                    "`ground` has no point `X`; did you mean `O`?"}));
  profile.erase(profile.find("points.O = [0, 0]\n"), 18);
  EXPECT_TRUE(
      lines_are(messages(profile), {"test.toml:17:12: joints.arm_pivot.between.0 = \"ground.X\": body "
                                    "`ground` has no point `X`; none is defined"}));
}

TEST(ProfileGears, NeedTheNameOfTheCarrierWhereSeveralBodiesWouldDo) {
  const std::string two_wheels = R"([bodies.ground]
points.O = [0, 0]
points.P = [40, 0]
[bodies.frame]
points.O = [0, 0]
points.P = [40, 0]
[bodies.a]
points.O = [0, 0]
[bodies.b]
points.P = [40, 0]
[joints]
a1 = { type = "revolute", between = ["ground.O", "a.O"] }
b1 = { type = "revolute", between = ["ground.P", "b.P"] }
a2 = { type = "revolute", between = ["frame.O", "a.O"] }
b2 = { type = "revolute", between = ["frame.P", "b.P"] }
[driver]
joint = "a1"
[joints.mesh]
type = "gears"
between = ["a.O", "b.P"]
ratio = 2
)";
  EXPECT_TRUE(lines_are(messages(two_wheels),
                        {"test.toml:20:11: joints.mesh.between = [\"a.O\", \"b.P\"]: several bodies carry "
                         "both wheels (ground, "
                         "frame): expected carrier = \"...\", the one that keeps them in mesh"}));
  EXPECT_THAT(messages(two_wheels + "carrier = \"frame\"\n"), IsEmpty());
}

TEST(ProfileGears, AreNotDrivenAndCarryNoSpring) {
  const std::string mesh = "type = \"gears\"\nbetween = [\"sun.O\", \"planet.P\"]\nratio = 2\n";
  EXPECT_TRUE(
      lines_are(messages(planetary(mesh), {"driver.joint=mesh"}),
                {"override driver.joint=mesh: driver.joint = \"mesh\": gears and belts leave two freedoms: "
                 "expected a revolute or prismatic joint"}));
  EXPECT_TRUE(
      lines_are(messages(planetary(mesh) + "[springs.s]\njoint = \"mesh\"\nstiffness = 1\n"),
                {"test.toml:28:9: springs.s.joint = \"mesh\": gears and belts have no spring: expected "
                 "the joint of one of their wheels"}));
}

}  // namespace
}  // namespace higherpair
