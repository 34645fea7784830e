#include "higherpair/io/profile_reader.hpp"
#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <utility>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::a_line_contains;
using testing::contains;
using testing::crank_profile;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kCamProfile;
using testing::lines_are;
using testing::messages;
using ::testing::Not;
using testing::part;
using testing::replaced;
using testing::slider_profile;

// The messages about the crank's profile with text appended to it from line 12 on.
std::vector<std::string> about(const std::string& more) {
  return messages(crank_profile(more));
}

// The messages about a curve of the crank whose table is at line 13, column 5.
std::vector<std::string> about_curve(const std::string& table) {
  return about("[bodies.crank.curves]\nc = " + table + "\n");
}

TEST(ProfileMessages, ThereAreNoneAboutTheProfilesTheyStartFrom) {
  EXPECT_THAT(messages(crank_profile()), IsEmpty());
  EXPECT_THAT(messages(slider_profile()), IsEmpty());
}

TEST(ProfileMessages, SayWhereAKeyOfTheDriverBelongs) {
  EXPECT_TRUE(lines_are(messages("start = 7\n" + crank_profile()),
                        {"test.toml:1:1: start: unknown key; did you mean `driver.start`?"}));
}

// Of one mistake, only itself is reported.
TEST(ProfileMessages, LeaveOutWhatIsOnlyMissingBecauseItsKeyIsMisspelt) {
  EXPECT_TRUE(lines_are(messages(replaced(kCamProfile, "joint        =", "joinx        =")),
                        {part("driver.joinx: unknown key; did you mean `joint`?")}));
  EXPECT_TRUE(lines_are(messages(replaced(kCamProfile, "[driver]", "[driverz]")),
                        {part("driverz: unknown key; did you mean `driver` or `drivers`?")}));
  EXPECT_TRUE(lines_are(messages(replaced(kCamProfile, "mass           =", "masx           =")),
                        {part("bodies.follower.masx: unknown key; did you mean `mass`?")}));
  EXPECT_TRUE(lines_are(messages(replaced(kCamProfile, "[bodies.follower]", "[bodiesz.follower]")),
                        {part("bodiesz: unknown key; did you mean `bodies`?")}));
}

TEST(ProfileMessages, SayOnceWhatIsNamedInSeveralPlacesAndDoesNotExist) {
  EXPECT_TRUE(
      lines_are(messages(replaced(kCamProfile, "[bodies.cam]", "[bodies.camq]")),
                {"test.toml:32:25: joints.cam_pivot.between.1 = \"cam.O\": there is no body `cam`; did "
                 "you mean `camq`? (likewise in line 39)"}));
}

TEST(ProfileMessages, LeaveOutThatAVariableIsNoNumberWhereItsNumberIsWrongItself) {
  const std::string variable =
      "[design]\nvariables.r = { path = \"bodies.cam.curves.disc.radius\", min = 1, max = 50 }\n"
      "[[design.objectives]]\ncolumn = \"follower.angle\"\nof = \"range\"\n";
  EXPECT_TRUE(lines_are(messages(replaced(kCamProfile, "radius = 20", "radius = \"20 kPa\"") + variable),
                        {part("kPa is a pressure, expected a length")}));
  EXPECT_TRUE(lines_are(messages(replaced(kCamProfile, "radius = 20", "radiux = 20") + variable),
                        {part("bodies.cam.curves.disc.radiux: unknown key; did you mean `radius`?")}));
}

TEST(ProfileMessages, LeaveOutWhatAnotherKeyThatIsMisspeltWouldMakeNeedless) {
  const std::string task =
      "[design]\nvariables.r = { path = \"bodies.cam.curves.disc.radius\", min = 1, max = 50 }\n"
      "[[design.objectives]]\n";
  EXPECT_TRUE(lines_are(
      messages(kCamProfile + task + "patx = { point = \"follower.E\", through = [[1, 2], [3, 4]] }\n"),
      {part("patx: unknown key; did you mean `path`?")}));
  EXPECT_TRUE(lines_are(messages(kCamProfile + task + "qqq = 3\n"),
                        {part("column is missing"), part("of is missing"), part("qqq: unknown key")}));
}

TEST(ProfileMessages, AskForTheKeyThatTheOthersBelongTo) {
  const std::string constraint = "[[design.constraints]]\ncurve = \"cam.disc\"\nbelow = 3\n";
  const std::string task =
      "[design]\nvariables.r = { path = \"bodies.cam.curves.disc.radius\", min = 1, max = 50 }\n";
  EXPECT_TRUE(lines_are(messages(kCamProfile + task + constraint),
                        {part("design.constraints.0.curve = \"cam.disc\": belongs to `figure`")}));
  EXPECT_TRUE(
      lines_are(messages(kCamProfile + task + constraint + "figurx = \"contacts.touch.convex_radius\"\n"),
                {part("figurx: unknown key; did you mean `figure`?")}));
}

TEST(ProfileMessages, KeepMistakesThatOnlyLookAlike) {
  EXPECT_TRUE(lines_are(messages(replaced(replaced(kCamProfile, "[bodies.follower]", "[bodiesz.follower]"),
                                          "\"cam.O\"", "\"camm.O\"")),
                        {part("bodiesz: unknown key"), part("there is no body `camm`")}));
  EXPECT_TRUE(
      lines_are(messages(replaced(replaced(kCamProfile, "\"cam.O\"", "\"camm.O\""), "cam.disc", "kam.disc")),
                {part("there is no body `camm`"), part("there is no body `kam`")}));
}

TEST(ProfileMessages, TellOfUnknownKeysOfAnOffsetBesideOtherMistakes) {
  EXPECT_TRUE(lines_are(
      messages(kCamProfile + std::string("[bodies.cam.curves.far]\ntype = \"offset\"\nof = \"diss\"\n"
                                         "by = \"abc\"\nmateriel = 3\n")),
      {part("far.of = \"diss\": body `cam` has no curve `diss`"),
       part("far.by = \"abc\": does not begin with a number"), part("far.materiel: unknown key")}));
}

TEST(ProfileMessages, TellTheAngleOfASlideFromItsDirection) {
  std::string text = slider_profile();
  const auto direction = text.find("direction");
  ASSERT_NE(direction, std::string::npos);
  EXPECT_TRUE(a_line_contains(messages(text.replace(direction, std::string("direction").size(), "angle")),
                              "(`angle` is how far the second body is turned)"));
}

TEST(ProfileMessages, ComeAllAtOnceInTheOrderOfTheFile) {
  EXPECT_TRUE(
      lines_are(messages(R"(format = 0
title = 3
[driver]
joint = "pivo"
samples = 0
[joints.pivot]
type = "revolut"
between = ["ground.A", "crank.B"]
[bodies.crank]
points.A = [0, 0, 0]
mass = -1
[units]
length = "furlong"
)"),
                {"test.toml:1:10: format = 0: expected format 1",
                 "test.toml:2:9: title = 3: expected a string, found an integer",
                 "test.toml:4:9: driver.joint = \"pivo\": there is no joint `pivo`; did you mean `pivot`?",
                 "test.toml:5:11: driver.samples = 0: must be an integer from 1 to 2^53",
                 "test.toml:7:8: joints.pivot.type = \"revolut\": expected one of revolute, prismatic, slot, "
                 "gears, belt; did you mean `revolute`?",
                 "test.toml:8:12: joints.pivot.between.0 = \"ground.A\": body `ground` has no point `A`; "
                 "none is defined",
                 "test.toml:8:24: joints.pivot.between.1 = \"crank.B\": body `crank` has no point `B`; "
                 "did you mean `A`?",
                 "test.toml:9:1: bodies.crank.center_of_mass is missing: expected [x, y]",
                 "test.toml:10:12: bodies.crank.points.A = [0, 0, 0]: expected a list of 2 numbers, found 3",
                 "test.toml:11:8: bodies.crank.mass = -1 kg: must be >= 0",
                 "test.toml:13:10: units.length = \"furlong\": expected one of m, cm, mm, um, km, in, ft"}));
}

TEST(ProfileMessages, ANewerFormatIsTheOnlyComplaint) {
  EXPECT_TRUE(lines_are(
      messages("format = 2\nnonsense = 3\n"),
      {"test.toml:1:10: format = 2: this profile needs a newer higherpair; this one reads format 1"}));
  EXPECT_TRUE(lines_are(
      messages(crank_profile("", "format = \"1\"\n")),
      {"test.toml:1:10: format = \"1\": expected an integer, found a string: leave the quotes out"}));
}

TEST(ProfileMessages, UnknownKeysGetTheNearestOne) {
  EXPECT_TRUE(lines_are(about("velocty = 3\n"),
                        {"test.toml:12:1: driver.velocty: unknown key; did you mean `velocity`?"}));
  EXPECT_TRUE(lines_are(
      messages(crank_profile("", "nonsense = 3\n")),
      {"test.toml:1:1: nonsense: unknown key; there are format, units, title, description, gravity, "
       "laws, bodies, joints, contacts, driver, drivers, loads, springs, drawing, limits, sweep, "
       "tolerances, design, fit, extra"}));
  EXPECT_TRUE(
      lines_are(about_curve("{ type = \"circle\", center = [0, 0], radius = 2, diameter = 4 }"),
                {"test.toml:13:53: bodies.crank.curves.c.diameter: unknown key; did you mean `radius`?"}));
  EXPECT_TRUE(lines_are(about_curve("{ type = \"circle\", center = [0, 0], radius = 2, colour = 4 }"),
                        {"test.toml:13:53: bodies.crank.curves.c.colour: unknown key; there are type, side, "
                         "center, radius"}));
  EXPECT_TRUE(lines_are(about("[bodies.crank.pose]\nz = 1\n"),
                        {"test.toml:13:1: bodies.crank.pose.z: unknown key; did you mean `x` or `y`?"}));
}

// The message about an unknown key at a place, for which `ours` is proposed.
std::vector<std::string> unknown(const std::string& place, const std::string& ours) {
  return {"test.toml:" + place + ": unknown key; did you mean " + ours + "?"};
}

// Names that textbooks and other programs use.
TEST(ProfileMessages, WordsOfTheFieldGetOurs) {
  const std::string types = ": expected one of revolute, prismatic, slot, gears, belt; did you mean ";
  const std::string between = "\nbetween = [\"ground.B\", \"crank.P\"]\n";
  for (const auto& [word, ours] :
       {std::pair("pin", "revolute"), std::pair("hinge", "revolute"), std::pair("Revolute", "revolute"),
        std::pair("slider", "prismatic"), std::pair("rail", "prismatic"), std::pair("pin-in-slot", "slot"),
        std::pair("chain", "belt")}) {
    EXPECT_TRUE(lines_are(
        about("[joints.j]\ntype = \"" + std::string(word) + "\"" + between),
        {"test.toml:13:8: joints.j.type = \"" + std::string(word) + "\"" + types + "`" + ours + "`?"}));
  }
  EXPECT_EQ(about("steps = 3\n"), unknown("12:1: driver.steps", "`samples`"));
  EXPECT_EQ(about("step = 3\n"), unknown("12:1: driver.step", "`samples` or `time_step`"));
  EXPECT_EQ(about("omega = 3\n"), unknown("12:1: driver.omega", "`velocity`"));
  EXPECT_EQ(about("from = 3\n"), unknown("12:1: driver.from", "`start`"));
  EXPECT_EQ(about("number = 3\n"), unknown("12:1: driver.number", "`samples`"));
  EXPECT_EQ(about("[bodies.x]\nangle = 3\n"), unknown("13:1: bodies.x.angle", "`pose`"));
  EXPECT_EQ(about("t_end = 3\n"), unknown("12:1: driver.t_end", "`duration`"));
  EXPECT_EQ(about_curve("{ type = \"circle\", centre = [0, 0], center = [0, 0], radius = 1 }"),
            unknown("13:24: bodies.crank.curves.c.centre", "`center`"));
  EXPECT_EQ(about_curve("{ type = \"ellipse\", center = [0, 0], semi_axes = [2, 1], a = 2 }"),
            unknown("13:62: bodies.crank.curves.c.a", "`semi_axes`"));
  EXPECT_EQ(about_curve("{ type = \"ellipse\", center = [0, 0], semi_axes = [2, 1], angle = 2 }"),
            unknown("13:62: bodies.crank.curves.c.angle", "`rotation`"));
  EXPECT_EQ(about("[springs]\ns = { between = [\"ground.A\", \"crank.P\"], stiffness = 1, preload = 2 }\n"),
            unknown("13:57: springs.s.preload", "`free_length`"));
  EXPECT_EQ(about("[springs]\ns = { joint = \"pivot\", stiffness = 1, preload = 2 }\n"),
            unknown("13:39: springs.s.preload", "`free_angle`"));
  EXPECT_EQ(about("[bodies.x]\nmass = 1\ncenter_of_mass = [0, 0]\nmoment_of_inertia = 2\n"),
            unknown("15:1: bodies.x.moment_of_inertia", "`inertia`"));
  EXPECT_EQ(messages(crank_profile("[links.x]\n")), unknown("12:2: links", "`bodies`"));
  EXPECT_TRUE(
      lines_are(about("[joints.j]\ntype = \"revolute\"\nbetween = [\"frame.B\", \"crank.P\"]\n"),
                {"test.toml:14:12: joints.j.between.0 = \"frame.B\": there is no body `frame`; did you mean "
                 "`ground`?"}));
  EXPECT_TRUE(
      lines_are(messages(crank_profile("", "[units]\nlength = \"millimeters\"\n")),
                {"test.toml:2:10: units.length = \"millimeters\": expected one of m, cm, mm, um, km, in, ft; "
                 "did you mean `mm`?"}));
}

TEST(ProfileMessages, ShortenedWordsAndCoordinatesGetOurKeys) {
  EXPECT_EQ(messages(crank_profile("", "[units]\nlen = \"mm\"\n")), unknown("2:1: units.len", "`length`"));
  EXPECT_EQ(about("points = [1, 2]\n"), unknown("12:1: driver.points", "`positions`"));
  const std::string spring = "[springs]\ns = { joint = \"pivot\", stiffness = 1, ";
  EXPECT_EQ(about(spring + "free = 2 }\n"), unknown("13:39: springs.s.free", "`free_angle`"));
  EXPECT_EQ(about(spring + "damp = 2 }\n"), unknown("13:39: springs.s.damp", "`damping`"));
  EXPECT_EQ(about(spring + "c = 2 }\n"), unknown("13:39: springs.s.c", "`damping` or `stiffness`"));
  EXPECT_EQ(about("[bodies.b]\nx = 1\n"), unknown("13:1: bodies.b.x", "`pose`"));
  EXPECT_EQ(about("[bodies.x]\ncog = [0, 0]\n"), unknown("13:1: bodies.x.cog", "`center_of_mass`"));
  const std::string joint = "[joints.j]\ntype = \"revolute\"\nbetween = [\"ground.B\", \"crank.P\"]\n";
  EXPECT_EQ(about(joint + "body1 = \"crank\"\n"), unknown("15:1: joints.j.body1", "`between`"));
  EXPECT_EQ(about(joint + "bodies = [\"ground\", \"crank\"]\n"),
            unknown("15:1: joints.j.bodies", "`between`"));
}

TEST(ProfileMessages, WordsThatAreFarAreNotProposed) {
  EXPECT_TRUE(lines_are(about("friction = 3\n"),
                        {"test.toml:12:1: driver.friction: unknown key; there are joint, law, start, end, "
                         "positions, velocity, acceleration, samples, duration, time_step"}));
  EXPECT_TRUE(lines_are(about("[joints.j]\ntype = \"prismatic\"\nbetween = [\"ground.A\", \"crank.P\"]\n"
                              "direction = 0\nfriction = 3\n"),
                        {"test.toml:16:1: joints.j.friction: unknown key; there are type, between, "
                         "direction, angle, from, to"}));
  EXPECT_TRUE(lines_are(messages(crank_profile("", "settings = 3\n")),
                        {part("1:1: settings: unknown key; there are format, units, ")}));
}

// However much of the table could not be read.
TEST(ProfileMessages, AboutAnUnknownKeyListAllKeysOfItsTable) {
  const auto keys = [](const std::string& text) {
    const std::vector<std::string> all = about(text);
    EXPECT_FALSE(all.empty());
    return all.empty() ? "" : all.back().substr(std::min(all.back().find("there are"), all.back().size()));
  };
  EXPECT_EQ(keys("[bodies.b]\nqqq = 1\n"), "there are points, curves, pose, mass, center_of_mass, inertia");
  EXPECT_EQ(keys("[springs]\ns = { qqq = 1 }\n"),
            "there are joint, between, stiffness, damping, free_length, free_angle");
  EXPECT_EQ(keys("[loads]\nd = { body = \"crank\", qqq = 1 }\n"),
            "there are body, torque, force, point, frame");
  EXPECT_EQ(keys("[laws]\nl = { qqq = 1 }\n"),
            "there are segments, points, file, repeat, origin, start, degree, smoothing, rounding");
  EXPECT_EQ(keys("[bodies.b.curves]\nc = { type = \"cam\", qqq = 1 }\n"),
            "there are type, law, contact, side");
  EXPECT_EQ(keys("[bodies.b.curves]\nc = { type = \"spline\", qqq = 1 }\n"),
            "there are type, side, material, closed, points, file, degree, smoothing, parameter, rounding");
  EXPECT_EQ(keys("[[design.objectives]]\nqqq = 1\n"),
            "there are path, follow, target, figure, reach, size, column, of, at, weight");
  EXPECT_EQ(keys("[[design.objectives]]\nfigure = \"contacts.a.gap\"\nqqq = 1\n"),
            "there are figure, curve, target, weight");
  EXPECT_EQ(keys("[[design.constraints]]\nreach = \"crank.P\"\nqqq = 1\n"),
            "there are reach, from, below, above");
}

// It is the likely cause; where it was probably meant to be the missing one, that one is not reported.
TEST(ProfileMessages, TellAnUnknownKeyBesideOneThatIsMissing) {
  EXPECT_TRUE(lines_are(
      messages(crank_profile(), {"springs.q.k=3"}),
      {part("springs.q.between is missing"), part("springs.q.k: unknown key; did you mean `stiffness`?")}));
  EXPECT_TRUE(lines_are(about("[springs]\ns = { between = [\"ground.A\", \"crank.P\"], k = 3 }\n"),
                        {"test.toml:13:42: springs.s.k: unknown key; did you mean `stiffness`?"}));
  EXPECT_TRUE(lines_are(about("[springs]\ns = { joint = \"pivo\", rate = 3 }\n"),
                        {part("there is no joint `pivo`"), part("did you mean `stiffness`?")}));
  EXPECT_TRUE(lines_are(about("[loads]\nd = { body = \"crank\", moment = 3 }\n"),
                        {part("loads.d.moment: unknown key; did you mean `torque`?")}));
  EXPECT_TRUE(lines_are(about("[laws]\nl = { parts = [] }\n"),
                        {part("laws.l.parts: unknown key; did you mean `segments`?")}));
}

TEST(ProfileMessages, NameTheKeyThatAnotherOneBelongsTo) {
  const auto of = [](const std::string& key) {
    return about("[[design.constraints]]\ncolumn = \"crank.angle\"\nof = \"max\"\nbelow = 1\n" + key +
                 " = \"x\"\n");
  };
  EXPECT_TRUE(a_line_contains(of("from"), "from = \"x\": belongs to `reach`"));
  EXPECT_TRUE(a_line_contains(of("curve"), "curve = \"x\": belongs to `figure`"));
}

TEST(ProfileMessages, TablesAndKeysThatLackAWordAreKnownAgain) {
  EXPECT_TRUE(
      lines_are(about("[joint.j]\n"), {"test.toml:12:2: joint: unknown key; did you mean `joints`?"}));
  EXPECT_TRUE(lines_are(about("[bodies.x]\npoint.A = [0, 0]\n"),
                        {"test.toml:13:1: bodies.x.point: unknown key; did you mean `points`?"}));
  EXPECT_TRUE(lines_are(about("[limits]\npressure_angle = 30\n"),
                        {part("limits.pressure_angle: unknown key; did you mean `max_pressure_angle`")}));
}

TEST(ProfileMessages, NamesArePathsWithoutTables) {
  EXPECT_TRUE(lines_are(messages(crank_profile(), {"driver.joint=joints.pivot"}),
                        {part("there is no joint `joints.pivot`; did you mean `pivot`?")}));
  const auto joint = [](const std::string& point) {
    return about("[joints.j]\ntype = \"revolute\"\nbetween = [\"ground.A\", \"" + point + "\"]\n");
  };
  EXPECT_TRUE(
      a_line_contains(joint("bodies.crank.P"), "there is no body `bodies.crank`; did you mean `crank`?"));
  EXPECT_TRUE(
      a_line_contains(joint("crank.points.P"), "body `crank` has no point `points.P`; did you mean `P`"));
}

TEST(ProfileMessages, ThingsHaveHeadingsOfTheirOwn) {
  EXPECT_TRUE(
      lines_are(about("[contacts]\nbetween = [\"crank.a\", \"ground.b\"]\n"),
                {"test.toml:13:11: contacts.between = [\"crank.a\", \"ground.b\"]: expected a contact "
                 "(a table) with a heading of its own, [contacts.NAME], found a list"}));
}

TEST(ProfileMessages, WordsOfTheFieldGetThoseOfTasks) {
  EXPECT_TRUE(a_line_contains(about("[[design.objectives]]\ncolumn = \"crank.angle\"\nof = \"maximum\"\n"),
                              "did you mean `max`?"));
  EXPECT_TRUE(a_line_contains(about("[sweep]\nmethod = \"monte-carlo\"\n"), "did you mean `random`?"));
  EXPECT_TRUE(a_line_contains(about("[tolerances]\nt = { path = \"driver.velocity\", tolerance = 1 }\n"),
                              "did you mean `plus_minus`?"));
}

TEST(ProfileMessages, AKeyThatRunsOnGetsTheTableThatItBeginsWith) {
  EXPECT_TRUE(lines_are(about("[bodies.x]\ncurvesoval = 3\n"),
                        {"test.toml:13:1: bodies.x.curvesoval: unknown key; did you mean `curves`?"}));
}

TEST(ProfileMessages, HeadingsAndQuotesThatAreTooMany) {
  EXPECT_TRUE(lines_are(messages("[[driver]]\njoint = \"a\"\n"),
                        {"test.toml:1:1: driver = [{…}]: a heading has one pair of brackets: [driver]"}));
  EXPECT_TRUE(
      lines_are(about("driver.end = 3\n"),
                {"test.toml:12:1: driver.driver: unknown key; under the heading [driver] its keys have no "
                 "`driver.` before them"}));
  EXPECT_TRUE(lines_are(
      about("samples = \"37\"\n"),
      {"test.toml:12:11: driver.samples = \"37\": expected an integer, found a string: leave the quotes "
       "out"}));
  EXPECT_THAT(about("[contacts.k]\nbetween = [\"ground.a\", \"crank.b\"]\nrolling = \"true\"\n").back(),
              "test.toml:14:11: contacts.k.rolling = \"true\": expected true or false, found a string: leave "
              "the quotes "
              "out");
  EXPECT_TRUE(contains(about_curve("{ type = \"circle\", center = \"[10, 0]\", radius = 5 }").front(),
                       "expected a list of 2 numbers, found a string: leave the quotes out"));
  EXPECT_TRUE(contains(about("[\"bodies.cam\"]\n").front(),
                       "bodies.cam: unknown key; a heading is written without quotes: [bodies.cam]"));
  EXPECT_TRUE(contains(about("[bodies.x]\n\"points.A\" = [0, 0]\n").front(),
                       "unknown key; a key is written without quotes: points.A"));
}

TEST(ProfileMessages, DecimalCommasInListsAndTexts) {
  EXPECT_TRUE(lines_are(
      about("[bodies.x]\npoints.A = [30,5, 2,25]\n"),
      {"test.toml:13:12: bodies.x.points.A = [30, 5, 2, 25]: expected a list of 2 numbers, found 4: "
       "decimals are written with a point, not a comma"}));
  EXPECT_TRUE(
      lines_are(about("[bodies.x]\npoints.A = [30,5, 0]\n"),
                {"test.toml:13:12: bodies.x.points.A = [30, 5, 0]: expected a list of 2 numbers, found 3: "
                 "decimals are written with a point, not a comma"}));
  EXPECT_TRUE(lines_are(messages(crank_profile(), {"driver.end=30,5 deg"}),
                        {"override driver.end=30,5 deg: driver.end = \"30,5 deg\": a decimal number is "
                         "written with a point: 30.5; "
                         "expected an angle, such as \"25.4 deg\""}));
}

TEST(ProfileMessages, UnitsAsTheyAreWrittenElsewhere) {
  const auto velocity = [](const std::string& unit) {
    const auto all = about("velocity = \"3 " + unit + "\"\n");
    return all.empty() ? "" : all.front().substr(all.front().find("\": ") + 3);
  };
  const std::string expected = "; expected an angular velocity, such as \"25.4 deg/s\"";
  EXPECT_EQ(velocity("degrees/s"), "degrees is no unit (did you mean `deg/s`?)" + expected);
  EXPECT_EQ(velocity("rad/sec"), "sec is no unit (did you mean `rad/s`?)" + expected);
  EXPECT_EQ(velocity("°/s"), "has the sign °: write deg" + expected);
  EXPECT_EQ(velocity("Hz"), "Hz is no unit: write rev/s" + expected);
  EXPECT_EQ(velocity("Nm"), "Nm is no unit" + expected);
  EXPECT_EQ(velocity("upm"), "upm is no unit (did you mean `rpm`?)" + expected);
}

TEST(ProfileMessages, AMereNumberForGravityIsShownAsAVector) {
  const auto about_gravity = [](const std::string& value) {
    return messages(crank_profile("", "gravity = " + value + "\n")).at(0);
  };
  const std::string place = "test.toml:1:11: gravity = ";
  EXPECT_EQ(about_gravity("-9810"), place + "-9810: expected [x, y]; downwards it is [0, -9810]");
  EXPECT_EQ(about_gravity("9.81"), place + "9.81: expected [x, y]; downwards it is [0, -9.81]");
  EXPECT_EQ(about_gravity("\"9.81 m/s^2\""),
            place + "\"9.81 m/s^2\": expected [x, y]; downwards it is [0, \"-9.81 m/s^2\"]");
  for (const char* text : {"\"0, -9.81\"", "\"[0,-9.81]\"", "\"9.81\"", "\"-9.81 N\""}) {
    EXPECT_EQ(about_gravity(text), place + text + ": expected [x, y]; downwards it is [0, \"-9.81 m/s^2\"]");
  }
  EXPECT_EQ(about_gravity("\"down\""),
            place + "\"down\": expected [x, y]; downwards it is [0, \"-9.81 m/s^2\"]");
  EXPECT_EQ(about_gravity("{ y = -9810 }"),
            place + "{…}: expected [x, y]; downwards it is [0, \"-9.81 m/s^2\"]");
  EXPECT_EQ(about_gravity("[0]"), place + "[0]: expected a list of 2 numbers, found 1");
}

TEST(ProfileMessages, KeysOfTheTopLevelAreToBeMovedUp) {
  EXPECT_TRUE(lines_are(
      about("gravity = [0, -9810]\n"),
      {"test.toml:12:1: driver.gravity: unknown key; it belongs to the top level: move it above the "
       "first [table]"}));
  EXPECT_TRUE(
      lines_are(about("[bodies]\ntitle = \"x\"\n"),
                {"test.toml:13:9: bodies.title = \"x\": it belongs to the top level: move it above the first "
                 "[table]"}));
  for (const char* table : {"limits", "drawing", "sweep", "design", "tolerances", "fit", "extra"}) {
    EXPECT_TRUE(lines_are(about(fmt::format("{}.a = 1\n", table)),
                          {part(fmt::format("driver.{}: unknown key; it belongs to the top level", table))}));
  }
  EXPECT_THAT(about("sweep = 90\n"), ElementsAre(Not(HasSubstr("top level"))));  // a number is no table
  // Not `units.time`, though that is near.
  EXPECT_TRUE(a_line_contains(messages(crank_profile("", "[units]\ntitle = \"x\"\n")),
                              "units.title: unknown key; it belongs to the top level"));
}

TEST(ProfileMessages, TheKeysOfASingleDriverHaveAHeadingOfTheirOwn) {
  std::string text = crank_profile("", "");
  text.replace(text.find("[driver]"), 8, "[drivers]");
  EXPECT_TRUE(lines_are(messages(text), {part("a single driver has the heading [driver]")}));
}

TEST(ProfileMessages, AWrongKindSaysWhatIsExpectedAndWhatIsFound) {
  EXPECT_TRUE(lines_are(
      about("start = true\nend = [1]\nsamples = \"many\"\npositions = 5\nduration = {}\n"),
      {"test.toml:12:9: driver.start = true: expected an angle (a number in deg or a string with its "
       "unit), found a boolean",
       "test.toml:13:7: driver.end = [1]: expected an angle (a number in deg or a string with its "
       "unit), found a list",
       "test.toml:14:11: driver.samples = \"many\": expected an integer, found a string",
       "test.toml:15:13: driver.positions = 5: expected a list, found an integer",
       "test.toml:16:12: driver.duration = {…}: expected a time (a number in s or a string with its "
       "unit), found a table"}));
  EXPECT_TRUE(lines_are(
      messages("bodies = 1\ndriver = 1979-05-27\n"),
      {"test.toml:1:10: bodies = 1: expected a table of names, each with a body (a table), found an "
       "integer",
       "test.toml:2:10: driver = (a date): expected a table, found a date"}));
  EXPECT_TRUE(lines_are(about("samples = 2.5\n"),
                        {"test.toml:12:11: driver.samples = 2.5: expected an integer, found a number"}));
  EXPECT_TRUE(lines_are(about("[bodies]\nx = 3\n"),
                        {"test.toml:13:5: bodies.x = 3: expected a body (a table) with a heading of its "
                         "own, [bodies.NAME], found an integer"}));
}

TEST(ProfileMessages, QuantitiesOfAnotherDimensionAreRefused) {
  EXPECT_TRUE(
      lines_are(about("velocity = \"3 mm/s\"\n"),
                {"test.toml:12:12: driver.velocity = \"3 mm/s\": mm/s is a velocity, expected an angular "
                 "velocity, such as deg/s"}));
  EXPECT_TRUE(
      lines_are(messages(slider_profile("velocity = \"300 rpm\"\n")),
                {"test.toml:13:12: driver.velocity = \"300 rpm\": rpm is an angular velocity, expected a "
                 "velocity, such as mm/s"}));
}

TEST(ProfileMessages, NumbersMustBeFinite) {
  EXPECT_TRUE(lines_are(about("start = nan\nend = -inf\n"),
                        {"test.toml:12:9: driver.start = nan: must be a finite number",
                         "test.toml:13:7: driver.end = -inf: must be a finite number"}));
  EXPECT_TRUE(lines_are(messages(crank_profile("[bodies.x]\npose.x = 1e308\n", "[units]\nlength = \"km\"\n")),
                        {"test.toml:15:10: bodies.x.pose.x = 1e+308: must be a finite number"}));
}

TEST(ProfileMessages, ProductsOfQuantitiesMustHaveAPlaceInADouble) {
  EXPECT_TRUE(
      lines_are(messages(crank_profile("[bodies.x]\npose.x = 1.1e53\npoints.far = [0, -1e60]\n")),
                {"test.toml:13:10: bodies.x.pose.x = 1.1e+53: must be at most 1e50 m: products of "
                 "larger numbers are out of range",
                 "test.toml:14:18: bodies.x.points.far.1 = -1e+60: must be at most 1e50 m: products of "
                 "larger numbers are out of range"}));
}

TEST(ProfileMessages, AnglesMustHaveAPlaceWithinTheTurn) {
  EXPECT_TRUE(
      lines_are(about("start = 1e300\nend = -3.7e20\n"),
                {"test.toml:12:9: driver.start = 1e+300: is more than 1e9 turns: its place within the "
                 "turn is rounding",
                 "test.toml:13:7: driver.end = -3.7e+20: is more than 1e9 turns: its place within the "
                 "turn is rounding"}));
  EXPECT_TRUE(lines_are(about("start = 3.5e11\nend = -3.5e11\n"), {}));
}

TEST(ProfileMessages, NamesAreWords) {
  EXPECT_TRUE(
      lines_are(about("[bodies.\"my cam\"]\n[bodies.2b]\n"),
                {"test.toml:12:9: bodies.my cam: a name begins with a letter from A to Z or a to z, or _, "
                 "and goes on with these, digits and -",
                 "test.toml:13:9: bodies.2b: a name begins with a letter from A to Z or a to z, or _, "
                 "and goes on with these, digits and -"}));
}

TEST(ProfileMessages, StayOnOneLineWhateverTheNames) {
  EXPECT_THAT(about("\"a\\nb\" = 1\n"),
              ElementsAre(::testing::StartsWith("test.toml:12:1: driver.a<U+000A>b: unknown key;")));
  EXPECT_TRUE(lines_are(messages(crank_profile(), {"driver.joint=a\nb"}),
                        {"override driver.joint=a<U+000A>b: driver.joint = \"a<U+000A>b\": there is no "
                         "joint `a<U+000A>b`; there is "
                         "only pivot"}));
}

TEST(ProfileMessages, ShowCharactersThatAreInvisibleOrLookLikeOthers) {
  for (const auto& [name, shown] : {std::pair("pivot\u200b", "pivot<U+200B>"),
                                    {"piv\u00adot", "piv<U+00AD>ot"},
                                    {"pivot\u00a0", "pivot<U+00A0>"},
                                    {"piv\u043et", "piv<U+043E>t"}}) {
    EXPECT_TRUE(lines_are(
        messages(replaced(crank_profile(), "joint = \"pivot\"", fmt::format("joint = \"{}\"", name))),
        {part(fmt::format("there is no joint `{}`; did you mean `pivot`?", shown))}));
  }
  EXPECT_TRUE(lines_are(about("[bodies.\"кулачок\"]\n"), {part("bodies.кулачок: a name begins")}));
}

TEST(ProfileMessages, CutLongValuesBetweenCharacters) {
  std::string text = "x";
  for (int i = 0; i < 40; ++i) text += "ö";
  EXPECT_TRUE(lines_are(about("samples = \"" + text + "\"\n"),
                        {"test.toml:12:11: driver.samples = \"" + text.substr(0, 39) +
                         "…\": expected an integer, found a string"}));
}

TEST(ProfileMessages, GroundHasNoPoseAndNoMass) {
  EXPECT_TRUE(lines_are(
      about("[bodies.ground.pose]\nx = 1\n"),
      {"test.toml:12:1: bodies.ground.pose = {…}: ground is the frame and never moves: it has no pose "
       "and no mass"}));
}

TEST(ProfileMessages, AnInertiaNeedsAMass) {
  EXPECT_TRUE(lines_are(
      about("[bodies.x]\ninertia = 1\n"),
      {"test.toml:13:11: bodies.x.inertia = 1: needs a mass beside it (mass = 0 if the inertia alone "
       "counts)"}));
  EXPECT_TRUE(lines_are(about("[bodies.x]\nmass = 1\ncenter_of_mass = [0, 0]\ninertia = -3\n"),
                        {"test.toml:15:11: bodies.x.inertia = -3 kg*mm^2: must be >= 0"}));
}

TEST(ProfileMessages, SizesOfCurvesMustBePositive) {
  EXPECT_TRUE(lines_are(about_curve("{ type = \"circle\", center = [0, 0], radius = -12 }"),
                        {"test.toml:13:50: bodies.crank.curves.c.radius = -12 mm: must be > 0"}));
  EXPECT_TRUE(lines_are(about_curve("{ type = \"circle\", center = [0, 0], radius = \"-12 in\" }"),
                        {"test.toml:13:50: bodies.crank.curves.c.radius = \"-12 in\": must be > 0"}));
  EXPECT_TRUE(lines_are(about_curve("{ type = \"ellipse\", center = [0, 0], semi_axes = [3, 0] }"),
                        {"test.toml:13:58: bodies.crank.curves.c.semi_axes.1 = 0 mm: must be > 0"}));
  EXPECT_TRUE(lines_are(about_curve("{ type = \"parabola\", vertex = [0, 0], focal_length = -1 }"),
                        {"test.toml:13:58: bodies.crank.curves.c.focal_length = -1 mm: must be > 0"}));
}

TEST(ProfileMessages, CurvesNeedATypeAndItsParts) {
  EXPECT_TRUE(
      lines_are(about_curve("{ center = [0, 0] }"),
                {"test.toml:13:5: bodies.crank.curves.c.type is missing: expected a kind of curve, such as "
                 "\"circle\""}));
  EXPECT_THAT(
      about_curve("{ type = \"splime\" }"),
      ElementsAre(::testing::AllOf(
          ::testing::HasSubstr("bodies.crank.curves.c.type = \"splime\": expected one of conic, circle, "),
          ::testing::HasSubstr("did you mean `spline`?"))));
  EXPECT_TRUE(
      lines_are(about_curve("{ type = \"circle\" }"),
                {"test.toml:13:5: bodies.crank.curves.c.center is missing: expected [x, y]",
                 "test.toml:13:5: bodies.crank.curves.c.radius is missing: expected a length (a number in mm "
                 "or a string with its unit)"}));
}

TEST(ProfileMessages, OnlyConicsHaveSides) {
  EXPECT_TRUE(
      lines_are(about_curve("{ type = \"point\", at = [0, 0], side = \"inside\" }"),
                {"test.toml:13:43: bodies.crank.curves.c.side = \"inside\": a line or point has no sides to "
                 "choose from"}));
  EXPECT_TRUE(lines_are(
      about_curve("{ type = \"circle\", center = [0, 0], radius = 1, side = \"out\" }"),
      {"test.toml:13:60: bodies.crank.curves.c.side = \"out\": expected one of inside, outside; did "
       "you mean `outside`?"}));
}

TEST(ProfileMessages, ConicsMustBeCurves) {
  const auto about_conic = [](const std::string& keys) {
    return about_curve("{ type = \"conic\", coefficients = " + keys + " }");
  };
  const std::string place = "test.toml:13:38: bodies.crank.curves.c.coefficients = ";
  EXPECT_TRUE(lines_are(
      about_conic("[16, -9, 0, 0, 0, -144]"),
      {place + "[16, -9, 0, 0, 0, -144]: is a hyperbola: near = [x, y] must say which branch is meant"}));
  EXPECT_TRUE(
      lines_are(about_conic("[16, -9, 0, 0, 0, -144], near = [0, 3]"),
                {place + "[16, -9, 0, 0, 0, -144]: is a hyperbola and `near` lies between its branches"}));
  EXPECT_TRUE(lines_are(about_conic("[1, 1, 0, 0, 0, 25]"),
                        {place + "[1, 1, 0, 0, 0, 25]: has no real point (imaginary conic)"}));
  EXPECT_TRUE(
      lines_are(about_conic("[1, 1, 0, 0, 0, 0]"),
                {place + "[1, 1, 0, 0, 0, 0]: is a single point (use type \"point\" for a knife edge)"}));
  EXPECT_TRUE(lines_are(
      about_conic("[1, -1, 0, 0, 0, 0]"),
      {place + "[1, -1, 0, 0, 0, 0]: is degenerate: a pair of lines (use type \"line\" for a flat face)"}));
  EXPECT_TRUE(lines_are(
      about_conic("[0, 0, 0, 1, 1, 0]"),
      {place + "[0, 0, 0, 1, 1, 0]: is no conic: A, B and C are all 0 (use type \"line\" for a flat face)"}));
  EXPECT_TRUE(lines_are(about_conic("[1, 1, 0, 0]"),
                        {place + "[1, 1, 0, 0]: expected a list of 6 numbers, found 4"}));
  EXPECT_TRUE(lines_are(
      about_conic("[1, \"1 mm\", 0, 0, 0, -1]"),
      {"test.toml:13:42: bodies.crank.curves.c.coefficients.1 = \"1 mm\": expected a number, found a "
       "string"}));
}

TEST(ProfileMessages, NormalsAndDirectionsMustPointSomewhere) {
  EXPECT_TRUE(
      lines_are(about_curve("{ type = \"line\", point = [0, 0], normal = [0, 0] }"),
                {"test.toml:13:47: bodies.crank.curves.c.normal = [0, 0]: must not be the zero vector"}));
  EXPECT_TRUE(lines_are(
      messages(slider_profile("", "\"y\"")),
      {"test.toml:10:13: joints.slide.direction = \"y\": is no direction: expected [dx, dy], such as "
       "[0, 1], or an angle, such as \"90 deg\""}));
  EXPECT_TRUE(lines_are(messages(slider_profile("", "[0, 0.0]")),
                        {"test.toml:10:13: joints.slide.direction = [0, 0]: must not be the zero vector"}));
}

// The messages about a second joint, whose keys begin at line 13.
std::vector<std::string> about_joint(const std::string& keys) {
  return about("[joints.j]\n" + keys);
}

TEST(ProfileMessages, JointsConnectPointsOfTwoBodies) {
  EXPECT_TRUE(
      lines_are(about_joint("type = \"revolute\"\nbetween = [\"crank.A\", \"crank.P\"]\n"),
                {"test.toml:14:11: joints.j.between = [\"crank.A\", \"crank.P\"]: both are on body `crank`: "
                 "expected two bodies"}));
  EXPECT_TRUE(
      lines_are(about_joint("type = \"revolute\"\nbetween = [\"crank.A\"]\n"),
                {"test.toml:14:11: joints.j.between = [\"crank.A\"]: expected two points on two bodies, "
                 "[\"body.point\", \"body.point\"]"}));
  EXPECT_TRUE(lines_are(about_joint("type = \"revolute\"\nbetween = [\"crank\", 3]\n"),
                        {"test.toml:14:12: joints.j.between.0 = \"crank\": expected \"body.point\"",
                         "test.toml:14:21: joints.j.between.1 = 3: expected a string, found an integer"}));
  EXPECT_TRUE(
      lines_are(about_joint("type = \"revolute\"\nbetween = [\"grund.A\", \"crank.Q\"]\n"),
                {"test.toml:14:12: joints.j.between.0 = \"grund.A\": there is no body `grund`; did you mean "
                 "`ground`?",
                 "test.toml:14:23: joints.j.between.1 = \"crank.Q\": body `crank` has no point `Q`; did you "
                 "mean `A` or `P`?"}));
  EXPECT_TRUE(
      lines_are(about_joint("type = \"revolute\"\n[bodies.crank.curves.c]\ntype = \"point\"\nat = [0, 0]\n"
                            "[joints.k]\ntype = \"revolute\"\nbetween = [\"crank.c\", \"ground.A\"]\n"),
                {"test.toml:12:1: joints.j.between is missing: expected two points, [\"body.point\", "
                 "\"body.point\"]",
                 "test.toml:19:12: joints.k.between.0 = \"crank.c\": this is a curve, expected a point"}));
}

TEST(ProfileMessages, EveryTypeOfJointHasItsKeys) {
  const std::string between = "between = [\"ground.B\", \"crank.P\"]\n";
  EXPECT_TRUE(lines_are(
      about_joint("type = \"slot\"\n" + between),
      {"test.toml:12:1: joints.j.direction is missing: expected an angle or [dx, dy] in the frame of "
       "the first body"}));
  EXPECT_TRUE(lines_are(
      about_joint("type = \"prismatic\"\n" + between),
      {"test.toml:12:1: joints.j.direction is missing: expected an angle or [dx, dy] in the frame of "
       "the first body"}));
  EXPECT_TRUE(
      lines_are(about_joint("type = \"slot\"\ndirection = 0\nangle = 5\n" + between),
                {"test.toml:15:9: joints.j.angle = 5: has a meaning for prismatic joints only: in the others "
                 "the body turns"}));
  EXPECT_TRUE(lines_are(about_joint("type = \"revolute\"\ndirection = 5\n" + between),
                        {"test.toml:14:13: joints.j.direction = 5: a revolute joint has no direction"}));
  EXPECT_TRUE(lines_are(about_joint(between),
                        {"test.toml:12:1: joints.j.type is missing: expected revolute, prismatic, "
                         "slot, gears or belt"}));
  for (const char* fixed : {"weld", "fixed", "rigid"}) {
    EXPECT_TRUE(
        lines_are(about_joint(fmt::format("type = \"{}\"\n", fixed) + between),
                  {fmt::format("test.toml:13:8: joints.j.type = \"{}\": bodies that are fixed to each "
                               "other are one body: give it the points and curves of both",
                               fixed)}));
  }
  EXPECT_TRUE(lines_are(about_joint("type = \"R\"\n" + between), {part("did you mean `revolute`?")}));
  EXPECT_TRUE(lines_are(about_joint("type = \"P\"\n" + between), {part("did you mean `prismatic`?")}));
  for (const char* misspelt : {"typ", "tpye", "kind"}) {
    EXPECT_TRUE(
        lines_are(about_joint(misspelt + (" = \"revolute\"\n" + between)),
                  {fmt::format("test.toml:13:1: joints.j.{}: unknown key; did you mean `type`?", misspelt)}));
  }
}

// The messages about a contact of a curve on ground and one on the crank; `between` is at line 18, column 11.
std::vector<std::string> about_contact(const std::string& on_ground, const std::string& on_crank) {
  return about("[bodies.ground.curves]\na = " + on_ground + "\n[bodies.crank.curves]\nb = " + on_crank +
               "\n[contacts.k]\n" + "rolling = false\n" + "between = [\"ground.a\", \"crank.b\"]\n");
}

constexpr const char* kLine = "{ type = \"line\", point = [0, 0], normal = 0 }";
constexpr const char* kPoint = "{ type = \"point\", at = [0, 0] }";
constexpr const char* kDisc = "{ type = \"circle\", center = [0, 0], radius = 3 }";
constexpr const char* kRing = "{ type = \"circle\", center = [0, 0], radius = 5, side = \"outside\" }";
constexpr const char* kParabola = "{ type = \"parabola\", vertex = [0, 0], focal_length = 2 }";

TEST(ProfileMessages, CurvesThatCannotTouchAreRefused) {
  const std::string place = "test.toml:18:11: contacts.k.between = [\"ground.a\", \"crank.b\"]: ";
  EXPECT_TRUE(lines_are(about_contact(kLine, kLine), {place + "two lines cannot make a contact"}));
  EXPECT_TRUE(lines_are(about_contact(kPoint, kPoint),
                        {place + "two points cannot make a contact (join them by a revolute joint)"}));
  EXPECT_TRUE(lines_are(about_contact(kLine, kRing),
                        {place + "a line cannot touch a concave curve (side = \"outside\")"}));
  EXPECT_TRUE(lines_are(about_contact(kRing, kLine),
                        {place + "a line cannot touch a concave curve (side = \"outside\")"}));
  EXPECT_TRUE(lines_are(about_contact(kRing, kRing),
                        {place + "two concave curves (side = \"outside\") cannot make a contact"}));
  EXPECT_TRUE(lines_are(
      about_contact("{ type = \"circle\", center = [0, 0], radius = 6 }", kRing),
      {place + "the convex curve is nowhere sharp enough to fit into the concave one (side = \"outside\")"}));
}

TEST(ProfileMessages, CurvesThatCanTouchAreAccepted) {
  EXPECT_THAT(about_contact(kLine, kPoint), IsEmpty());
  EXPECT_THAT(about_contact(kLine, kDisc), IsEmpty());
  EXPECT_THAT(about_contact(kLine, kParabola), IsEmpty());
  EXPECT_THAT(about_contact(kRing, kPoint), IsEmpty());
  EXPECT_THAT(about_contact(kRing, kDisc), IsEmpty());
  EXPECT_THAT(about_contact(kRing, kParabola), IsEmpty());
  EXPECT_THAT(about_contact(kDisc, kPoint), IsEmpty());
  EXPECT_THAT(about_contact(kDisc, kDisc), IsEmpty());
  // The ellipse is flat enough at the ends of its minor axis: 20²/3 > 6.
  EXPECT_THAT(
      about_contact("{ type = \"ellipse\", center = [0, 0], semi_axes = [20, 3], side = \"outside\" }",
                    "{ type = \"circle\", center = [0, 0], radius = 6 }"),
      IsEmpty());
}

TEST(ProfileMessages, ACurveWithAMistakeMakesNoSecondMistakeInItsContact) {
  EXPECT_TRUE(lines_are(
      about_contact(kLine, "{ type = \"line\", point = [0, 0] }"),
      {"test.toml:15:5: bodies.crank.curves.b.normal is missing: expected the outward normal, [nx, ny] "
       "or an angle"}));
}

TEST(ProfileMessages, ContactsAreBetweenCurves) {
  EXPECT_TRUE(lines_are(
      about("[contacts.k]\nbetween = [\"ground.A\", \"crank.c\"]\napproach = \"near\"\nrolling = 1\n"),
      {"test.toml:13:12: contacts.k.between.0 = \"ground.A\": this is a point, expected a curve",
       "test.toml:13:24: contacts.k.between.1 = \"crank.c\": body `crank` has no curve `c`; none "
       "is defined",
       "test.toml:14:12: contacts.k.approach = \"near\": expected one of nearest, +, -; did you mean "
       "`nearest`?",
       "test.toml:15:11: contacts.k.rolling = 1: expected true or false, found an integer"}));
}

TEST(ProfileMessages, DriversDriveRevoluteOrPrismaticJoints) {
  EXPECT_TRUE(lines_are(
      messages(
          "[bodies.ground]\npoints.A = [0, 0]\n[bodies.b]\npoints.A = [0, 0]\n[joints.j]\ntype = \"slot\"\n"
          "direction = 0\nbetween = [\"ground.A\", \"b.A\"]\n[driver]\njoint = \"j\"\nsamples = -1\nsped = "
          "3\n"),
      {"test.toml:10:9: driver.joint = \"j\": a slot leaves two freedoms: expected a revolute or "
       "prismatic joint",
       "test.toml:11:11: driver.samples = -1: must be an integer from 1 to 2^53",
       "test.toml:12:1: driver.sped: unknown key; there are joint, law, start, end, positions, velocity, "
       "acceleration, samples, duration, time_step"}));
  EXPECT_TRUE(lines_are(messages("[driver]\n"),
                        {"test.toml:1:1: driver.joint is missing: expected the name of a joint"}));
}

// A driver needs the position of its joint, and this joint has none.
TEST(ProfileMessages, AJointOnAPointThatGroundLacksMayBeDriven) {
  const std::string slide = R"([bodies.slide]
points.P = [0, 0]
[joints.guide]
type = "prismatic"
between = ["ground.O", "slide.P"]
direction = [1, 0]
[driver]
joint = "guide"
)";
  EXPECT_TRUE(lines_are(messages(slide), {part("body `ground` has no point `O`; none is defined")}));
  EXPECT_TRUE(lines_are(messages("[bodies.Ground]\npoints.O = [0, 0]\n" + slide),
                        {part("body `ground` has no point `O`, but body `Ground` has one: the frame has the "
                              "name `ground`")}));
  EXPECT_TRUE(lines_are(messages("[bodies.frame]\npoints.O = [0, 0]\n" + slide),
                        {part("body `ground` has no point `O`, but body `frame` has one: the frame has the "
                              "name `ground`")}));
}

TEST(ProfileMessages, ThereIsOneDriverOrAreNamedOnes) {
  EXPECT_TRUE(
      lines_are(about("[drivers.x]\njoint = \"pivot\"\n"),
                {"test.toml:12:1: drivers = {…}: expected either one [driver] or several [drivers.NAME], not "
                 "both",
                 "test.toml:13:9: drivers.x.joint = \"pivot\": another driver drives this joint already"}));
}

TEST(ProfileMessages, ADriverHasPositionsAndTimesThatMakeSense) {
  EXPECT_TRUE(lines_are(about("positions = []\nduration = -1\ntime_step = 0\n"),
                        {"test.toml:12:13: driver.positions = []: must have at least one position",
                         "test.toml:13:12: driver.duration = -1 s: must be >= 0",
                         "test.toml:14:13: driver.time_step = 0 s: must be > 0"}));
}

TEST(ProfileMessages, LoadsActOnMovingBodies) {
  EXPECT_TRUE(lines_are(
      about("[loads]\na = { body = \"crnk\", torque = 1 }\nb = { body = \"ground\", torque = 1 }\n"
            "c = { body = \"crank\" }\nd = { body = \"crank\", force = [1, 2], point = \"Z\", frame = "
            "\"world\" }\n"
            "e = { body = \"crank\", torque = 1, point = \"A\" }\n"),
      {"test.toml:13:14: loads.a.body = \"crnk\": there is no body `crnk`; did you mean `crank`?",
       "test.toml:14:14: loads.b.body = \"ground\": ground never moves: a load on it does nothing",
       "test.toml:15:5: loads.c.force is missing: expected [x, y] (or a torque)",
       "test.toml:16:47: loads.d.point = \"Z\": body `crank` has no point `Z`; did you mean `A` or "
       "`P`?",
       "test.toml:16:60: loads.d.frame = \"world\": expected one of ground, body; did you mean `ground`?",
       "test.toml:17:43: loads.e.point = \"A\": belongs to a force: a torque has no point"}));
}

TEST(ProfileMessages, SpringsActBetweenPointsOrOnAJoint) {
  EXPECT_TRUE(lines_are(
      about("[springs]\na = { joint = \"pivot\", between = [\"ground.A\", \"crank.P\"], stiffness = 1 }\n"
            "b = { stiffness = 1 }\nc = { joint = \"pivot\", stiffness = \"1 N/mm\" }\n"
            "d = { joint = \"pivot\", stiffness = 1, free_length = 3 }\n"
            "e = { between = [\"ground.A\", \"crank.P\"], stiffness = -1, free_length = -2 }\n"
            "f = { joint = \"pivt\", stiffness = 1 }\ng = { joint = \"pivot\" }\n"),
      {"test.toml:13:15: springs.a.joint = \"pivot\": a spring acts on a joint or between two points, "
       "not both",
       "test.toml:14:5: springs.b.between is missing: expected two points, [\"body.point\", "
       "\"body.point\"], or `joint` instead",
       "test.toml:15:36: springs.c.stiffness = \"1 N/mm\": N/mm is a stiffness, expected an angular "
       "stiffness, such as N*mm/deg",
       "test.toml:16:53: springs.d.free_length = 3: this spring has a free_angle",
       "test.toml:17:54: springs.e.stiffness = -1 N/mm: must be >= 0",
       "test.toml:17:72: springs.e.free_length = -2 mm: must be >= 0",
       "test.toml:18:15: springs.f.joint = \"pivt\": there is no joint `pivt`; did you mean `pivot`?",
       "test.toml:19:5: springs.g.stiffness is missing: expected an angular stiffness (or a damping)"}));
}

TEST(ProfileMessages, OfTheDrawingNameWhatThereIs) {
  EXPECT_TRUE(lines_are(about("[drawing]\ncrnk = { hide = true }\n"),
                        {"test.toml:13:8: drawing.crnk: there is no body `crnk`; did you mean `crank`?"}));
  EXPECT_TRUE(lines_are(
      about("[drawing.crank]\npoints.Q = { hide = true }\ncurves.disc = {}\n"),
      {"test.toml:13:12: drawing.crank.points.Q: body `crank` has no point `Q`; did you mean `A` or "
       "`P`?",
       "test.toml:14:15: drawing.crank.curves.disc: body `crank` has no curve `disc`; none is "
       "defined"}));
  EXPECT_TRUE(
      lines_are(about("[drawing.crank]\ncolour = \"red\"\ncolor = \"#fff\"\noutline = 1\n"),
                {"test.toml:13:10: drawing.crank.colour = \"red\": expected a colour as \"#rrggbb\", such as "
                 "\"#0072b2\"",
                 "test.toml:14:1: drawing.crank.color: unknown key; did you mean `colour`?",
                 "test.toml:15:11: drawing.crank.outline = 1: expected true or false, found an integer"}));
  EXPECT_TRUE(lines_are(about("[drawing.crank]\npoints.A = { outline = true }\n"),
                        {"test.toml:13:24: drawing.crank.points.A.outline = true: a point has none"}));
  EXPECT_TRUE(lines_are(about("[drawing]\ncrank = 3\n"),
                        {"test.toml:13:9: drawing.crank = 3: expected what a body looks like (a table) with "
                         "a heading of its own, [drawing.NAME], found an integer"}));
  EXPECT_THAT(about("[drawing.crank]\nname = \"Kurbel\"\ncolour = \"#FFf\"\npoints.A = { name = \"a\", hide "
                    "= true }\n"),
              IsEmpty());
}

}  // namespace
}  // namespace higherpair
