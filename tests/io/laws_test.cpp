// [laws.NAME] in profiles, and the mistakes that can be made in it.
#include "higherpair/io/profile_reader.hpp"
#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::crank_profile;
using ::testing::IsEmpty;
using testing::lines_are;
using testing::messages;
using testing::part;
using testing::read;
using testing::slider_profile;

std::string crank(const std::string& law) {
  return crank_profile("law = \"lift\"\n[laws.lift]\n" + law);
}

std::string slider(const std::string& law) {
  return slider_profile("law = \"lift\"\n[laws.lift]\n" + law);
}

std::vector<std::string> law_notes(const std::string& text) {
  std::vector<std::string> lines;
  for (const Diagnostic& note : read(text).notes) lines.push_back(to_string(note));
  return lines;
}

TEST(Laws, AreInTheUnitsOfTheJointThatUsesThem) {
  const Profile profile = read(crank(R"(origin = "500 ms"
start = 10
segments = [
  { over = 0.5, law = "cycloidal", rise = 20 },
  { over = "1 s", law = "uniform", rise = "0.5 rev" },
]
)"));
  ASSERT_EQ(profile.programs.size(), 1U);
  const MotionLaw& law = profile.programs[0].law.value();
  EXPECT_EQ(law.begin(), 0.5);
  EXPECT_EQ(law.end(), 2);
  EXPECT_EQ(law(0.0), 10);
  EXPECT_EQ(law(1.0), 30);
  EXPECT_EQ(law(2.0), 210);
  EXPECT_FALSE(law.repeats());
  EXPECT_EQ(profile.programs[0].law_name, "laws.lift");
  EXPECT_EQ(profile.programs[0].start, 10);
  // The description has them in SI units.
  ASSERT_EQ(profile.mechanism.laws.size(), 1U);
  EXPECT_EQ(profile.mechanism.laws[0].name, "lift");
  const MotionLaw si = MotionLaw::make(profile.mechanism.laws[0].law).value();
  EXPECT_NEAR(si(1.0), kPi / 6, 1e-15);
  EXPECT_NEAR(si.derivative(1, 1.5), kPi, 1e-14);
}

TEST(Laws, ReadEveryLawByItsName) {
  for (const std::string_view name : kLawNames) {
    std::string more = name == "dwell" ? "" : ", rise = 3";
    if (name == "polynomial") more = ", start = [0, 1, 2], end = [3]";
    if (name == "harmonics") more = ", sines = [1, 2], cosines = [0, 1]";
    const Profile profile =
        read(slider("segments = [{ over = 2, law = \"" + std::string(name) + "\"" + more + " }]\n"));
    ASSERT_TRUE(profile.programs[0].law) << name;
    const double expected = name == "dwell" || name == "harmonics" ? 0 : 3;
    EXPECT_EQ((*profile.programs[0].law)(2.0), expected) << name;
  }
}

TEST(Laws, ConditionsOfAPolynomialHaveTheirOwnUnits) {
  const Profile profile = read(slider(
      R"(segments = [{ over = 2, law = "polynomial", start = [0, "1 m/s", 3], end = ["2 cm", 0, "1 m/s^2", 5] }]
)"));
  const MotionLaw& law = *profile.programs[0].law;
  EXPECT_NEAR(law.derivative(1, 0), 1000, 1e-9);
  EXPECT_NEAR(law.derivative(2, 0), 3, 1e-9);
  EXPECT_NEAR(law.derivative(0, 2, LawSide::kBefore), 20, 1e-12);
  EXPECT_NEAR(law.derivative(2, 2, LawSide::kBefore), 1000, 1e-9);
  EXPECT_NEAR(law.derivative(3, 2, LawSide::kBefore), 5, 1e-9);
}

TEST(Laws, RepeatWhereTheySaySo) {
  const Profile profile =
      read(crank("repeat = true\nsegments = [{ over = 1, law = \"cycloidal\", rise = 90 }]\n"));
  const MotionLaw& law = *profile.programs[0].law;
  EXPECT_TRUE(law.repeats());
  EXPECT_EQ(law(4.0), 360);
}

TEST(Laws, GoThroughPoints) {
  const Profile profile =
      read(slider("points = [[0, 0], [\"1 s\", 3], [2, \"1 cm\"], [3, 4]]\ndegree = 3\n"));
  const MotionLaw& law = *profile.programs[0].law;
  EXPECT_NEAR(law(1.0), 3, 1e-13);
  EXPECT_NEAR(law(2.0), 10, 1e-13);
  EXPECT_EQ(law.end(), 3);
}

class LawFiles : public ::testing::Test {
protected:
  LawFiles()
      : folder_(::testing::TempDir() + "laws_" +
                ::testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::create_directories(folder_);
  }
  ~LawFiles() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::string path = folder_ + "/" + name;
    std::ofstream(path) << text;
    return path;
  }

  // Writes a profile beside the table.
  std::string profile(const std::string& more = "") const {
    return write("profile.toml", slider("file = \"lift.csv\"\n" + more));
  }

  std::vector<std::string> messages_for(const std::string& table, const std::string& more = "") const {
    write("lift.csv", table);
    return messages_of(profile(more));
  }

  std::vector<std::string> messages_of(const std::string& path) const {
    std::vector<std::string> lines;
    if (const auto profile = read_profile_file(path); !profile) {
      for (const Diagnostic& diagnostic : profile.error()) {
        lines.push_back(diagnostic.message);
      }
    }
    return lines;
  }

  std::string folder_;
};

TEST_F(LawFiles, AreFoundBesideTheProfileInManyForms) {
  for (const std::string table :
       {"0,0\n1,3\n2,10\n3,4\n", "x,s\n0,0\n1,3\n2,10\n3,4\n",
        "\xEF\xBB\xBFx;s\r\n0;0\r\n1;3\r\n2;10\r\n3;4\r\n", "# lift\n\n0 0\n  1\t3\n2   10\n3 +4\n",
        "0\t0\n1\t3\n2\t1e1\n3\t4", "x[ms],s[cm]\n0,0\n1000,0.3\n2000,1\n3000,0.4\n",
        "n,s,\"x\"\n1,0,0\n2,3,1\n3,10,2\n4,4,3\n", "time,lift\n0,0\n1,3\n2,10\n3,4\n"}) {
    write("lift.csv", table);
    const auto profile_read = read_profile_file(profile());
    ASSERT_TRUE(profile_read) << table << to_string(profile_read.error().front());
    const MotionLaw& law = *profile_read->programs[0].law;
    EXPECT_NEAR(law(1.0), 3, 1e-12) << table;
    EXPECT_NEAR(law(2.0), 10, 1e-12) << table;
    EXPECT_EQ(law.end(), 3) << table;
  }
}

TEST_F(LawFiles, AreRefusedWithTheirLine) {
  const std::string file = "laws.lift.file = \"lift.csv\": ";
  EXPECT_TRUE(lines_are(messages_of(profile()), {file + "cannot be opened: No such file or directory"}));
  EXPECT_TRUE(lines_are(messages_for(""), {file + "has no points"}));
  EXPECT_TRUE(lines_are(messages_for("x,s\n"), {file + "has no points"}));
  EXPECT_TRUE(lines_are(messages_for("0,0\n1,two\n2,3\n"), {file + "line 2: `two` is no number"}));
  EXPECT_TRUE(lines_are(messages_for("0,0\n1,nan\n2,3\n3,1\n"), {file + "line 2: `nan` is no number"}));
  EXPECT_TRUE(lines_are(messages_for(std::string("\xff\xfe"
                                                 "0\0,\0"
                                                 "0\0\n\0",
                                                 10)),
                        {part("this file is in UTF-16 or UTF-32; save it as UTF-8")}));
  EXPECT_TRUE(lines_are(messages_for("x,s[\xb5m]\n0,0\n1,2\n"),
                        {part("line 1: the byte 0xB5 is not UTF-8: the file seems to be in Latin-1")}));
  EXPECT_TRUE(lines_are(messages_for("# N\xfcrnberg\n0,0\n1,two\n"), {part("line 1: the byte 0xFC")}));
  EXPECT_TRUE(
      lines_are(messages_for("0;0\n1;2,5\n2;3\n3;1\n"),
                {file + "line 2: `2,5` is no number: a decimal number is written with a point: 2.5"}));
  EXPECT_TRUE(lines_are(
      messages_for("0,0,1,5\n"),
      {file + "line 1: expected 2 columns, found 4: decimals are written with a point, not a comma"}));
  EXPECT_TRUE(lines_are(messages_for("0,0\n1,3\n2,10,7\n"), {file + "line 3: expected 2 columns, found 3"}));
  EXPECT_TRUE(lines_are(
      messages_for("a,b,c\n0,0,1\n"),
      {file + "line 1: expected two columns, x and s, or a header that has x and s among others; found 3 "
              "columns"}));
  EXPECT_TRUE(lines_are(messages_for("x[kg],s\n0,0\n1,1\n2,2\n"), {part("line 1: x[kg]: kg is a mass")}));
  EXPECT_TRUE(lines_are(messages_for("0,0\n1,1e60\n2,1\n"), {file + "line 2: 1e+60 is too large"}));
  EXPECT_TRUE(lines_are(messages_for("0,0\n\n2,3\n1,3\n"),
                        {file + "line 4: x must grow from point to point: 1 comes after 2"}));
  EXPECT_TRUE(lines_are(messages_for("0,0\n2,3\n2,4\n"),
                        {file + "line 3: has the same x as the point before, 2: give each x once"}));
  EXPECT_TRUE(
      lines_are(messages_for("0,0\n2,3\n"), {"laws.lift: a spline needs at least 3 points, found 2"}));
  EXPECT_THAT(messages_for("0,0\n1,x\n2,y\n3,z\n4,a\n5,b\n6,c\n"), ::testing::SizeIs(5))
      << "the first mistakes only";
}

TEST_F(LawFiles, SayWhatTheirRoundingDoesToAcceleration) {
  std::string table;
  for (int i = 0; i <= 100; ++i) {
    const double u = i / 100.0;
    char line[64];
    std::snprintf(line, sizeof line, "%.2f,%.3f\n", u, 10 * u * u * u * (10 + u * (-15 + 6 * u)));
    table += line;
  }
  write("lift.csv", table);
  const auto guessed = read_profile_file(profile())->notes;
  ASSERT_EQ(guessed.size(), 1U);
  EXPECT_THAT(guessed[0].message,
              ::testing::MatchesRegex(
                  "laws.lift: its values are given to, and probably rounded to, 0.001 mm; the spline "
                  "through them has about [0-9.]+ mm/s.2 of noise from that in its second derivative, "
                  "whose peak is 5[0-9.]+; smoothing = 0.0005 takes it out"));
  const auto stated = read_profile_file(profile("rounding = \"1 um\"\n"))->notes;
  ASSERT_EQ(stated.size(), 1U);
  EXPECT_TRUE(contains(stated[0].message, "its values are rounded to 0.001 mm"));
  EXPECT_THAT(read_profile_file(profile("smoothing = 0.0005\n"))->notes, IsEmpty());
}

// The coordinate of a law may also be an angle, as for a cam; what uses the law determines it. Without a use
// the quantities are unknown, but mistakes are still found.
TEST(Laws, ThatNothingUsesAreReadAllTheSame) {
  const std::string unused =
      "[laws.spare]\nsegments = [{ over = \"120 deg\", law = \"cycloidal\", rise = \"2 mm\" }]\n";
  EXPECT_THAT(messages(crank_profile(unused)), IsEmpty());
  EXPECT_TRUE(
      lines_are(law_notes(crank_profile(unused)),
                {"test.toml:12:1: laws.spare: nothing uses this law; a driver does by its key `law`"}));
  EXPECT_TRUE(lines_are(
      messages(crank_profile("[laws.spare]\nsegments = [{ over = -1, law = \"cycloidal\", rise = 2 }]\n")),
      {part("laws.spare.segments.0.over = -1 deg: must be > 0")}));
}

struct WrongLaw {
  std::string law;
  std::string message;
};

TEST(LawMessages, NameThePlaceAndTheRemedy) {
  const std::string at = "laws.lift";
  const WrongLaw wrong[] = {
      {"", at + ": expected one of `segments`, `points` and `file`"},
      {"segments = [{ over = 1, law = \"dwell\" }]\npoints = [[0, 0]]",
       at + ": expected one of `segments`, `points` and `file`"},
      {"segments = []", at + ".segments = []: expected a list of segments, [{ over = 120, law = "
                             "\"cycloidal\", rise = 20 }, ...]"},
      {"segments = [3]", at + ".segments.0 = 3: expected a segment (a table), found an integer"},
      {"segments = [{ law = \"dwell\" }]",
       at + ".segments.0.over is missing: expected the length of the segment"},
      {"segments = [{ over = 0, law = \"dwell\" }]", at + ".segments.0.over = 0 s: must be > 0"},
      {"segments = [{ over = \"-2 s\", law = \"dwell\" }]", at + ".segments.0.over = \"-2 s\": must be > 0"},
      {"segments = [{ over = \"2 mm\", law = \"dwell\" }]",
       at + ".segments.0.over = \"2 mm\": mm is a length, expected a time, such as s"},
      {"segments = [{ over = 1, rise = 2 }]",
       at + ".segments.0.law is missing: expected the name of a law, \"cycloidal\""},
      {"segments = [{ over = 1, law = \"cycloid\", rise = 2 }]", "did you mean `cycloidal`?"},
      {"segments = [{ over = 1, law = \"345\", rise = 2 }]", "did you mean `polynomial-345`?"},
      {"segments = [{ over = 1, law = \"modified_sine\", rise = 2 }]", "did you mean `modified-sine`?"},
      {"segments = [{ over = 1, law = \"rest\" }]", "did you mean `dwell`?"},
      {"segments = [{ over = 1, law = \"nonsense\", rise = 2 }]",
       "expected one of dwell, uniform, parabolic, harmonic, cycloidal, modified-sine, modified-trapezoid, "
       "polynomial-345, "
       "polynomial-4567, polynomial, harmonics"},
      {"segments = [{ over = 1, law = \"harmonic\" }]",
       at + ".segments.0.rise is missing: expected by how much the value grows over the segment"},
      {"segments = [{ over = 1, law = \"harmonic\", rise = \"2 mm\" }]", "mm is a length, expected an angle"},
      {"segments = [{ over = 1, law = \"dwell\", rise = 2 }]",
       at + ".segments.0.rise = 2: a dwell stays where it is: leave it out, or choose another law"},
      {"segments = [{ over = 1, law = \"harmonic\", rise = 2, start = [0] }]",
       at + ".segments.0.start = [0]: has a meaning for law = \"polynomial\" only"},
      {"segments = [{ over = 1, law = \"harmonic\", rise = 2, sines = [0] }]",
       at + ".segments.0.sines = [0]: has a meaning for law = \"harmonics\" only"},
      {"segments = [{ over = 1, law = \"polynomial\", end = [0] }]",
       at + ".segments.0.start is missing: expected the value there and as many derivatives as are to be "
            "given, [s, v, a, ...]"},
      {"segments = [{ over = 1, law = \"polynomial\", start = [0], end = [] }]",
       at + ".segments.0.end = []: expected a list, [s, v, a, ...]"},
      {"segments = [{ over = 1, law = \"polynomial\", start = [0, \"2 mm\"], end = [1] }]",
       at + ".segments.0.start.1 = \"2 mm\": mm is a length, expected an angular velocity"},
      {"segments = [{ over = 1, law = \"uniform\", rise = 20 }, { over = 1, law = \"polynomial\", start = "
       "[0], end = [-20] }]",
       at + ".segments.1.start = [0]: the law would jump: it begins at 0 where the segment before ends at "
            "20; values in start "
            "and end count from 0, not from there"},
      {"segments = [{ over = 1, law = \"polynomial\", start = [0], end = [1], rise = 1 }]",
       at + ".segments.0.rise = 1: a polynomial rises from start to end: leave it out"},
      {"segments = [{ over = 1, law = \"harmonics\" }]",
       at + ".segments.0.sines is missing: harmonics need sines or cosines, [first, second, ...]"},
      {"segments = [{ over = 1, law = \"dwell\", length = 2 }]",
       at + ".segments.0.length: unknown key; did you mean `over`?"},
      {"segments = [{ over = 1, law = \"dwell\" }]\nsmoothing = 1", at + ".smoothing: unknown key"},
      {"points = 3", at + ".points = 3: expected a list of points, [[x, s], ...]"},
      {"points = [[0, 0], [1]]", at + ".points.1 = [1]: expected a point, [x, s]"},
      {"points = [[0, 0], [1, 1]]", at + ": a spline needs at least 3 points, found 2"},
      {"points = [[0, 0], [2, 1], [1, 3]]",
       at + ".points.2 = [1, 3]: x must grow from point to point: 1 comes after 2"},
      {"points = [[0, 0], [1, 1], [1, 3]]",
       at + ".points.2 = [1, 3]: has the same x as the point before, 1: give each x once"},
      {"points = [[0, 0], [1, 1], [2, 3]]\ndegree = 4", at + ".degree = 4: must be 3 or 5"},
      {"points = [[0, 0], [1, 1], [2, 3]]\nsmoothing = -1", at + ".smoothing = -1 deg: must be >= 0"},
      {"points = [[0, 0], [1, 1], [2, 3]]\nrounding = 0", at + ".rounding = 0 deg: must be > 0"},
      {"points = [[0, 0], [1, 1], [2, 3]]\norigin = 1",
       at + ".origin = 1: has a meaning for segments only: points have their own places"},
      {"points = [[0, 0], [1, 1], [2, 3]]\nrepeat = 1",
       at + ".repeat = 1: expected true or false, found an integer"},
  };
  for (const WrongLaw& one : wrong) {
    EXPECT_TRUE(lines_are(messages(crank(one.law + "\n")), {part(one.message)})) << one.law;
  }
}

TEST(LawMessages, ReachTheDriver) {
  EXPECT_TRUE(lines_are(
      messages(crank_profile("law = \"lft\"\n[laws.lift]\nsegments = [{ over = 1, law = \"dwell\" }]\n")),
      {part("driver.law = \"lft\": there is no law `lft`; did you mean `lift`?")}));
  EXPECT_TRUE(lines_are(messages(crank_profile("law = \"lift\"\n")),
                        {part("driver.law = \"lift\": there is no law `lift`; none is defined")}));
  for (const std::string key :
       {"start = 0", "end = 3", "velocity = 1", "acceleration = 1", "positions = [1]"}) {
    EXPECT_TRUE(
        lines_are(messages(crank_profile(
                      key + "\nlaw = \"lift\"\n[laws.lift]\nsegments = [{ over = 1, law = \"dwell\" }]\n")),
                  {part(": the law says where the driver is at which time: leave it out")}));
  }
  EXPECT_TRUE(
      lines_are(messages("laws = 3\n" + crank_profile()), {part("laws = 3: expected a table of names")}));
  EXPECT_TRUE(lines_are(messages(crank_profile("[laws]\nlift = 3\n")),
                        {part("laws.lift = 3: expected a law (a table)")}));
}

}  // namespace
}  // namespace higherpair
