#include "cli/interrupting.hpp"
#include "program_testing.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using higherpair::testing::contains;
using higherpair::testing::contains_all;
using higherpair::testing::interrupted;
using higherpair::testing::Outcome;
using higherpair::testing::ProgramTest;
using higherpair::testing::read_file;
using higherpair::testing::shipped_profile;
using higherpair::testing::UnreadPipe;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::string shipped_toml(const std::string& name) {
  return shipped_profile(name + ".toml");
}

class SensitivityCommand : public ProgramTest {
protected:
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return run_program("sensitivity " + arguments);
  }
};

TEST_F(SensitivityCommand, PrintsTablesThatFitAScreen) {
  for (const char* profile : {"toleranced_linkage", "eccentric_disc_oscillating_roller", "watt_sixbar",
                              "ellipse_cam_roller", "tolerance_study"}) {
    const Outcome outcome = run(shipped_toml(profile));
    EXPECT_EQ(outcome.code, 0) << profile << outcome.err;
    EXPECT_THAT(outcome.err, IsEmpty());
    std::istringstream lines(outcome.out);
    std::string line;
    while (std::getline(lines, line)) {
      EXPECT_LE(line.size(), 80U) << line;
    }
  }
}

TEST_F(SensitivityCommand, RanksDimensionsAndNamesThoseWithoutInfluence) {
  const Outcome outcome =
      run(shipped_toml("flat_faced_translating") + " --results follower.y:max --by 'bodies.*' --top 1");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains_all(outcome.out, {"max of follower.y", "mm/unit", "% per %", "more: --top",
                                         "without influence on any of these"}));
}

TEST_F(SensitivityCommand, PrintsBandsAndWhichToleranceToTighten) {
  const std::string profile = shipped_toml("toleranced_linkage");
  EXPECT_TRUE(contains_all(run(profile).out,
                           {"worst case", "statistical, 99.73 %", "wanted within +-0.5: kept", "share"}));
  const Outcome outcome = run(profile + " --set tolerances.results.swing.within=0.1");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains_all(outcome.out, {"EXCEEDED", "tighten", "all zones to"}));
}

TEST_F(SensitivityCommand, ChecksBandsByVariants) {
  const std::string arguments = shipped_toml("toleranced_linkage") + " --samples 37 --variants 500";
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains_all(outcome.out, {"variants, 99.73 %", "500 variants, 500 of them run all the way"}));
  EXPECT_EQ(run(arguments + " --threads 1").out, outcome.out);
  EXPECT_NE(run(arguments + " --seed 2").out, outcome.out);
}

TEST_F(SensitivityCommand, WritesJson) {
  const Outcome outcome = run(shipped_toml("toleranced_linkage") + " --samples 19 --variants 100 --json -");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("good"), true);
  EXPECT_EQ(json.at("where_unit"), "deg");
  EXPECT_EQ(json.at("numbers").at(0).at("name"), "crank");
  EXPECT_EQ(json.at("numbers").at(2).at("minus"), 0.074);
  const nlohmann::json& swing = json.at("results").at(0);
  EXPECT_EQ(swing.at("name"), "swing");
  EXPECT_EQ(swing.at("slopes").at(0).at("kind"), "exact");
  EXPECT_EQ(swing.at("slopes").at(0).at("unit"), "deg/mm");
  EXPECT_EQ(swing.at("band").at("kept"), true);
  double shares = 0;
  for (const nlohmann::json& slope : swing.at("slopes")) shares += slope.at("share").get<double>();
  EXPECT_NEAR(shares, 1, 1e-12);
  EXPECT_EQ(swing.at("variants").at("variants"), 100);
  EXPECT_EQ(json.at("variants").at("count"), 100);
}

TEST_F(SensitivityCommand, WritesCsv) {
  const Outcome outcome = run(shipped_toml("flat_faced_translating") + " --results follower.y:max --csv -");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              StartsWith("result,column,of,value,unit,at[deg],number,number_value,number_unit,down,up,kind,"
                         "relative,share\nfollower.y:max,follower.y,max,"));
}

TEST_F(SensitivityCommand, WritesTheDerivativesOfColumnsRowByRow) {
  const std::string arguments = shipped_toml("flat_faced_translating") +
                                " --samples 5 --results follower.y:max --by bodies.cam.curves.disc.radius";
  const Outcome outcome = run(arguments + " --rows -");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("driver[deg],follower.y[mm],d(follower.y)/d(bodies.cam.curves.disc."
                                      "radius)[mm/mm]\n"));
  EXPECT_TRUE(contains(run(arguments + " --rows rows.csv --columns follower.y,follower.v*").out, "max of"));
  EXPECT_TRUE(contains(read_file(folder_ / "rows.csv"), "d(follower.vy)/d("));
}

TEST_F(SensitivityCommand, ExitsWithFourWhereThePathIsNotGood) {
  const Outcome outcome = run(shipped_toml("lock_up"));
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.out, "the path is not good"));
  EXPECT_TRUE(contains(outcome.err, "limit_position"));
  EXPECT_FALSE(contains(outcome.out, "nan"));
}

TEST_F(SensitivityCommand, HasNoBandOfAResultWithoutAValue) {
  const std::string lost =
      shipped_toml("toleranced_linkage") +
      " --set bodies.crank.points.A.0=55 --set driver.end=180 --set tolerances.results.swing.of=last";
  const Outcome outcome = run(lost);
  EXPECT_EQ(outcome.code, 4);
  EXPECT_FALSE(contains(outcome.out, "nan"));
  EXPECT_TRUE(contains_all(
      outcome.out, {"it has no value on this run", "wanted within +-0.5: undecided, for it has no value"}));
  const auto json = nlohmann::json::parse(run(lost + " --json -").out);
  const nlohmann::json& band = json["results"][0]["band"];
  EXPECT_EQ(band["within"], 0.5);
  EXPECT_TRUE(band["center"].is_null());
  EXPECT_FALSE(band.contains("tighten"));
}

TEST_F(SensitivityCommand, ExitsWithFourWhereThePathIsTooLongToExamine) {
  const Outcome outcome = run(shipped_toml("four_bar") +
                              " --results rocker.angle:max --by bodies.crank.points.A.0 --samples 2 "
                              "--set driver.end=1e6");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains_all(outcome.err, {"end at driver = ", "too long to look for extremes"}));
  EXPECT_TRUE(contains(outcome.out, "not examined beyond"));
}

TEST_F(SensitivityCommand, TakesAPlaceInAnyUnit) {
  const std::string arguments =
      shipped_toml("four_bar") + " --samples 37 --csv - --by bodies.crank.points.A.0 ";
  const Outcome degrees = run(arguments + "--results rocker.angle:at=90");
  EXPECT_EQ(degrees.code, 0) << degrees.err;
  const Outcome turns = run(arguments + "--results 'rocker.angle:at=0.25 rev'");
  EXPECT_EQ(turns.code, 0) << turns.err;
  EXPECT_EQ(turns.out.substr(turns.out.find(",rocker.angle,")),
            degrees.out.substr(degrees.out.find(",rocker.angle,")));
}

TEST_F(SensitivityCommand, SaysWhatIsWrong) {
  copy_profiles({"toleranced_linkage"});
  const auto message = [&](const std::string& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments << outcome.out;
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  };
  const std::string linkage = "toleranced_linkage.toml", cam = shipped_toml("flat_faced_translating");
  EXPECT_TRUE(contains(message(linkage + " --results rocker.angel:max"), "did you mean `rocker.angle`"));
  EXPECT_TRUE(contains(message(linkage + " --results rocker.angle"), "expected COLUMN:OF"));
  EXPECT_TRUE(contains(message(linkage + " --by bodies.krank"), "no number of the profile has such a path"));
  EXPECT_TRUE(contains(message(cam + " --variants 100"), "there is no [tolerances]"));
  EXPECT_TRUE(contains(message(linkage + " --variants 100 --by 'bodies.*'"), "leave --by out"));
  EXPECT_TRUE(contains(message(linkage + " --seed 3"), "add --variants N"));
  EXPECT_TRUE(contains(message(linkage + " --columns follower.y"), "add --rows FILE"));
  EXPECT_TRUE(contains(message(linkage + " --rows -  --columns 'roker.*'"), "no column of this run"));
  EXPECT_TRUE(contains(message(linkage + " --csv toleranced_linkage.toml"), "the file that is read"));
  EXPECT_TRUE(contains(message(linkage + " --csv a.csv --rows a.csv"), "give each a file of its own"));
  EXPECT_TRUE(contains(message(linkage + " --set tolerances.crank.plus_minus=-1"), "must be > 0"));
  EXPECT_TRUE(contains(message(linkage + " --variants 1"), "--variants"));
  EXPECT_EQ(run(linkage + " --set bodies.coupler.points.B.0=5").code, 3);
}

TEST_F(SensitivityCommand, StopsWhenInterrupted) {
  const Outcome outcome = interrupted(
      folder_, SIGINT, 1,
      "sensitivity " + shipped_toml("toleranced_linkage") + " --variants 10000000 --json late.json");
  EXPECT_EQ(outcome.code, 130);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "late.json"));
}

// The pipe is full, and nobody reads it: the rows wait for a reader when all of them are computed.
TEST_F(SensitivityCommand, StopsWhenInterruptedAtTheEndOfItsRows) {
  const UnreadPipe pipe(folder_ / "pipe");
  pipe.fill();
  const Outcome outcome = interrupted(
      folder_, SIGINT, 1, "sensitivity " + shipped_toml("toleranced_linkage") + " --samples 3 --rows pipe");
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
}

}  // namespace
