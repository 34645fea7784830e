#include "higherpair/io/force_table.hpp"

#include "io/profile_testing.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::read;

constexpr const char* kPress = R"(
[bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
curves.disc = { type = "circle", center = [10, 0], radius = 30 }
[bodies.follower]
pose = { x = 0, y = 30 }
points.P = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = [0, -1] }
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
[loads]
down = { body = "follower", point = "P", force = [0, -12] }
)";

// The rows of a profile at one position of its driver.
struct Row {
  Row(const Profile& profile, double position)
      : run(start_run(profile.mechanism, {position}).value()),
        motion(MotionTable::make(profile, false).value()),
        table(ForceTable::make(profile, motion.columns()).value()) {
    move_to(run, {{position, 1, 0}});
    InverseDynamics dynamics(run);
    cells =
        table.cells(dynamics.solve(run), motion.cells(run.row, {{{position, 1, 0}, {position, 1, 0}}}, 0));
  }

  [[nodiscard]] const Cell& cell(const std::string& name) const {
    const auto& columns = table.columns();
    const auto found = std::find_if(columns.begin(), columns.end(),
                                    [&](const Column& column) { return column.name == name; });
    return cells.at(static_cast<std::size_t>(found - columns.begin()));
  }

  Run run;
  MotionTable motion;
  ForceTable table;
  std::vector<Cell> cells;
};

TEST(ForceTable, PutsItsColumnsBeforeStatusAndResidual) {
  const Profile profile = read(kPress);
  const MotionTable motion = MotionTable::make(profile, false).value();
  const ForceTable table = ForceTable::make(profile, motion.columns()).value();
  const std::size_t first = motion.columns().size() - 2;
  std::vector<std::string> added;
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    if (i < first) {
      EXPECT_EQ(table.columns()[i].name, motion.columns()[i].name);
    } else {
      added.push_back(table.columns()[i].name + " " + table.columns()[i].unit);
    }
  }
  EXPECT_THAT(added, ElementsAre("O.fx N", "O.fy N", "guide.fx N", "guide.fy N", "guide.m N*mm",
                                 "touch.force N", "touch.friction N", "driver.effort N*mm",
                                 "driver.effort_check N*mm", "status ", "residual mm"));
}

TEST(ForceTable, ShowsForcesAndTorquesInTheProfilesUnits) {
  const double theta = 0.5;
  for (const auto& [units, force, length] :
       {std::tuple("", 1.0, 1.0), std::tuple("units = { length = \"cm\", force = \"kN\" }\n", 1e3, 10.0)}) {
    const Row row(
        read(units + std::string(kPress),
             {"bodies.cam.curves.disc.center=[\"10 mm\", 0]", "bodies.cam.curves.disc.radius=\"30 mm\"",
              "bodies.follower.pose.y=\"30 mm\"", "loads.down.force=[0, \"-12 N\"]"}),
        theta);
    const double torque = 120 * std::cos(theta) / (force * length);
    EXPECT_NEAR(std::get<double>(row.cell("touch.force")), 12 / force, 1e-11 / force);
    EXPECT_EQ(std::get<double>(row.cell("touch.friction")), 0);
    EXPECT_NEAR(std::get<double>(row.cell("O.fy")), 12 / force, 1e-11 / force);
    EXPECT_NEAR(std::get<double>(row.cell("driver.effort")), torque, 1e-10 / force);
    EXPECT_NEAR(std::get<double>(row.cell("driver.effort_check")), torque, 1e-10 / force);
    EXPECT_NEAR(std::get<double>(row.cell("guide.m")), -torque, 1e-10 / force);
    EXPECT_EQ(std::get<std::string_view>(row.cell("status")), "ok");
  }
}

TEST(ForceTable, NamesTheEffortOfASlideInForceAndOfSeveralDriversByTheirNames) {
  const Profile slide = read(testing::slider_profile("end = 1\n"));
  const auto of = [](const Profile& profile) {
    return ForceTable::make(profile, MotionTable::make(profile, false).value().columns()).value();
  };
  const auto slide_table = of(slide);
  EXPECT_EQ(slide_table.columns()[slide_table.columns().size() - 4].unit, "N");
  std::string text = kPress;
  text.replace(text.find("[driver]"), 8, "[drivers.motor]");
  const auto table = of(read(text));
  EXPECT_EQ(table.columns()[table.columns().size() - 4].name, "driver.motor.effort");
  EXPECT_EQ(table.columns()[table.columns().size() - 3].name, "driver.motor.effort_check");
}

TEST(ForceTable, SaysThatAContactIsOpenAndKeepsItsPullingForce) {
  const Row row(read(kPress, {"loads.down.force=[0, 7]"}), 0.5);
  EXPECT_NEAR(std::get<double>(row.cell("touch.force")), -7, 1e-11);
  EXPECT_EQ(std::get<std::string_view>(row.cell("status")), "contact_open");
}

TEST(ForceTable, RefusesTwoColumnsOfOneName) {
  const Profile profile = read(kPress);
  std::vector<Column> motion = MotionTable::make(profile, false).value().columns();
  EXPECT_TRUE(ForceTable::make(profile, motion));
  motion.front().name = "guide.m";
  const auto refused = ForceTable::make(profile, motion);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error(), HasSubstr("'guide.m'"));
}

std::string sentence(const testing::Overrides& overrides, const Preload& preload, double low, double high,
                     ContactOpening::Kind kind = ContactOpening::Kind::kRoot) {
  const Profile profile = read(std::string(kPress) + R"([springs]
line = { between = ["ground.O", "follower.P"], stiffness = 2, free_length = 40 }
slide = { joint = "guide", stiffness = 2, free_length = 40 }
pivot = { joint = "O", stiffness = 2, free_angle = 40 }
damper = { joint = "guide", damping = 2 }
)",
                               overrides);
  PreloadNeed need;
  need.preload = preload;
  need.low = low;
  need.high = high;
  need.opened = true;
  return describe({0, kind, 0}, &need, profile);
}

constexpr double kNone = INFINITY;

TEST(Opening, IsDescribedWithThePreloadOfASpring) {
  EXPECT_EQ(
      sentence({}, {Preload::On::kSpring, 0}, 3, kNone),
      "from here on the contact would have to pull; it stays closed in all rows if springs.line pulls by "
      "3 N more (free_length 38.5 mm instead of 40 mm)");
  EXPECT_THAT(sentence({}, {Preload::On::kSpring, 0}, -kNone, -3),
              HasSubstr("springs.line pushes by 3 N more (free_length 41.5 mm instead of 40 mm)"));
  // A free length below 0 cannot be had.
  EXPECT_THAT(sentence({}, {Preload::On::kSpring, 0}, 90, kNone), Not(HasSubstr("free_length")));
  EXPECT_THAT(sentence({}, {Preload::On::kSpring, 1}, 90, kNone),
              HasSubstr("springs.slide pushes by 90 N more towards smaller coordinates (free_length -5 mm"));
  EXPECT_THAT(sentence({}, {Preload::On::kSpring, 2}, -kNone, -0.004),
              HasSubstr("springs.pivot turns by 4 N*mm more towards larger coordinates (free_angle 42 deg "
                        "instead of 40 deg)"));
  EXPECT_THAT(sentence({}, {Preload::On::kSpring, 3}, 2, kNone), Not(HasSubstr("instead")));
}

TEST(Opening, IsDescribedWithAnEffortOnAJointOrWithoutHope) {
  EXPECT_THAT(sentence({}, {Preload::On::kJoint, 1}, -kNone, -3),
              HasSubstr("if a constant force of -3 N acts on joints.guide"));
  EXPECT_THAT(sentence({}, {Preload::On::kJoint, 0}, 0.3, kNone),
              HasSubstr("if a constant torque of 300 N*mm acts on joints.O"));
  EXPECT_THAT(sentence({}, {Preload::On::kJoint, 1}, 3, 2),
              HasSubstr("no constant effort on joints.guide keeps it closed"));
  EXPECT_THAT(sentence({}, {Preload::On::kSpring, 0}, 3, 2),
              HasSubstr("no constant preload of springs.line keeps it closed"));
}

TEST(Opening, RoundsThePreloadUp) {
  EXPECT_THAT(sentence({}, {Preload::On::kJoint, 1}, 1.23456001, kNone), HasSubstr("1.23457 N"));
}

TEST(Opening, TellsItsKinds) {
  const Preload preload{Preload::On::kJoint, 1};
  EXPECT_THAT(sentence({}, preload, 1, kNone, ContactOpening::Kind::kPole), HasSubstr("a dead point"));
  EXPECT_THAT(sentence({}, preload, 1, kNone, ContactOpening::Kind::kPulled), HasSubstr("here already"));
  EXPECT_EQ(describe({0, ContactOpening::Kind::kRoot, 0}, nullptr, read(kPress)),
            "from here on the contact would have to pull");
}

}  // namespace
}  // namespace higherpair
