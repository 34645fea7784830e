#include "cli/interrupting.hpp"
#include "higherpair/front/model.hpp"
#include "program_testing.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using higherpair::testing::contains;
using higherpair::testing::interrupted;
using higherpair::testing::Outcome;
using higherpair::testing::ProgramTest;
using higherpair::testing::read_file;
using higherpair::testing::shipped_profile;
namespace fs = std::filesystem;
using ::testing::MatchesRegex;

class Program : public ProgramTest {
protected:
  [[nodiscard]] Outcome run(const std::string& arguments) const { return run_program(arguments); }
};

std::string profile(const std::string& name) {
  return shipped_profile(name);
}

TEST_F(Program, RunsEveryShippedProfile) {
  for (const auto& entry : fs::directory_iterator(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles")) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome outcome = run("analyze " + entry.path().string());
    const bool locks_up = entry.path().stem() == "lock_up";
    EXPECT_EQ(outcome.code, locks_up ? 4 : 0) << entry.path() << outcome.err;
    EXPECT_TRUE(contains(outcome.out, locks_up ? "not_assemblable" : ",ok,"));
  }
}

TEST_F(Program, IsNotContentWithRowsWhereTheirPathIsNot) {
  // Both rows can be assembled, but the follower locks between them.
  const Outcome outcome = run("analyze " + profile("lock_up.toml") + " --set 'driver.positions=[0,359]'");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.err, "limit_position"));
  EXPECT_FALSE(contains(outcome.out, "not_assemblable"));
}

TEST_F(Program, StopsWithinALongRow) {
  const std::string table = (folder_ / "long.csv").string();
  const Outcome outcome =
      interrupted(folder_, SIGTERM, 0.5,
                  "analyze " + profile("four_bar.toml") + " --set driver.end=1e9 --samples 2 --csv " + table);
  EXPECT_EQ(outcome.code, 130);
  for (const auto& entry : fs::directory_iterator(folder_)) {
    EXPECT_EQ(entry.path().string().find(table), std::string::npos) << entry.path();
  }
}

TEST_F(Program, ReportsTheLimitPositionsToTheLastDigits) {
  const Outcome outcome = run("analyze " + profile("lock_up.toml") + " --json -");
  EXPECT_EQ(outcome.code, 4);
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  std::vector<double> limits;
  for (const nlohmann::json& event : json.at("events")) {
    if (event.at("type") == "limit_position") {
      limits.push_back(event.at("driver").get<double>());
      EXPECT_EQ(event.at("item"), "touch");
    }
  }
  ASSERT_EQ(limits.size(), 2U);
  // |O2 - C1| = 75 mm.
  EXPECT_NEAR(limits[0], 65.83442067466342, 1e-12);
  EXPECT_NEAR(limits[1], 360 - 65.83442067466342, 1e-12);
  EXPECT_EQ(json.at("rows").size(), 361U);
}

// The driver starts at 60 deg/s and accelerates with 20 deg/s²: t = (√(3600 + 40 θ) - 60)/20, θ in degrees.
TEST_F(Program, TellsTheTimeOfEventsBetweenTheRowsOfAStep) {
  const Outcome outcome = run("step " + profile("lock_up.toml") +
                              " --set driver.velocity=60 --set driver.acceleration=20 --set driver.duration=4"
                              " --set driver.time_step=0.07 --json -");
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  int limits = 0;
  for (const nlohmann::json& event : json.at("events")) {
    const double theta = event.at("driver").get<double>();
    EXPECT_NEAR(event.at("time").get<double>(), (std::sqrt(3600 + 40 * theta) - 60) / 20, 1e-13);
    limits += event.at("type") == "limit_position" ? 1 : 0;
  }
  EXPECT_EQ(limits, 2);
  EXPECT_THAT(outcome.err, ::testing::ContainsRegex(", time = [0-9.]+ s: "));
}

// Two rows at 50 degrees; between them the driver goes to 70 and back, passing the limit twice.
TEST_F(Program, SeesWhatADriverPassesAndPassesBackBetweenTwoRows) {
  const Outcome outcome = run("step " + profile("lock_up.toml") +
                              " --set driver.start=50 --set driver.velocity=40 --set driver.acceleration=-40"
                              " --set driver.duration=2 --samples 2 --json -");
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  std::vector<double> times;
  for (const nlohmann::json& event : json.at("events")) {
    if (event.at("type") == "limit_position") times.push_back(event.at("time").get<double>());
  }
  const double back = std::sqrt(1 - (65.83442067466342 - 50) / 20);
  ASSERT_EQ(times.size(), 2U);
  EXPECT_NEAR(times[0], 1 - back, 1e-13);
  EXPECT_NEAR(times[1], 1 + back, 1e-13);
}

TEST_F(Program, SummarisesARunWithJerk) {
  const Outcome outcome = run("analyze " + profile("ellipse_cam_roller.toml") + " --jerk --summary");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "rows: 361 ok"));
  EXPECT_TRUE(contains(outcome.out, "\nfollower\n"));
  EXPECT_TRUE(contains(outcome.out, "\n  jerk "));
}

// Where all columns of a unit ought to be 0, what they are worked out from tells their rounding.
TEST_F(Program, SummarisesRoundingOfRatesAsZero) {
  for (const char* name : {"parallelogram.toml", "gear_teeth.toml", "involute_pair.toml"}) {
    const Outcome outcome = run("analyze " + profile(name) + " --summary --quiet");
    EXPECT_FALSE(contains(outcome.out, "deg/s^2")) << name;
    EXPECT_TRUE(contains(outcome.out, "always 0: ")) << name;
  }
  const Outcome rolling = run("analyze " + profile("rolling_ellipses.toml") + " --summary --quiet");
  EXPECT_FALSE(contains(rolling.out, "  sliding "));
  EXPECT_TRUE(contains(rolling.out, "\n  alpha                   -11254.59"));
  const Outcome slow = run("analyze " + profile("four_bar.toml") +
                           " --set driver.velocity='\"1e-9 rad/s\"' --summary --quiet");
  EXPECT_TRUE(contains(slow.out, "  alpha "));
  EXPECT_TRUE(contains(slow.out, "deg/s^2"));
}

TEST_F(Program, WritesRoundingOfPlacesAsZero) {
  EXPECT_FALSE(contains(run("branches " + profile("tangent_cam.toml") + " --quiet").out, "e-1"));
  EXPECT_TRUE(contains(run("mobility " + profile("double_rocker.toml") + " --quiet").out,
                       "left_arm, right_arm: (65637.68, 0)"));
}

// Largest and smallest angle of the demo's follower: where crank and coupler are in line, at 47.92 and 211.10
// degrees.
TEST_F(Program, SummarisesWhatChangesAndWhereItIsExtreme) {
  const Outcome outcome =
      run("analyze " + profile("eccentric_disc_oscillating_roller.toml") + " --summary --quiet");
  EXPECT_TRUE(contains(outcome.out,
                       "\n  angle                   -33.82627        48     -12.42927       211  deg\n"));
  EXPECT_TRUE(
      contains(outcome.out, "constant: driver.velocity 60 deg/s, cam.omega 60 deg/s, follower.x 80 mm,\n"));
  EXPECT_TRUE(contains(outcome.out, "\nalways 0: 25 columns\n"));
  EXPECT_FALSE(contains(outcome.out, "-0 "));
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST_F(Program, WritesEventsAsATableOfTheirOwn) {
  const std::string table = (folder_ / "table.csv").string(), events = (folder_ / "events.csv").string();
  const std::string command =
      "analyze " + profile("eccentric_disc_oscillating_roller.toml") + " --csv " + table;
  const Outcome told = run(command + " --events " + events);
  EXPECT_EQ(told.code, 0);
  EXPECT_THAT(told.err,
              ::testing::ContainsRegex(
                  "stroke_end at driver = 47.9222[0-9]* deg: follower_pivot = -?[0-9.]* deg: the motion"));
  std::ifstream file(events);
  std::string header, first, second, end;
  std::getline(file, header);
  std::getline(file, first);
  std::getline(file, second);
  EXPECT_EQ(header, "type,driver[deg],time[s],item,row,cause");
  EXPECT_EQ(first.substr(0, 24), "stroke_end,47.9222147823");
  EXPECT_TRUE(contains(second, ",,follower_pivot,212,\"the motion of this joint reverses\""));
  EXPECT_FALSE(std::getline(file, end));
  const Outcome shared = run(command + " --events " + table);
  EXPECT_EQ(shared.code, 2);
  EXPECT_TRUE(contains(shared.err, "--csv and --events: both name"));
}

TEST_F(Program, EndsWithExitCodeFourWhereThePathIsNotGoodBetweenRowsThatAre) {
  const Outcome lock_up =
      run("analyze " + profile("lock_up.toml") + " --set driver.positions=[0,359] --json - --summary");
  EXPECT_EQ(lock_up.code, 4);
  EXPECT_TRUE(contains(lock_up.out, "\"ok\": false}"));
  EXPECT_TRUE(contains(lock_up.out, "rows: 2 ok\npath: not ok, 2 limit_position"));
  const Outcome opens = run("forces " + profile("cam_with_return_spring.toml") +
                            " --set driver.velocity='\"900 rpm\"' --samples 3");
  EXPECT_EQ(opens.code, 4);
  EXPECT_TRUE(contains(opens.err, "contact_open at driver = "));
  const Outcome good = run("analyze " + profile("lock_up.toml") + " --set driver.positions=[0,30] --json -");
  EXPECT_EQ(good.code, 0);
  EXPECT_EQ(nlohmann::json::parse(good.out).at("ok"), true);
}

TEST_F(Program, WritesTheColumnsAskedFor) {
  const std::string command = "analyze " + profile("ellipse_cam_roller.toml") + " --samples 3 ";
  const Outcome csv = run(command + "--columns 'driver,follower.a*' --columns touch.linkage,status");
  EXPECT_EQ(csv.code, 0) << csv.err;
  EXPECT_EQ(csv.out.substr(0, csv.out.find('\n')),
            "driver[deg],follower.angle[deg],follower.ax[mm/s^2],follower.ay[mm/s^2],follower.alpha[deg/s^2],"
            "touch.linkage,status");
  EXPECT_TRUE(contains(csv.out, ",four-bar,ok\n"));
  const Outcome json = run(command + "--columns driver,status --json -");
  EXPECT_EQ(nlohmann::json::parse(json.out).at("rows").at(0), nlohmann::json::parse("[0, \"ok\"]"));
  const Outcome summary = run(command + "--columns follower.omega --summary");
  EXPECT_TRUE(contains(summary.out, "\n  omega "));
  EXPECT_FALSE(contains(summary.out, "  alpha"));
  EXPECT_TRUE(contains(summary.out, "rows: 3 ok"));
  const Outcome wrong = run(command + "--columns driver,folower.omega --csv " + (folder_ / "table").string());
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(contains(wrong.err,
                       "--columns folower.omega: no column of this run has such a name; did you "
                       "mean `follower.omega`"));
  EXPECT_FALSE(fs::exists(folder_ / "table"));
}

TEST_F(Program, SaysWhereTheFileIsWrongAndWritesNothing) {
  const fs::path table = folder_ / "table.csv";
  const Outcome outcome = run("analyze " + profile("knife_edge.toml") +
                              " --set bodies.cam.curves.disc.radius=-12 --csv " + table.string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err, "must be > 0"));
  EXPECT_FALSE(fs::exists(table));
  EXPECT_EQ(run("analyze no_such_file.toml").code, 2);
  EXPECT_EQ(run("analyze " + profile("knife_edge.toml") + " --no-such-option").code, 2);
  EXPECT_EQ(run("").code, 2);
}

TEST_F(Program, SaysThatThereIsNoContact) {
  const fs::path table = folder_ / "table.csv";
  const Outcome outcome =
      run("analyze " + profile("lock_up.toml") + " --set driver.start=180 --csv " + table.string());
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(contains(outcome.err, "do not touch"));
  EXPECT_FALSE(fs::exists(table));
}

TEST_F(Program, RefusesAnOverlapAtThePoseWhenTheFollowerIsToBeMovedUntilItTouches) {
  const Outcome outcome = run("analyze " + profile("knife_edge.toml") + " --set bodies.follower.pose.y=10");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(contains(outcome.err, "overlap"));
}

TEST_F(Program, FailsWhereItCannotWrite) {
  EXPECT_EQ(
      run("analyze " + profile("knife_edge.toml") + " --csv " + (folder_ / "none" / "t.csv").string()).code,
      1);
  EXPECT_EQ(run("analyze " + profile("knife_edge.toml") + " --csv /dev/full").code, 1);
}

TEST_F(Program, SaysThatANumberHasToBeWhole) {
  EXPECT_TRUE(contains(run("analyze " + profile("four_bar.toml") + " --derivatives 3.5").err,
                       "--derivatives 3.5: must be an integer from 3 to 6"));
  EXPECT_TRUE(contains(run("map " + profile("ellipse_cam_roller.toml") + " --samples 1").err,
                       "--samples 1: must be an integer from 2 to 10000000"));
}

// Events, notes, messages and errors of arguments.
TEST_F(Program, DoesTheSameWhereStandardErrorCannotBeWritten) {
  const fs::path table = folder_ / "table.csv";
  const std::string lock_up = profile("lock_up.toml"), to_table = " --csv " + table.string();
  const std::vector<std::pair<std::string, int>> commands = {
      {"analyze " + lock_up + to_table, 4},
      {"check " + profile("cam_with_return_spring.toml") + " --set gravity=9.81" + to_table, 2},
      {"analyze " + (folder_ / "none.toml").string(), 2},
      {"analyze --nonsense", 2}};
  for (const auto& [command, code] : commands) {
    EXPECT_EQ(run(command).code, code) << command;
    for (const char* closed : {" 2>/dev/full", " 2>&-"}) {
      EXPECT_EQ(run_script(std::string(HIGHERPAIR_PROGRAM) + " " + command + " >/dev/null" + closed).code,
                code)
          << command << closed;
    }
  }
  EXPECT_TRUE(fs::exists(table));
}

TEST_F(Program, WritesAllItsFilesOrNone) {
  const fs::path table = folder_ / "table.csv";
  const std::string none = (folder_ / "none" / "t.json").string();
  for (const std::string command : {"analyze", "branches", "map"}) {
    const std::string to_table =
        command + " " + profile("ellipse_cam_roller.toml") + " --csv " + table.string();
    EXPECT_EQ(run(fmt::format("{} --json {}", to_table, none)).code, 1);
    EXPECT_EQ(run(to_table + " --json /dev/full").code, 1);
    EXPECT_FALSE(fs::exists(table)) << command;
    EXPECT_EQ(run(to_table + " --json /dev/null").code, 0);
    EXPECT_TRUE(fs::remove(table));
  }
}

TEST_F(Program, SaysBeforeALongRunThatItsEventsCannotBeWritten) {
  const std::string command = fmt::format("timeout 60 {} analyze {} --samples 1000000000", HIGHERPAIR_PROGRAM,
                                          profile("knife_edge.toml"));
  const Outcome outcome = run_script(command + " --csv /dev/null --events none/e.csv");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(contains(outcome.err, "none/e.csv: there is no folder none"));
}

TEST_F(Program, MakesTheFileThatALinkNames) {
  const fs::path link = folder_ / "link";
  fs::create_symlink("file", link);
  EXPECT_EQ(run("analyze " + profile("ellipse_cam_roller.toml") + " --csv " + link.string()).code, 0);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(contains(read_file(folder_ / "file"), "driver[deg]"));
  fs::create_symlink("round", folder_ / "round");
  EXPECT_EQ(
      run("analyze " + profile("ellipse_cam_roller.toml") + " --csv " + (folder_ / "round").string()).code,
      1);
}

TEST_F(Program, KeepsWhoMayReadAFileThatItReplaces) {
  const fs::path table = folder_ / "private.csv";
  std::ofstream(table) << "old";
  const fs::perms owner_only = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(table, owner_only);
  EXPECT_EQ(run("analyze " + profile("ellipse_cam_roller.toml") + " --csv " + table.string()).code, 0);
  EXPECT_TRUE(contains(read_file(table), "driver[deg]"));
  EXPECT_EQ(fs::status(table).permissions(), owner_only);
}

TEST_F(Program, CanBeInterruptedWhileNobodyReads) {
  ASSERT_EQ(run_script("mkfifo pipe").code, 0);
  const std::string command = "analyze " + profile("ellipse_cam_roller.toml") + " --csv pipe";
  EXPECT_EQ(interrupted(folder_, SIGINT, 0.3, command).code, 130);
}

// A single row a thousand million degrees away takes minutes.
TEST_F(Program, CanBeInterruptedWithinALongRow) {
  const fs::path folder = folder_ / "long";
  fs::create_directories(folder);
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string command = "analyze " + profile("ellipse_cam_roller.toml") +
                                " --set driver.end=1e9 --samples 2 --csv " + (folder / "table").string();
    EXPECT_EQ(interrupted(folder_, signal, 0.5, command).code, 130);
    EXPECT_TRUE(fs::is_empty(folder));
  }
}

TEST_F(Program, SaysThatStandardOutputIsFull) {
  const auto full = [&](const std::string& arguments) {
    const std::string err = (folder_ / "err").string();
    const int status =
        std::system((std::string(HIGHERPAIR_PROGRAM) + " " + arguments + " >/dev/full 2>" + err).c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1) << arguments;
    return read_file(err);
  };
  const std::string message = "higherpair: cannot write to standard output: No space left on device\n";
  EXPECT_EQ(full("analyze " + profile("four_bar.toml") + " --quiet --csv -"), message);
  EXPECT_EQ(full("analyze " + profile("four_bar.toml") + " --quiet"), message);
  EXPECT_EQ(full("analyze " + profile("four_bar.toml") + " --quiet --summary"), message);
  EXPECT_EQ(full("analyze " + profile("lock_up.toml") + " --quiet --summary"), message);
  EXPECT_EQ(full("mobility " + profile("four_bar.toml")), message);
  EXPECT_EQ(full("verify"), message);
  EXPECT_EQ(full("--version"), message);
  EXPECT_EQ(full("draw " + profile("four_bar.toml") + " -o -"), message);
}

TEST_F(Program, LeavesNoPartFileWhereAReaderHasReadEnough) {
  const std::string table = (folder_ / "table.csv").string();
  const std::string command = std::string(HIGHERPAIR_PROGRAM) + " analyze " + profile("four_bar.toml") +
                              " --samples 20000 --json - --csv " + table + " 2>" +
                              (folder_ / "err").string() + " | head -1 >/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(read_file(folder_ / "err"), "");
  for (const auto& entry : fs::directory_iterator(folder_)) {
    EXPECT_EQ(entry.path().filename(), "err");
  }
}

TEST_F(Program, EndsWithExitCode1WhereNobodyReadsWhateverTheCommand) {
  const std::string code = (folder_ / "code").string(), err = (folder_ / "err").string();
  for (const std::string& arguments :
       {"mobility " + profile("four_bar.toml"), "branches " + profile("four_bar.toml"), std::string("--help"),
        "analyze " + profile("four_bar.toml")}) {
    // The reader has gone before the program begins.
    const std::string command = "(sleep 0.2; " + std::string(HIGHERPAIR_PROGRAM) + " " + arguments + " 2>" +
                                err + "; echo $? >" + code + ") | true";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(read_file(code), "1\n") << arguments;
  }
}

TEST_F(Program, SaysHowManyRowsAreNotSolvedToTheTolerance) {
  const std::string rows = "analyze " + profile("four_bar.toml") + " --tolerance 1e-30";
  const Outcome few = run(rows + " --samples 5");
  EXPECT_EQ(few.code, 4);
  EXPECT_TRUE(contains(few.err, " of 5 rows are `not_converged`, the first at driver = "));
  EXPECT_TRUE(contains(few.err, " cm, where the tolerance is 4.66e-30\n"));
  // Rows of blocks that are computed on several threads are counted as well.
  const Outcome many = run(rows + " --samples 20001 --columns driver,status --json -");
  std::int64_t count = 0;
  const nlohmann::json table = nlohmann::json::parse(many.out);
  for (const auto& row : table.at("rows")) count += row.at(1) == "not_converged" ? 1 : 0;
  EXPECT_TRUE(contains(many.err, std::to_string(count) + " of 20001 rows"));
}

TEST_F(Program, SaysThatNothingIsDriven) {
  std::ofstream(folder_ / "still.toml") << R"([bodies.ground]
points = { A = [0, 0], B = [10, 0] }
[bodies.a]
points = { A = [0, 0], C = [6, 8] }
[bodies.b]
points = { B = [10, 0], C = [6, 8] }
[joints]
A = { type = "revolute", between = ["ground.A", "a.A"] }
B = { type = "revolute", between = ["ground.B", "b.B"] }
C = { type = "revolute", between = ["a.C", "b.C"] }
[drivers]
)";
  const std::string still = (folder_ / "still.toml").string();
  for (const char* command :
       {"analyze ", "step ", "forces ", "branches ", "map ", "plot --y 'a.*' -o p.svg ", "check "}) {
    const Outcome outcome = run(command + still);
    EXPECT_EQ(outcome.code, 3) << command;
    EXPECT_TRUE(contains(outcome.err, "nothing moves this mechanism"));
  }
  EXPECT_EQ(run("mobility " + still).code, 0);
}

TEST_F(Program, TellsItsVersionEverywhereAndKnowsItsCommands) {
  for (const char* command : {"", "analyze ", "mobility ", "map ", "verify "}) {
    EXPECT_EQ(run(std::string(command) + "--version").out,
              fmt::format("higherpair {}\n", higherpair::version()));
  }
  const Outcome wrong = run("analyse " + profile("four_bar.toml"));
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(contains(wrong.err, "there is no command analyse"));
  EXPECT_EQ(std::system((std::string(HIGHERPAIR_PROGRAM) + " --version >/dev/full 2>/dev/null").c_str()) >> 8,
            1);
}

TEST_F(Program, RefusesTwoTablesInOneFile) {
  const std::string table = (folder_ / "table").string();
  const std::string same = (folder_ / "none" / ".." / "table").string();
  for (const std::string command : {"analyze", "step", "forces", "branches", "map"}) {
    for (const std::string& outputs :
         {fmt::format("--csv {0} --json {0}", table), fmt::format("--csv {} --json {}", table, same),
          std::string("--csv - --json -")}) {
      const Outcome outcome =
          run(fmt::format("{} {} {}", command, profile("cam_with_return_spring.toml"), outputs));
      EXPECT_EQ(outcome.code, 2) << command << " " << outputs;
      EXPECT_TRUE(contains(outcome.err, "give each a file of its own"));
      EXPECT_EQ(outcome.out, "");
      EXPECT_FALSE(fs::exists(table));
    }
  }
  EXPECT_EQ(run("analyze " + profile("ellipse_cam_roller.toml") + " --csv /dev/null --json /dev/null").code,
            0);
}

TEST_F(Program, WritesTheSameRowsToFilesAsToStandardOutput) {
  const fs::path table = folder_ / "table.csv";
  const Outcome direct = run("step " + profile("offset_translating_roller.toml"));
  EXPECT_EQ(direct.code, 0);
  EXPECT_EQ(run("step " + profile("offset_translating_roller.toml") + " --csv " + table.string()).code, 0);
  EXPECT_EQ(read_file(table), direct.out);
  EXPECT_EQ(std::count(direct.out.begin(), direct.out.end(), '\n'), 202);
  EXPECT_TRUE(contains(direct.out, "time[s],driver[deg],driver.velocity[deg/s]"));
}

TEST_F(Program, WritesReactionsBelowTheSpeedOfLiftOff) {
  const Outcome outcome = run("forces " + profile("cam_with_return_spring.toml") + " --quiet");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(contains(outcome.out,
                       "guide.m[N*mm],touch.force[N],touch.friction[N],driver.effort[N*mm],"
                       "driver.effort_check[N*mm],status,residual[mm]\n"));
}

TEST_F(Program, SaysWhereAContactOpensAndWhatWouldKeepItClosed) {
  const Outcome outcome = run("forces " + profile("cam_with_return_spring.toml") +
                              " --set 'driver.velocity=\"800 rpm\"' --json -");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.err, "contact_open at driver = 56.951882894546"));
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  const auto opens = std::find_if(json.at("events").begin(), json.at("events").end(),
                                  [](const nlohmann::json& one) { return one.at("type") == "contact_open"; });
  ASSERT_NE(opens, json.at("events").end());
  const nlohmann::json& event = *opens;
  // N = 10.943 N - (m e w^2 - k e) sin(theta), see the profile.
  const double w = 800 * 2 * 3.14159265358979323846 / 60;
  const double angle = std::asin(10.943 / (0.003 * w * w - 8)) * 180 / 3.14159265358979323846;
  EXPECT_NEAR(event.at("driver").get<double>(), angle, 1e-11);
  EXPECT_EQ(event.at("type"), "contact_open");
  EXPECT_EQ(event.at("item"), "touch");
  EXPECT_TRUE(contains(event.at("cause").get<std::string>(), "springs.return pushes by 2.11216 N more"));
  const auto status = json.at("rows").at(0).size() - 2;
  EXPECT_EQ(json.at("rows").at(56).at(status), "ok");
  EXPECT_EQ(json.at("rows").at(57).at(status), "contact_open");
}

TEST_F(Program, SeesAContactOpenBetweenTwoRowsThatAreClosed) {
  for (const std::string samples : {"2", "3", "5"}) {
    const Outcome outcome = run("forces " + profile("cam_with_return_spring.toml") +
                                " --set 'driver.velocity=\"900 rpm\"' --summary --json " +
                                (folder_ / "forces.json").string() + " --samples " + samples);
    EXPECT_EQ(outcome.code, 4);
    EXPECT_TRUE(contains(outcome.err, "contact_open at driver = 35.931747207774"));
    EXPECT_TRUE(contains(outcome.out, "smallest force of touch: -7.704"));
    EXPECT_TRUE(contains(outcome.out, "N at driver = 90 deg"));
    EXPECT_TRUE(contains(outcome.out, "contacts stay closed up to 0.84312 times the speed"));
    const nlohmann::json json = nlohmann::json::parse(read_file(folder_ / "forces.json"));
    EXPECT_EQ(std::count_if(json.at("events").begin(), json.at("events").end(),
                            [](const nlohmann::json& one) { return one.at("type") == "contact_open"; }),
              1);
  }
}

// The contact opens at 57 degrees and strokes end at 90 and 270; backwards it opens at 123.
TEST_F(Program, ListsEventsBetweenTwoRowsInTheOrderOfTheMotion) {
  const auto events = [&](const std::string& way) {
    const Outcome outcome = run("forces " + profile("cam_with_return_spring.toml") +
                                " --set 'driver.velocity=\"800 rpm\"' --json - " + way);
    EXPECT_EQ(outcome.code, 4) << way;
    const nlohmann::json json = nlohmann::json::parse(outcome.out);
    std::vector<std::string> types;
    for (const auto& event : json.at("events")) types.push_back(event.at("type"));
    return types;
  };
  const std::vector<std::string> there = {"contact_open", "stroke_end", "stroke_end"};
  const std::vector<std::string> back = {"stroke_end", "contact_open", "stroke_end"};
  EXPECT_EQ(events("--samples 2"), there);
  EXPECT_EQ(events("--samples 3"), there);
  EXPECT_EQ(events("--samples 2 --set driver.start=360 --set driver.end=0"), back);
  std::vector<std::string> both = there;
  both.insert(both.end(), back.begin(), back.end());
  EXPECT_EQ(events("--set driver.positions=[0,360,0]"), both);
}

// 800 rpm are 4800 degrees a second.
TEST_F(Program, GivesAContactThatOpensItsTime) {
  const Outcome outcome = run("forces " + profile("cam_with_return_spring.toml") +
                              " --time --set 'driver.velocity=\"800 rpm\"' --set driver.duration=0.075 "
                              "--samples 3 --json -");
  EXPECT_EQ(outcome.code, 4);
  const nlohmann::json events = nlohmann::json::parse(outcome.out).at("events");
  ASSERT_EQ(events.size(), 3);
  EXPECT_EQ(events[0].at("type"), "contact_open");
  EXPECT_NEAR(events[0].at("time").get<double>(), 56.951882894546 / 4800, 1e-12);
  EXPECT_NEAR(events[1].at("time").get<double>(), 90.0 / 4800, 1e-12);
}

TEST_F(Program, GivesCurvaturesInTheUnitsOfTheProfile) {
  const Outcome outcome = run("analyze " + profile("four_arc_cam.toml") + " --columns driver");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(
      contains(outcome.err, "the curvature of cam jumps from 0.0263158 to 0.125 1/mm; for a unit rate"));
}

// A mechanism without any extent: its travel can only be compared with 1 m.
TEST_F(Program, SaysHowFarADriverCanSlide) {
  const fs::path file = folder_ / "slide.toml";
  std::ofstream(file) << R"(units.length = "m"
bodies.ground.points.O = [0, 0]
bodies.slide.points.P  = [0, 0]
joints.guide = { type = "prismatic", between = ["ground.O", "slide.P"], direction = [1, 0] }
driver = { joint = "guide", start = 0, end = 1e12, samples = 2 }
)";
  const Outcome outcome = run("analyze " + file.string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(contains(outcome.err,
                       "driver goes 1e+12 m in all; at most 1e+07 m, 1e7 times "
                       "the size of the mechanism, can be followed"));
  EXPECT_EQ(run("analyze " + file.string() + " --set driver.end=0.5").code, 0);
  EXPECT_EQ(run("analyze " + file.string() + " --set driver.positions=[0,1e12,0]").code, 2);
  EXPECT_EQ(run("analyze " + file.string() + " --set driver.positions=[1e12,1000000000100]").code, 0);
}

TEST_F(Program, SaysHowManyTurnsADriverCanMake) {
  const std::string analyze = "analyze " + profile("slider_crank.toml");
  const Outcome far = run(analyze + " --samples 2 --set driver.end=1e10");
  EXPECT_EQ(far.code, 2);
  EXPECT_EQ(far.out, "");
  EXPECT_TRUE(contains(far.err,
                       "--set driver.end=1e10: driver goes 2.77778e+07 turns in all; at most 1e7 turns "
                       "can be followed; change its `end`, `positions` or `duration`"));
  const Outcome fast = run("step " + profile("slider_crank.toml") +
                           " --samples 2 --set 'driver.velocity=\"1e9 rad/s\"' --set driver.duration=2");
  EXPECT_EQ(fast.code, 2);
  EXPECT_TRUE(contains(fast.err, "--set driver.duration=2: driver goes 3.1831e+08 turns in all"));
  // Counted from the start of the path, however far away that is.
  EXPECT_EQ(run(analyze + " --samples 2 --set driver.start=1e10 --set driver.end=10000000360").code, 0);
}

// A stroke ends twice in a turn.
TEST_F(Program, SaysWhereARunHasMoreEventsThanItKeeps) {
  const std::string table = (folder_ / "table.csv").string();
  const Outcome outcome = run("analyze " + profile("slider_crank.toml") +
                              " --samples 4 --set driver.end=1e9 --columns driver,status --csv " + table);
  EXPECT_EQ(outcome.code, 4);
  const auto lines = std::count(outcome.err.begin(), outcome.err.end(), '\n');
  EXPECT_EQ(lines, 250'001);
  EXPECT_THAT(
      outcome.err.substr(outcome.err.rfind('\n', outcome.err.size() - 2) + 1),
      MatchesRegex(
          "end at driver = 4499[0-9.]+ deg: 250000 events lie between two rows, and this path is "
          "not followed further; let the drivers go less far, or take more rows \\(driver.samples; in "
          "time a shorter driver.time_step\\)\n"));
  EXPECT_TRUE(contains(read_file(table), "1e+09,not_assemblable\n"));
}

TEST_F(Program, CountsOpenRowsInTheSummaryOfForces) {
  const Outcome outcome = run("forces " + profile("cam_with_return_spring.toml") +
                              " --set 'driver.velocity=\"800 rpm\"' --summary --quiet");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(outcome.err, "");
  // 57 ... 123 degrees.
  EXPECT_TRUE(contains(outcome.out, "67 contact_open"));
}

TEST_F(Program, RunsTheForcesOfEveryShippedProfile) {
  for (const auto& entry : fs::directory_iterator(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles")) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome outcome = run("forces " + entry.path().string());
    EXPECT_EQ(outcome.code, entry.path().stem() == "lock_up" ? 4 : 0) << entry.path() << outcome.err;
  }
}

TEST_F(Program, WritesJerkBesideThatOfTheFrozenLinkage) {
  const Outcome plain = run("analyze " + profile("flat_faced_translating.toml") + " --samples 3");
  EXPECT_EQ(plain.out.find("jerk"), std::string::npos);
  const Outcome outcome =
      run("analyze " + profile("flat_faced_translating.toml") + " --jerk --samples 3 --json -");
  EXPECT_EQ(outcome.code, 0);
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  const nlohmann::json& columns = json.at("columns");
  const std::size_t last = columns.size() - 1;
  EXPECT_TRUE(contains(columns[last].at("name").get<std::string>(), ".jerk_linkage"));
  EXPECT_EQ(columns[last].at("unit"), "mm/s^3");
  // The radius of curvature of a disc is constant.
  for (const nlohmann::json& row : json.at("rows")) {
    ASSERT_EQ(row.size(), columns.size());
    EXPECT_NEAR(row[last - 1].get<double>(), row[last].get<double>(), 1e-6);
  }
}

}  // namespace
