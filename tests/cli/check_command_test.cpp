#include "program_testing.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using higherpair::testing::contains;
using higherpair::testing::contains_all;
using higherpair::testing::Outcome;
using higherpair::testing::ProgramTest;
using higherpair::testing::shipped_profile;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::string shipped(const std::string& name) {
  return shipped_profile(name + ".toml");
}

class CheckCommand : public ProgramTest {
protected:
  [[nodiscard]] Outcome run(const std::string& arguments) const { return run_program("check " + arguments); }
};

TEST_F(CheckCommand, PrintsATableThatFitsAScreen) {
  const Outcome outcome = run(shipped("checked_cam"));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_TRUE(contains_all(outcome.out,
                           {"contacts.touch", "pressure angle", "at [deg]", "kept", "limits, all kept"}));
  for (const char* profile :
       {"checked_cam", "valve_train", "ellipse_cam_roller", "watt_sixbar_forces", "law_cam_flat"}) {
    std::istringstream lines(run(shipped(profile)).out);
    std::string line;
    while (std::getline(lines, line)) {
      EXPECT_LE(line.size(), 80U) << line;
    }
  }
}

TEST_F(CheckCommand, ExitsWithFourWhereALimitIsExceeded) {
  const Outcome outcome = run(shipped("checked_cam") + " --set limits.max_pressure_angle=20");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains_all(outcome.out, {"EXCEEDED", "1 of 8 limits exceeded"}));
}

TEST_F(CheckCommand, ExitsWithFourAndSaysWhichSpringWhereAContactOpens) {
  const Outcome outcome = run(shipped("cam_with_return_spring") + " --set 'driver.velocity=\"800 rpm\"'");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains_all(outcome.out, {"least contact force", "EXCEEDED", "it opens"}));
  EXPECT_TRUE(contains_all(outcome.err, {"contact_open", "springs.return"}));
}

TEST_F(CheckCommand, SaysWhatIsNotKnown) {
  const Outcome outcome = run(shipped("cam_with_return_spring") +
                              " --set limits.min_speed_factor=1 --set springs.return.damping=1e-7");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains_all(outcome.out, {"unknown", "1 undecided", "dampers act"}));
}

TEST_F(CheckCommand, ExitsWithFourWhereThePathIsNotGood) {
  const Outcome outcome = run(shipped("lock_up"));
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.out, "the path is not good"));
  EXPECT_TRUE(contains(outcome.err, "limit_position"));
}

TEST_F(CheckCommand, WritesJson) {
  const Outcome outcome = run(shipped("checked_cam") + " --json -");
  ASSERT_EQ(outcome.code, 0);
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("good"), true);
  EXPECT_EQ(json.at("driver_unit"), "deg");
  EXPECT_THAT(json.at("title").get<std::string>(), StartsWith("Cam with limits"));
  const nlohmann::json& first = json.at("figures").at(0);
  EXPECT_EQ(first.at("item"), "contacts.touch");
  EXPECT_EQ(first.at("quantity"), "pressure_angle");
  EXPECT_EQ(first.at("unit"), "deg");
  EXPECT_EQ(first.at("limit"), 30);
  EXPECT_EQ(first.at("verdict"), "kept");
  EXPECT_GT(first.at("value").get<double>(), 20);
  EXPECT_TRUE(first.at("at").is_number());
  EXPECT_TRUE(first.contains("of") && first.contains("remark"));
}

TEST_F(CheckCommand, WritesCsv) {
  const Outcome outcome = run(shipped("checked_cam") + " --csv -");
  EXPECT_THAT(
      outcome.out,
      StartsWith("item,of,quantity,value,unit,at[deg],limit,verdict\ncontacts.touch,,pressure_angle,"));
}

TEST_F(CheckCommand, SaysWhatIsWrongWithLimits) {
  const Outcome outcome =
      run(shipped("checked_cam") + " --set limits.max_presure_angle=20 --set limits.width=-1");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_TRUE(
      contains_all(outcome.err, {"did you mean `max_pressure_angle`", "limits.width = -1: must be > 0"}));
}

TEST_F(CheckCommand, NotesALimitOfNothingUnlessQuiet) {
  const std::string arguments = shipped("checked_cam") + " --set limits.max_face_width=20";
  EXPECT_TRUE(
      contains(run(arguments).err, "note: limits.max_face_width: nothing in this mechanism has this"));
  EXPECT_EQ(run(arguments).code, 0);
  EXPECT_THAT(run(arguments + " --quiet").err, IsEmpty());
}

TEST_F(CheckCommand, RunsInTimeWhereThatIsAskedFor) {
  const std::string arguments =
      shipped("checked_cam") + " --set driver.duration=0.1 --set driver.time_step=0.001 --json -";
  const auto figures = [&](const std::string& more) {
    return nlohmann::json::parse(run(arguments + more).out).at("figures");
  };
  const nlohmann::json whole = figures(""), timed = figures(" --time");
  ASSERT_EQ(whole.size(), timed.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const double a = whole[i].at("value").get<double>(), b = timed[i].at("value").get<double>();
    EXPECT_NEAR(std::abs(a), std::abs(b), 1e-7 * std::abs(a)) << whole[i];
  }
}

TEST_F(CheckCommand, ExitsWithThreeWhereNothingCanStart) {
  EXPECT_EQ(run(shipped("cam_with_return_spring") + " --set contacts.touch.rolling=true").code, 3);
}

}  // namespace
