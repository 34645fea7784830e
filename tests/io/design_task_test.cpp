// [design] of a profile: what it means, and every mistake with its position.
#include "higherpair/io/design_task.hpp"

#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::a_line_contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::lines_are;
using testing::part;

// A crank; lines 1 to 13.
const std::string kCrank = R"([bodies.ground]
points.O = [0, 0]
[bodies.crank]
pose = { angle = 20 }
points = { O = [0, 0], A = [20, 0], B = ["1 in", 5] }

[joints.pivot]
type = "revolute"
between = ["ground.O", "crank.O"]
[driver]
joint = "pivot"
samples = 5
[design.variables]
)";
const std::string kVariable = "length = { path = \"bodies.crank.points.A.0\", min = 5, max = 50 }\n";
const std::string kObjective = "[[design.objectives]]\ncolumn = \"crank.A.y\"\nof = \"max\"\n";

TEST(DesignTask, IsReadWithEveryKey) {
  const Profile profile = testing::read(
      kCrank +
      R"(length = { path = ["bodies.crank.points.A.0"], min = 5, max = 50, step = 0.5, log = true }
[[design.objectives]]
column = "crank.A.y"
of = "max"
target = 12
weight = 3
[[design.objectives]]
path = { point = "crank.A", through = [[1, 2], [3, 4]], timed = true, at = [0, 90] }
[[design.objectives]]
column = "crank.angle"
follow = [[0, 1], [90, 2]]
[[design.constraints]]
column = "crank.A.x"
of = "min"
above = -3
below = 5
[design]
method = "slsqp"
keep_branch = true
starts = 7
seed = 12
target = 1e-3
)");
  ASSERT_TRUE(profile.design);
  const DesignTask& task = *profile.design;
  ASSERT_EQ(task.variables.size(), 1U);
  EXPECT_TRUE(lines_are(task.variables[0].paths, {"bodies.crank.points.A.0"}));
  EXPECT_EQ(task.variables[0].range.start, 20);
  EXPECT_EQ(task.variables[0].range.step, 0.5);
  EXPECT_TRUE(task.variables[0].range.log);
  ASSERT_EQ(task.objectives.size(), 3U);
  EXPECT_EQ(task.objectives[0].target, 12);
  EXPECT_EQ(task.objectives[0].weight, 3);
  ASSERT_TRUE(task.objectives[1].path());
  EXPECT_EQ(task.objectives[1].path()->through[1], Vector2d(0.003, 0.004));
  EXPECT_THAT(task.objectives[1].path()->at, ElementsAre(0, 90));
  ASSERT_TRUE(task.objectives[2].followed());
  EXPECT_THAT(task.objectives[2].followed()->values, ElementsAre(1, 2));
  EXPECT_EQ(task.objectives[2].followed()->at[1], 90);
  ASSERT_EQ(task.constraints.size(), 1U);
  EXPECT_EQ(task.constraints[0].above, -3);
  EXPECT_EQ(task.constraints[0].below, 5);
  EXPECT_EQ(task.method, DesignMethod::kSlsqp);
  EXPECT_TRUE(task.keep_branch);
  EXPECT_EQ(task.starts, 7);
  EXPECT_EQ(task.seed, 12U);
  EXPECT_EQ(task.target, 1e-3);
}

// Of a contact the dimension is that of the joint on which it moves the follower.
TEST(DesignTask, TakesTheJerkOfAContactInAnyUnit) {
  const std::string slides =
      "type = \"prismatic\"\ndirection = [0, 1]\nbetween = [\"ground.O\", \"tappet.P\"]";
  const std::string turns = "type = \"revolute\"\nbetween = [\"ground.P\", \"tappet.P\"]";
  const auto text =
      [](const std::string& guide, const std::string& limit) {
        return R"([bodies.ground]
points = { O = [0, 0], P = [70, 0] }
[bodies.cam]
points.O = [0, 0]
curves.disc = { type = "circle", center = [10, 0], radius = 30 }
[bodies.tappet]
pose.y = 30
points.P = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = [0, -1] }
[contacts.touch]
between = ["cam.disc", "tappet.face"]
[joints.pivot]
type = "revolute"
between = ["ground.O", "cam.O"]
[joints.guide]
)" + guide + R"(
[driver]
joint = "pivot"
samples = 5
[design.variables]
radius = { path = "bodies.cam.curves.disc.radius", min = 5, max = 50 }
[[design.objectives]]
column = "touch.jerk"
of = "maxabs"
[[design.constraints]]
column = "touch.jerk_linkage"
of = "max"
below = )" + limit;
      };
  EXPECT_NEAR(*testing::read(text(slides, "\"2 m/s^3\"")).design->constraints[0].below, 2000, 1e-9);
  EXPECT_NEAR(*testing::read(text(turns, "\"2 rad/s^3\"")).design->constraints[0].below, 360 / kPi, 1e-9);
  EXPECT_TRUE(lines_are(testing::messages(text(turns, "\"2 m/s^3\"")),
                        {part("design.constraints.0.below = \"2 m/s^3\": ")}));
  EXPECT_TRUE(lines_are(
      testing::messages(text("type = \"revolute\"\nbetween = [\"ground.X\", \"tappet.P\"]", "\"2 m/s^3\"")),
      {part("body `ground` has no point `X`")}));
}

struct Wrong {
  std::string text;
  std::string message;
};

const Wrong kWrongVariables[] = {
    Wrong{R"(a = { path = "bodies.crank.point.A.0", min = 5, max = 50 })",
          "test.toml:14:14: design.variables.a.path = \"bodies.crank.point.A.0\": there is no number at "
          "this path; "
          "did you mean `bodies.crank.points.A.0`"},
    Wrong{R"(a = { path = "joints.pivot.type", min = 5, max = 50 })",
          "this is \"revolute\", a text: expected the path of a number"},
    Wrong{R"(a = { path = "bodies.crank.points.B.0", min = "1.1 in", max = 50 })",
          "the profile has bodies.crank.points.B.0 = 25.4, which is outside"},
    Wrong{R"(a = { path = ["bodies.crank.points.A.0", "bodies.crank.pose.angle"], min = "1 mm", max = 50 })",
          "bodies.crank.points.A.0 and bodies.crank.pose.angle have different units: write a plain number"},
    Wrong{R"(a = { path = [{ path = "bodies.crank.points.A.0", times = "2 mm" }], min = 1, max = 50 })",
          "times = \"2 mm\": this has no unit: write a plain number"},
    Wrong{R"(a = { path = "bodies.crank.points.A", min = 5, max = 50 })",
          "this is a list, not one number; go on to the number itself, such as bodies.crank.points.A.0"},
    Wrong{R"(a = { path = "driver.samples", min = 5, max = 50 })", "this number is none of the mechanism's"},
    Wrong{R"(a = { path = "bodies.crank.points.A.0", min = 50, max = 5 })",
          "test.toml:14:47: design.variables.a.min = 50: must be less than max = 5; the two are the "
          "wrong way round"},
    Wrong{R"(a = { path = "bodies.crank.points.A.0", min = 20, max = 20 })",
          "must be less than max = 20; a fixed number is no variable"},
    Wrong{R"(a = { path = "bodies.crank.points.A.0", min = 25, max = 50 })",
          "min = 25: the profile has bodies.crank.points.A.0 = 20, which is outside; the search begins "
          "there"},
    Wrong{R"(a = { path = "bodies.crank.points.A.0", min = 5, max = 15 })", "max = 15: the profile has"},
    Wrong{R"(a = { path = "bodies.crank.points.A.0", min = -5, max = 50, log = true })",
          "must be > 0 with `log`: logarithms have no 0"},
    Wrong{R"(a = { path = "bodies.crank.points.A.0", min = 19, max = 24, step = 25 })",
          "step = 25: no multiple of it lies between min and max"},
    Wrong{R"(a = { path = "bodies.crank.points.A.0", min = 5, max = 50, step = 0 })",
          "step = 0: expected a number > 0"},
    Wrong{R"(a = { path = "bodies.crank.points.A.0", min = "5 deg", max = 50 })",
          "design.variables.a.min = \"5 deg\": deg is an angle, expected a length, such as mm"},
    Wrong{R"(a = { path = "bodies.crank.points.A.0", min = 5, max = "50 mn" })",
          "design.variables.a.max = \"50 mn\": "},
    Wrong{R"(a = { path = ["bodies.crank.points.A.0", "bodies.crank.points.B.1"], min = 1, max = 50 })",
          "this number is 5, but by the first one of this variable it is to be 20: write "
          "that into the profile"},
    Wrong{R"(a = { path = "bodies.crank.points.A.0", min = 5, max = 50 }
b = { path = "bodies.crank.points.A.0", min = 5, max = 50 })",
          "test.toml:15:14: design.variables.b.path = \"bodies.crank.points.A.0\": this number is "
          "variable `a` already"},
    Wrong{R"(a = { min = 5, max = 50 })", "path"},
    Wrong{R"(a = { path = [], min = 5, max = 50 })", "or a list of such paths"}};

TEST(DesignVariables, SayWhatIsWrong) {
  for (const Wrong& wrong : kWrongVariables) {
    SCOPED_TRACE(wrong.text);
    EXPECT_TRUE(lines_are(testing::messages(kCrank + wrong.text + "\n" + kObjective), {part(wrong.message)}));
  }
}

const Wrong kWrongGoals[] = {
    Wrong{"[[design.objectives]]\npath = { point = \"crank.C\", through = [[0, 1], [2, 3]] }",
          "body `crank` has no point `C`"},
    Wrong{"[[design.objectives]]\npath = { point = \"ground.O\", through = [[0, 1], [2, 3]] }",
          "a point of ground does not move"},
    Wrong{"[[design.objectives]]\npath = { point = \"crank.A\", through = [[0, 1]] }",
          "expected at least two points: one alone is no path"},
    Wrong{"[[design.objectives]]\npath = { point = \"crank.A\", through = [[0, 1], [2, 3], [2, 3]] }",
          "points 2 and 3 are the same: leave one out"},
    Wrong{"[[design.objectives]]\npath = { point = \"crank.A\", through = [[0, \"1 deg\"], [2, 3]] }",
          "deg is an angle"},
    Wrong{"[[design.objectives]]\npath = { point = \"crank.A\", through = [[0, 1], [2, 3]], at = [1, 2] }",
          "holds for a path with timed = true"},
    Wrong{"[[design.objectives]]\npath = { point = \"crank.A\", timed = true, through = [[0, 1], [2, "
          "3]], at = [1] }",
          "expected a list of 2 positions of the driver, one for each point"},
    Wrong{"[[design.objectives]]\npath = { point = \"crank.A\", timed = true, closed = true, through = "
          "[[0, 1], [2, 3]] }",
          "the points of a timed path have their rows"},
    Wrong{"[[design.objectives]]\npath = { point = \"crank.A\" }", "through"},
    Wrong{kObjective + "target = \"3 deg\"",
          "design.objectives.0.target = \"3 deg\": deg is an angle, expected a length, such as mm"},
    Wrong{kObjective + "weight = \"3 mm\"", "weight = \"3 mm\": this has no unit: write a plain number"},
    Wrong{kObjective + "[design]\ntarget = \"3 mm\"", "design.target = \"3 mm\": this has no unit"},
    Wrong{"[[design.objectives]]\ncolumn = \"crank.A.z\"\nof = \"max\"\ntarget = \"3 mm\"",
          "target = \"3 mm\": the unit of `crank.A.z` is not known here: write a plain number, in the unit "
          "of tables"},
    Wrong{kObjective + "weight = -1", "weight = -1: must be > 0"},
    Wrong{kObjective + "below = 3", "below"},
    Wrong{"[[design.objectives]]\ncolumn = \"crank.angle\"\nfollow = [[0, 1]]",
          "expected a list of at least two pairs"},
    Wrong{kObjective + "[[design.constraints]]\ncolumn = \"crank.A.y\"\nof = \"min\"",
          "design.constraints.0: a limit is missing: below = … or above = …"},
    Wrong{kObjective + "[[design.constraints]]\ncolumn = \"crank.A.y\"\nof = \"min\"\nabove = 3\nbelow = 2",
          "design.constraints.0: nothing is above 3 and below 2"},
    Wrong{kObjective + "[[design.constraints]]\ncolumn = \"crank.A.y\"\nof = \"min\"\nabove = \"3 "
                       "rad\"",
          "design.constraints.0.above = \"3 rad\": rad is an angle, expected a length"},
    Wrong{kObjective + "[[design.constraints]]\nfigure = \"contacts.c.contact_ratio\"\nabove = \"3 mm\"",
          "above = \"3 mm\": contact_ratio has no unit: write a plain number"},
    Wrong{kObjective + "[[design.constraints]]\ntransmission = \"pivo\"\nabove = 3", "did you mean `pivot`"},
    Wrong{kObjective + "[[design.constraints]]\ntransmission = \"pivot\"\nabove = 95",
          "design.constraints.0: a transmission angle is from 0 to 90 deg, not 95"},
    Wrong{kObjective + "[design]\nmethod = \"newton\"", "slsqp"},
    Wrong{kObjective + "[design]\nstarts = 0", "from 1"}};

TEST(DesignGoals, SayWhatIsWrong) {
  for (const Wrong& wrong : kWrongGoals) {
    SCOPED_TRACE(wrong.text);
    EXPECT_TRUE(a_line_contains(testing::messages(kCrank + kVariable + wrong.text), wrong.message));
  }
}

TEST(DesignTask, EveryWrongWordOfAFreePathIsReported) {
  const auto all = testing::messages(
      kCrank + kVariable +
      "[[design.objectives]]\npath = { point = \"crank.A\", through = [[0, 1], [2, 3]], free = [\"turm\", "
      "\"position\", \"scal\"] }");
  EXPECT_TRUE(a_line_contains(all, "did you mean `turn`"));
  EXPECT_TRUE(a_line_contains(all, "did you mean `scale`"));
  EXPECT_TRUE(a_line_contains(all, "two have no form but their distance"));
}

// One mistake, one message: an unreadable limit is not reported as missing, nor an absent file as having too
// few points.
TEST(DesignTask, NumbersMayHaveTheirOwnUnit) {
  const Profile profile = testing::read(
      kCrank +
      R"(length = { path = [{ path = "bodies.crank.points.A.0", times = 1 }], min = "0.2 in", max = "5 cm", step = "500 um" }
inch = { path = "bodies.crank.points.B.0", min = 20, max = "2 in" }
[[design.objectives]]
column = "crank.A.y"
of = "at"
at = "0.25 rev"
target = "1.2 cm"
[[design.objectives]]
path = { point = "crank.A", through = [[1, 2], [3, 4]], timed = true, at = [0, "0.5 rev"] }
[[design.objectives]]
column = "crank.angle"
follow = [["0.25 rev", "0.125 rev"], [180, 2]]
[[design.objectives]]
figure = "contacts.touch.contact_pressure"
target = "2 kN/cm^2"
[[design.objectives]]
size = "width"
target = "1 m"
[[design.constraints]]
column = "crank.alpha"
of = "maxabs"
below = "1 rev/s^2"
[[design.constraints]]
transmission = "pivot"
above = "0.125 rev"
)");
  ASSERT_TRUE(profile.design);
  const DesignTask& task = *profile.design;
  EXPECT_EQ(task.variables[0].range.low, 5.08);
  EXPECT_EQ(task.variables[0].range.high, 50);
  EXPECT_EQ(task.variables[0].range.step, 0.5);
  EXPECT_EQ(task.variables[0].unit, "mm");
  EXPECT_EQ(task.variables[1].range.start, 25.4);
  EXPECT_EQ(task.variables[1].range.low, 20);
  EXPECT_EQ(task.variables[1].range.high, 50.8);
  EXPECT_EQ(std::get<Measure>(task.objectives[0].of).at, 90);
  EXPECT_EQ(task.objectives[0].target, 12);
  EXPECT_THAT(task.objectives[1].path()->at, ElementsAre(0, 180));
  EXPECT_EQ(task.objectives[2].followed()->at[0], 90);
  EXPECT_THAT(task.objectives[2].followed()->values, ElementsAre(45, 2));
  EXPECT_EQ(task.objectives[3].target, 20);  // N/mm^2
  EXPECT_EQ(task.objectives[4].target, 1000);
  EXPECT_EQ(task.constraints[0].below, 360);
  EXPECT_EQ(task.constraints[1].above, 45);
}

TEST(DesignTask, ASlipIsReportedOnce) {
  for (const char* goal :
       {"[[design.objectives]]\npath = { point = \"crank.A\", file = \"none.csv\", free = [\"position\"] }",
        "[[design.objectives]]\npath = { point = \"crank.A\", through = [[0, 1]], free = [\"position\"] }",
        "[[design.objectives]]\ncolumn = \"crank.A.y\"\nof = \"max\"\n[[design.constraints]]\ncolumn = "
        "\"crank.A.y\"\nof = \"min\"\nabove = \"3 s\""}) {
    EXPECT_EQ(testing::messages(kCrank + kVariable + goal).size(), 1U) << goal;
  }
  EXPECT_TRUE(lines_are(
      testing::messages(kCrank + kVariable +
                        "[[design.objectives]]\npath = { point = \"crank.A\", through = [[0, 1], [2, 3]], "
                        "free = [\"position\"] }"),
      {part("two have no form but their distance")}));
}

TEST(DesignTask, MistakesAreReportedAllAtOnce) {
  EXPECT_EQ(
      testing::messages(
          kCrank + "a = { path = \"x\", min = 1, max = 0 }\n[[design.objectives]]\ncolumn = \"crank.x\"\n")
          .size(),
      2U);
}

TEST(DesignTask, IsNoneWithoutItsTable) {
  EXPECT_EQ(testing::read(kCrank.substr(0, kCrank.find("[design"))).design, nullptr);
  EXPECT_THAT(testing::messages(kCrank + kVariable + kObjective), IsEmpty());
}

}  // namespace
}  // namespace higherpair
