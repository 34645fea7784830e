#include "higherpair/io/notes.hpp"

#include "higherpair/analysis/run.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::crank_profile;
using ::testing::IsEmpty;
using testing::lines_are;
using testing::part;
using ::testing::SizeIs;
using testing::slider_profile;

std::vector<std::string> texts(const Diagnostics& notes) {
  std::vector<std::string> lines;
  for (const Diagnostic& note : notes) lines.push_back(note_text(note));
  return lines;
}

std::vector<std::string> notes(const std::string& text) {
  return texts(testing::read(text).notes);
}

Diagnostics notes_at_start(const Profile& profile) {
  const auto schedule = DriverSchedule::analyze(profile);
  const auto run = start_run(profile.mechanism, schedule.value().first_positions(), 1e-9);
  return run ? start_notes(profile, run->at.state.bodies) : Diagnostics{};
}

TEST(Notes, AreNoneAboutTheShippedProfiles) {
  for (const auto& entry : std::filesystem::directory_iterator(HIGHERPAIR_SOURCE_DIR "/profiles")) {
    if (entry.path().extension() != ".toml") continue;
    const auto profile = read_profile_file(entry.path().string());
    ASSERT_TRUE(profile) << entry.path();
    EXPECT_THAT(texts(profile->notes), IsEmpty());
    EXPECT_THAT(texts(notes_at_start(*profile)), IsEmpty());
    if (profile->programs.empty()) continue;
    EXPECT_THAT(texts(direction_notes(*profile, DriverSchedule::analyze(*profile).value())), IsEmpty());
  }
  EXPECT_THAT(notes(testing::kCamProfile), IsEmpty());
}

TEST(Notes, GravityInTheWrongUnit) {
  EXPECT_TRUE(
      lines_are(notes(crank_profile("", "gravity = [0, -9.81]\n")),
                {"test.toml:1:11: note: gravity = [0, -9.81]: 0.001 times the earth's: numbers here are in "
                 "mm/s^2, in which the earth's is 9806.65; or write it with its unit, \"9.81 m/s^2\""}));
  EXPECT_THAT(notes(crank_profile("", "gravity = [0, -9810]\n")), IsEmpty());
  EXPECT_THAT(notes(crank_profile("", "gravity = [0, \"-9.81 m/s^2\"]\n")), IsEmpty());
  EXPECT_THAT(notes(crank_profile("", "gravity = [0, -1620]\n")), IsEmpty());  // the moon's
  EXPECT_THAT(notes(crank_profile("", "gravity = [0, -32.17]\n[units]\nlength = \"ft\"\n")), IsEmpty());
}

TEST(Notes, DegreesInAProfileInRadiansAndTheOtherWayRound) {
  EXPECT_TRUE(lines_are(
      notes(crank_profile("end = 360\n", "[units]\nangle = \"rad\"\n")),
      {"test.toml:14:7: note: driver.end = 360: 57.3 turns, for angles here are in rad; write \"360 deg\" "
       "if that is meant"}));
  EXPECT_TRUE(lines_are(
      notes(crank_profile("end = 360\n", "[units]\nangle = \"rev\"\n")),
      {"test.toml:14:7: note: driver.end = 360: 360 turns, for angles here are in rev; write \"360 deg\" "
       "if that is meant"}));
  EXPECT_TRUE(
      lines_are(notes(crank_profile("end = 6.283\n")),
                {"test.toml:12:7: note: driver.end = 6.283: 0.0175 turns, for angles here are in deg; write "
                 "\"6.283 rad\" if that is meant"}));
  for (const std::string end : {"6.28", "3.14", "-1.57"}) {
    EXPECT_TRUE(lines_are(notes(crank_profile("end = " + end + "\n")),
                          {part("for angles here are in deg; write \"" + end + " rad\"")}));
  }
  EXPECT_TRUE(
      lines_are(notes(crank_profile("positions = [0, 1.57, 3.14]\n")),
                {"test.toml:12:23: note: driver.positions.2 = 3.14: 0.00872 turns, for angles here are in "
                 "deg; write \"3.14 rad\" if that is meant"}));
  EXPECT_THAT(notes(crank_profile("positions = [0, 1.57, 90]\n")), IsEmpty());
  EXPECT_THAT(notes(crank_profile("end = 6.3\n")), IsEmpty());
  EXPECT_TRUE(lines_are(
      notes(crank_profile("[bodies.crank.pose]\nangle = 90\n", "[units]\nangle = \"rad\"\n")),
      {"test.toml:15:9: note: bodies.crank.pose.angle = 90: 14.32 turns, for angles here are in rad; "
       "write \"90 deg\" if that is meant"}));
  EXPECT_THAT(notes(crank_profile("end = \"360 deg\"\n", "[units]\nangle = \"rad\"\n")), IsEmpty());
  EXPECT_THAT(notes(crank_profile("end = 6.283185307179586\n", "[units]\nangle = \"rad\"\n")), IsEmpty());
  EXPECT_THAT(notes(crank_profile("end = 100\n", "[units]\nangle = \"rad\"\n")), IsEmpty());
  EXPECT_THAT(notes(crank_profile("end = 30\n", "[units]\nangle = \"rev\"\n")), IsEmpty());
  EXPECT_THAT(notes(crank_profile("end = 3600\n")), IsEmpty());
}

TEST(Notes, AMechanismAsLargeAsAHouse) {
  EXPECT_TRUE(lines_are(
      notes(crank_profile(
          "[joints.far]\ntype = \"slot\"\ndirection = 0\nbetween = [\"ground.B\", \"crank.P\"]\n",
          "[units]\nlength = \"m\"\n")),
      {"test.toml:2:10: note: units.length: the mechanism is 127 m large: are its numbers in \"m\"?"}));
}

TEST(Notes, AMechanismSmallerThanAGrainOfSand) {
  const std::string metres = R"(
[bodies.ground]
points.O = [0, 0]
points.B = [0.036, 0]
[bodies.crank]
points.O = [0, 0]
points.A = [0.01, 0]
[joints.pivot]
type = "revolute"
between = ["ground.O", "crank.O"]
[joints.slot]
type = "slot"
direction = 0
between = ["ground.B", "crank.A"]
[driver]
joint = "pivot"
)";
  EXPECT_TRUE(lines_are(notes(metres),
                        {part("units.length: the mechanism is 0.036 mm large: are its numbers in \"mm\"?")}));
  EXPECT_THAT(notes(metres + "[units]\nlength = \"m\"\n"), IsEmpty());
}

TEST(Notes, NothingJoinedToGroundAndBodiesThatNothingHolds) {
  EXPECT_TRUE(lines_are(
      notes(
          "[bodies.a]\npoints.P = [0, 0]\n[bodies.b]\npoints.P = [0, 0]\n[bodies.c]\n[joints]\nj = { type = "
          "\"revolute\", between = [\"a.P\", \"b.P\"] }\n[driver]\njoint = \"j\"\n"),
      {"test.toml:5:1: note: bodies.c: no joint and no contact holds this body",
       "test.toml:6:1: note: joints: nothing is joined to ground: the frame is the body `ground`, give it "
       "points and join bodies to them"}));
}

std::string face_profile(const std::string& normal) {
  return crank_profile(
      "[bodies.crank.curves]\ndisc = { type = \"circle\", center = [8, 0], radius = 12 }\n"
      "[bodies.arm]\npose = { x = 60, angle = -20 }\npoints.O = [0, 0]\n"
      "curves.face = { type = \"line\", point = [0, 3], normal = " +
      normal +
      " }\n[joints.arm]\ntype = \"revolute\"\nbetween = [\"ground.B\", \"arm.O\"]\n"
      "[contacts.touch]\nbetween = [\"crank.disc\", \"arm.face\"]\n");
}

TEST(Notes, AFaceWhoseNormalPointsAwayFromTheOtherBody) {
  EXPECT_THAT(notes(face_profile("[0, -1]")), IsEmpty());
  EXPECT_TRUE(lines_are(
      notes(face_profile("[0, 1]")),
      {"test.toml:22:11: note: contacts.touch: crank.disc lies behind the face arm.face in the poses, "
       "20.79 mm from it; the normal of a face points out of its body, towards what touches it: reverse "
       "it if that side is meant"}));
}

TEST(Notes, AFaceThatIsDrawnWhereItTouchesWithItsNormalReversed) {
  const auto face = [](const std::string& normal) {
    return notes(crank_profile(
        "[bodies.crank.curves]\ndisc = { type = \"circle\", center = [8, 0], radius = 12 }\n"
        "[bodies.tappet]\npose = { y = 12 }\npoints.P = [0, 0]\n"
        "curves.face = { type = \"line\", point = [0, 0], normal = " +
        normal +
        " }\n[joints.guide]\ntype = \"prismatic\"\nbetween = [\"ground.A\", \"tappet.P\"]\ndirection = [0, "
        "1]\n[contacts.touch]\nbetween = [\"crank.disc\", \"tappet.face\"]\n"));
  };
  EXPECT_THAT(face("[0, -1]"), IsEmpty());
  EXPECT_TRUE(lines_are(face("[0, 1]"), {part("crank.disc lies behind the face tappet.face in the poses, "
                                              "12 mm from it; the normal of a face points out")}));
}

TEST(Notes, ADiscWithinADisc) {
  const auto discs = [](const std::string& side) {
    return notes(crank_profile(
        "[bodies.ground.curves]\nhole = { type = \"circle\", center = [1, 0], radius = 40" + side +
        " }\n[bodies.crank.curves]\ndisc = { type = \"circle\", center = [8, 0], radius = 12 "
        "}\n[contacts.touch]\n"
        "between = [\"ground.hole\", \"crank.disc\"]\n"));
  };
  EXPECT_THAT(discs(", side = \"outside\""), IsEmpty());
  EXPECT_TRUE(lines_are(
      discs(""), {"test.toml:17:11: note: contacts.touch: crank.disc lies within ground.hole in the "
                  "poses, which is the outline of a solid body; that of a hole has side = \"outside\""}));
}

TEST(Notes, WheelsWhoseTeethDoNotMesh) {
  std::ifstream file(HIGHERPAIR_SOURCE_DIR "/profiles/gear_teeth.toml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(lines_are(
      notes(testing::replaced(text, "module = 2, teeth = 40", "module = 3, teeth = 40")),
      {part("contacts.mesh: the teeth of pinion.teeth are 5.904 mm apart along the base circle, those of "
            "wheel.teeth 8.856 mm: wheels that mesh have the same `module` and `pressure_angle`")}));
}

TEST(Notes, ACurveThatNoContactNames) {
  EXPECT_TRUE(
      lines_are(notes(crank_profile("[bodies.crank.curves]\ndisc = { type = \"point\", at = [8, 0] }\n")),
                {"test.toml:13:8: note: bodies.crank.curves.disc: no contact names this curve"}));
}

TEST(Notes, AnInertiaInOtherUnits) {
  const auto inertia = [](const std::string& value) {
    return notes(
        "[bodies.ground]\npoints.A = [0, 0]\n[bodies.crank]\npoints.A = [0, 0]\npoints.P = [31, 0]\nmass = "
        "0.4\n"
        "center_of_mass = [15, 0]\ninertia = " +
        value +
        "\n[joints.pivot]\ntype = \"revolute\"\nbetween = [\"ground.A\", \"crank.A\"]\n[driver]\njoint = "
        "\"pivot\"\n");
  };
  EXPECT_TRUE(lines_are(inertia("2.1e-6"), {"test.toml:8:11: note: bodies.crank.inertia = 2.1e-06: a radius "
                                            "of gyration of 0.00229 mm in a body "
                                            "of 16 mm: numbers here are in kg*mm^2"}));
  EXPECT_THAT(inertia("21"), IsEmpty());
  EXPECT_THAT(inertia("\"2.1e-5 kg m^2\""), IsEmpty());
}

TEST(Notes, AJointOrContactThatIsGivenTwice) {
  const std::string undefined =
      ", so how they share their force is undefined, and it is left empty: leave one of them out";
  const std::string pin = "[joints.again]\ntype = \"revolute\"\nbetween = ";
  EXPECT_TRUE(lines_are(
      notes(crank_profile(pin + "[\"crank.A\", \"ground.A\"]\n")),
      {"test.toml:14:11: note: joints.again: gives the same condition as joints.pivot" + undefined}));
  EXPECT_THAT(notes(crank_profile(pin + "[\"ground.B\", \"crank.P\"]\n")), IsEmpty());
  const std::string slide =
      "[joints.again]\ntype = \"prismatic\"\nbetween = [\"ground.B\", \"slider.S\"]\ndirection = ";
  EXPECT_TRUE(lines_are(
      notes(slider_profile("end = 40\n" + slide + "[-3, 0]\n")),
      {"test.toml:16:11: note: joints.again: gives the same condition as joints.slide" + undefined}));
  EXPECT_THAT(notes(slider_profile("end = 40\n" + slide + "[3, 1]\n")), IsEmpty());
  const std::string touch = "[contacts.again]\nbetween = [\"follower.roller\", \"cam.disc\"]\n";
  EXPECT_TRUE(lines_are(notes(testing::kCamProfile + touch),
                        {part("contacts.again: gives the same condition as contacts.touch" + undefined)}));
  EXPECT_THAT(notes(testing::kCamProfile + touch + "approach = \"+\"\n"), IsEmpty());
}

TEST(Notes, WhatADriverDoesNotUse) {
  EXPECT_TRUE(lines_are(notes(crank_profile("positions = [0, 15]\nend = 90\nsamples = 4\n")),
                        {"test.toml:13:7: note: driver.end = 90: not used, for `positions` are given",
                         "test.toml:14:11: note: driver.samples = 4: not used, for `positions` are given"}));
  EXPECT_TRUE(lines_are(notes(slider_profile()), {"test.toml:12:9: note: driver.joint: this joint slides, "
                                                  "and without an `end` it stays at its start"}));
  EXPECT_THAT(notes(slider_profile("end = 40\n")), IsEmpty());
  EXPECT_TRUE(
      lines_are(notes(crank_profile("start = 30\nend = 30\n")),
                {"test.toml:13:7: note: driver.end = 30: the start: the driver stays there, and all rows "
                 "are alike"}));
  EXPECT_TRUE(lines_are(notes(crank_profile("duration = 1\ntime_step = 2\n")),
                        {"test.toml:13:13: note: driver.time_step = 2: longer than the duration"}));
}

TEST(Notes, ASlideThatMovesForTheDurationOfAnotherDriver) {
  const std::string both =
      "[bodies.ground]\npoints.O = [0, 0]\n[bodies.one]\npoints.P = [0, 0]\n[bodies.other]\npoints.P = [0, "
      "0]\n[joints.x]\ntype = \"prismatic\"\nbetween = [\"ground.O\", \"one.P\"]\ndirection = "
      "0\n[joints.y]\ntype = \"prismatic\"\nbetween = [\"ground.O\", \"other.P\"]\ndirection = "
      "90\n[drivers.x]\njoint = \"x\"\nvelocity = 1\n[drivers.y]\njoint = \"y\"\nvelocity = 2\n";
  EXPECT_THAT(notes(both), SizeIs(2));
  EXPECT_THAT(notes(both + "duration = 3\ntime_step = 0.5\n"), IsEmpty());
}

TEST(Notes, AnEndThatALawOfAnotherDriverLeavesUnused) {
  const auto robot = [](const std::string& second) {
    return notes(
        "[bodies.ground]\npoints.O = [0, 0]\n[bodies.arm]\npoints.O = [0, 0]\n[bodies.slide]\npoints.P = "
        "[0, 0]\n[joints.r]\ntype = \"revolute\"\nbetween = [\"ground.O\", \"arm.O\"]\n[joints.p]\ntype = "
        "\"prismatic\"\nbetween = [\"arm.O\", \"slide.P\"]\ndirection = [1, 0]\n[laws.turn]\nsegments = "
        "[{ over = 1, law = \"cycloidal\", rise = 70 }]\n[drivers.a]\njoint = \"r\"\nlaw = \"turn\"\n"
        "[drivers.b]\njoint = \"p\"\nstart = 200\n" +
        second);
  };
  EXPECT_THAT(robot("velocity = -80\n"), IsEmpty());
  EXPECT_TRUE(
      lines_are(robot("end = 120\n"),
                {part("note: drivers.b.end = 120: not used, for another driver follows a law: all move "
                      "in time, this one with its `velocity` and `acceleration`")}));
}

TEST(Notes, ACenterOfMassFarOutside) {
  const auto center = [](const std::string& x) {
    return texts(
        testing::read(testing::kCamProfile, {"bodies.cam.mass=1", "bodies.cam.center_of_mass=[" + x + ", 0]"})
            .notes);
  };
  EXPECT_THAT(center("150"), IsEmpty());
  EXPECT_TRUE(lines_are(center("15000"), {part("bodies.cam.center_of_mass = [15000, 0]: 1.5e+04 mm from "
                                               "the body's origin, in a mechanism of")}));
}

// Both points of its flank that lie in the middle of a span, and so its middle, are as far from the pivot.
TEST(Notes, NothingAboutTheInertiaOfACamOfTwoLobes) {
  EXPECT_THAT(notes(R"([bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
mass = 1
center_of_mass = [0, 0]
inertia = 900
curves.flank = { type = "cam", law = "lift", contact = "touch" }
[bodies.follower]
pose = { y = 50 }
points.P = [0, 0]
curves.roller = { type = "circle", center = [0, 0], radius = 10 }
[joints]
pivot = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.O", "follower.P"], direction = [0, 1] }
[contacts.touch]
between = ["cam.flank", "follower.roller"]
[laws.lift]
repeat = true
segments = [ { over = 90, law = "cycloidal", rise = 5 }, { over = 90, law = "cycloidal", rise = -5 } ]
[driver]
joint = "pivot"
)"),
              IsEmpty());
}

TEST(Notes, ARowTooFewForRoundSteps) {
  EXPECT_TRUE(lines_are(
      notes(crank_profile("samples = 360\n")),
      {"test.toml:12:11: note: driver.samples = 360: both ends are rows, so they are 1.00279 deg apart; "
       "361 rows are 1 deg apart"}));
  EXPECT_TRUE(
      lines_are(notes(crank_profile("start = 10\nend = 100\nsamples = 180\n")),
                {"test.toml:14:11: note: driver.samples = 180: both ends are rows, so they are 0.502793 deg "
                 "apart; 181 rows are 0.5 deg apart"}));
  EXPECT_TRUE(lines_are(notes(slider_profile("start = 100\nend = 40\nsamples = 60\n")),
                        {part("so they are 1.01695 mm apart; 61 rows are 1 mm apart")}));
  EXPECT_THAT(notes(crank_profile("samples = 361\n")), IsEmpty());
  EXPECT_THAT(notes(crank_profile("samples = 100\n")), IsEmpty());
  // 0.015 apart; with one row more they would be 1/70.
  EXPECT_THAT(notes(slider_profile("start = 0\nend = 0.3\nsamples = 21\n")), IsEmpty());
  EXPECT_TRUE(lines_are(notes(slider_profile("start = 0\nend = 0.3\nsamples = 30\n")),
                        {part("so they are 0.0103448 mm apart; 31 rows are 0.01 mm apart")}));
}

TEST(Notes, RowsThatGoAgainstTheVelocity) {
  const auto directions = [](const std::string& text, bool in_time = false) {
    const Profile profile = testing::read(text);
    return texts(direction_notes(
        profile, in_time ? DriverSchedule::step(profile).value() : DriverSchedule::analyze(profile).value()));
  };
  EXPECT_TRUE(
      lines_are(directions(slider_profile("start = 95\nend = 40\n")),
                {part("note: driver.velocity is 1 mm/s, the default, but the rows go from 95 to 40 mm: rates "
                      "are those of the motion in the other direction; give velocity = -1")}));
  EXPECT_TRUE(
      lines_are(directions(crank_profile("start = 0\nend = -360\nvelocity = \"300 rpm\"\n")),
                {part("note: driver.velocity is 1800 deg/s, but the rows go from 0 to -360 deg: rates "
                      "are those of the motion in the other direction; exchange start and end, or "
                      "set velocity = -1800")}));
  EXPECT_THAT(directions(crank_profile("velocity = -3\n")), SizeIs(1));  // the default end is a turn on
  EXPECT_THAT(directions(crank_profile("end = -360\nvelocity = -3\n")), IsEmpty());
  EXPECT_THAT(directions(crank_profile("end = -360\nvelocity = 0\n")), IsEmpty());
  EXPECT_THAT(directions(crank_profile("end = -360\nsamples = 1\n")), IsEmpty());
  EXPECT_THAT(directions(crank_profile("positions = [90, 30]\n")), IsEmpty());
  EXPECT_THAT(directions(crank_profile("end = -360\nduration = 2\ntime_step = 1\n"), true), IsEmpty());
}

// The lever of a crank-rocker, with its pose on the other side of the frame.
TEST(Notes, AStartFarFromThePoses) {
  const Profile profile = testing::read(R"([bodies.ground]
points.A = [0, 0]
points.D = [70, 0]
[bodies.crank]
points.A = [0, 0]
points.B = [20, 0]
[bodies.coupler]
pose = { x = 20, y = 0, angle = -50 }
points.B = [0, 0]
points.C = [60, 0]
[bodies.rocker]
pose = { x = 70, y = 0, angle = 70 }
points.D = [0, 0]
points.C = [50, 0]
[joints]
a = { type = "revolute", between = ["ground.A", "crank.A"] }
b = { type = "revolute", between = ["crank.B", "coupler.B"] }
c = { type = "revolute", between = ["coupler.C", "rocker.C"] }
d = { type = "revolute", between = ["ground.D", "rocker.D"] }
[driver]
joint = "a"
)");
  EXPECT_TRUE(
      lines_are(texts(notes_at_start(profile)),
                {"test.toml: note: bodies.coupler: C is 94 mm from where the pose has it at the start, in a "
                 "mechanism of 73.76 mm; is that the assembly that is meant? Else give a better pose"}));
}

// The size of the mechanism is that of its poses only where they are right: with this one it would be 140 mm.
TEST(StartNotes, MeasureTheDistanceInTheAssembledMechanism) {
  const std::vector<std::string> overrides = {"bodies.follower.pose.x=140"};
  const auto profile = read_profile_file(HIGHERPAIR_SOURCE_DIR "/profiles/lock_up.toml", overrides);
  ASSERT_TRUE(profile);
  EXPECT_TRUE(lines_are(texts(notes_at_start(*profile)), {part("bodies.follower: ")}));
}

// An arm on whose line a block slides, through its pivot. The block starts farther from the pivot than `to`
// lets it be on the side on which the pose has it.
TEST(StartNotes, NameABodyThatStartsTurnedRound) {
  const std::string text = R"([bodies.ground]
points.A = [0, 0]
points.O = [60, 0]
[bodies.crank]
points.A = [0, 0]
points.B = [20, 0]
[bodies.block]
pose = { x = -19, y = 2, angle = 178 }
points.B = [0, 0]
[bodies.arm]
pose = { x = 60, y = 0, angle = 178 }
points.O = [0, 0]
[joints]
a = { type = "revolute", between = ["ground.A", "crank.A"] }
b = { type = "revolute", between = ["crank.B", "block.B"] }
o = { type = "revolute", between = ["ground.O", "arm.O"] }
s = { type = "prismatic", between = ["arm.O", "block.B"], direction = [1, 0], from = -100, to = 50 }
[driver]
joint = "a"
start = 180
end   = 200
)";
  EXPECT_TRUE(lines_are(texts(notes_at_start(testing::read(text))),
                        {"test.toml: note: bodies.block: is turned by 178 deg from its pose at the start; is "
                         "that the assembly that is meant? Else give a better pose",
                         "test.toml: note: bodies.arm: is turned by 178 deg from its pose at the start; is "
                         "that the assembly that is meant? Else give a better pose"}));
  EXPECT_THAT(notes_at_start(testing::read(testing::replaced(text, "to = 50", "to = 100"))), IsEmpty());
}

std::string advice_with_driver(const std::string& driver, double start) {
  std::ifstream file(HIGHERPAIR_SOURCE_DIR "/profiles/lock_up.toml");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const Profile profile = testing::read(text.substr(0, text.find("[driver]")) + driver);
  return start_advice(profile, {start}, 1e-9);
}

// `start` is the value at the origin of the law, 10 degrees before that at time 0.
TEST(StartAdvice, NamesWhatMovesTheDriver) {
  const std::string driver = "[driver]\njoint = \"cam_pivot\"\n";
  EXPECT_EQ(advice_with_driver(driver + "positions = [90, 100]\n", kPi / 2),
            "; it is possible, for example, with driver.positions from -65.8 to 65.8 deg");
  const std::string law = driver + "law = \"swing\"\n[laws.swing]\n";
  const std::string segments = "segments = [{ over = 2, law = \"uniform\", rise = 40 }]\n";
  EXPECT_EQ(advice_with_driver(law + segments + "start = 90\n", kPi / 2),
            "; it is possible, for example, with laws.swing.start from -65.8 to 65.8 deg");
  EXPECT_EQ(advice_with_driver(law + segments + "start = 80\norigin = -0.5\n", kPi / 2),
            "; it is possible, for example, with laws.swing.start from -75.8 to 55.8 deg");
  EXPECT_EQ(advice_with_driver(law + "points = [[0, 90], [1, 95], [2, 97], [3, 100]]\n", kPi / 2),
            "; it is possible, for example, with laws.swing at time 0 from -65.8 to 65.8 deg");
}

TEST(StartAdvice, NamesTheTableOfOneOfSeveralDrivers) {
  const std::vector<std::string> far = {"bodies.left_link.points.T=[13, 0]", "drivers.left.start=110"};
  const auto profile = read_profile_file(HIGHERPAIR_SOURCE_DIR "/profiles/five_bar.toml", far);
  ASSERT_TRUE(profile);
  EXPECT_TRUE(
      contains(start_advice(*profile, DriverSchedule::analyze(*profile).value().first_positions(), 1e-9),
               "drivers.left.start"));
}

TEST(StartAdvice, NamesTheRangeInWhichItCanBeAssembled) {
  const auto profile = read_profile_file(HIGHERPAIR_SOURCE_DIR "/profiles/lock_up.toml");
  ASSERT_TRUE(profile);
  // The limits are at ±65.83442067466342.
  EXPECT_EQ(start_advice(*profile, {kPi / 2}, 1e-9),
            "; it is possible, for example, with driver.start from -65.8 to 65.8 deg");
  EXPECT_EQ(start_advice(*profile, {0}, 1e-9), "");
}

// The same pair, its cam turned faster by gears and half a turn off at the start: it assembles within
// 65.834/ratio degrees of odd multiples of 180/ratio.
std::string advice_with_gears(double ratio) {
  std::ifstream file(HIGHERPAIR_SOURCE_DIR "/profiles/lock_up.toml");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  text += R"(
[bodies.wheel]
points.O = [0, 0]
[joints.wheel_pivot]
type    = "revolute"
between = ["ground.O1", "wheel.O"]
[joints.mesh]
type    = "gears"
between = ["wheel.O", "cam.O"]
)";
  text += "ratio = " + std::to_string(ratio) + "\n";
  const std::vector<std::string> overrides = {"driver.joint=wheel_pivot", "bodies.cam.pose.angle=180"};
  const auto profile = read_profile_text(text, "test.toml", overrides);
  return start_advice(profile.value(), {0}, 1e-9);
}

// Of equally near ranges those ahead come first.
TEST(StartAdvice, NamesTheThreeNearestRangesInWhichItCanBeAssembled) {
  EXPECT_EQ(
      advice_with_gears(4),
      "; it is possible, for example, with driver.start from 28.55 to 61.45 or from -61.45 to -28.55 or "
      "from 118.55 to 151.45 deg");
}

// They are narrower than the 72nd part of a turn.
TEST(StartAdvice, NamesNarrowRangesNextToTheStart) {
  EXPECT_EQ(
      advice_with_gears(100),
      "; it is possible, for example, with driver.start from 1.142 to 2.458 or from -2.458 to -1.142 or "
      "from 4.742 to 6.058 deg");
}

// Coupler and rocker reach the crank's pin only where all links are in line.
TEST(StartAdvice, NamesTheOnePositionInWhichItCanBeAssembled) {
  const std::vector<std::string> short_coupler = {"bodies.coupler.points.B=[1, 0]"};
  const auto profile = read_profile_file(HIGHERPAIR_SOURCE_DIR "/profiles/four_bar.toml", short_coupler);
  ASSERT_TRUE(profile);
  EXPECT_EQ(start_advice(*profile, {0}, 1e-9), "; it is possible, for example, with driver.start 180 deg");
}

TEST(StartAdvice, SaysThatNoOtherStartWillDo) {
  const Profile profile = testing::read(R"([bodies.ground]
points.A = [0, 0]
points.D = [70, 0]
[bodies.crank]
points.A = [0, 0]
points.B = [20, 0]
[bodies.coupler]
points.B = [0, 0]
points.C = [20, 0]
[bodies.rocker]
points.D = [0, 0]
points.C = [20, 0]
[joints]
a = { type = "revolute", between = ["ground.A", "crank.A"] }
b = { type = "revolute", between = ["crank.B", "coupler.B"] }
c = { type = "revolute", between = ["coupler.C", "rocker.C"] }
d = { type = "revolute", between = ["ground.D", "rocker.D"] }
[driver]
joint = "a"
)");
  EXPECT_EQ(start_advice(profile, {0.0}, 1e-9), "; it is possible with no other driver.start that was tried");
}

}  // namespace
}  // namespace higherpair
