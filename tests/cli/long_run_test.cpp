// analyze, step and forces over many rows: the same files with any number of threads, and as HDF5.
#include "cli/interrupting.hpp"
#include "cli/program_testing.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <string>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace higherpair::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class LongRun : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    copy_profiles({"four_bar", "watt_sixbar_forces", "ellipse_cam_roller", "double_rocker",
                   "start_stop_crank", "gear_teeth"});
  }

  [[nodiscard]] Outcome run_interrupted(int signal, double seconds, const std::string& arguments) const {
    return interrupted(folder_, signal, seconds, arguments);
  }

  /// That nothing is left of an output whose name begins with "t.".
  void expect_no_output(const std::string& command) const {
    for (const auto& entry : fs::directory_iterator(folder_)) {
      EXPECT_THAT(entry.path().filename().string(), Not(StartsWith("t."))) << command;
    }
  }

  /// The output of h5dump for a file; empty where h5dump is missing or the program has no HDF5.
  [[nodiscard]] std::string dumped(const std::string& arguments) const {
    const std::string to = (folder_ / "dump").string();
    const std::string command =
        fmt::format("cd '{}' && h5dump {} >'{}' 2>/dev/null", folder_.string(), arguments, to);
    return std::system(command.c_str()) == 0 ? read_file(to) : "";
  }
};

TEST_F(LongRun, WritesTheSameFilesOnAnyNumberOfThreads) {
  for (const std::string command : {"analyze four_bar.toml", "forces watt_sixbar_forces.toml",
                                    "analyze double_rocker.toml", "step start_stop_crank.toml"}) {
    const auto run = [&](int threads) {
      return run_program(
          fmt::format("{} --samples 12500 --threads {} --csv {}.csv --json {}.json --events {}.events",
                      command, threads, threads, threads, threads));
    };
    const Outcome one = run(1);
    EXPECT_THAT(one.code, ::testing::AnyOf(0, 4)) << one.err;
    const std::string csv = file("1.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 12501);
    for (const int threads : {2, 5}) {
      const Outcome many = run(threads);
      EXPECT_EQ(many.code, one.code);
      EXPECT_EQ(many.err, one.err);
      for (const std::string kind : {".csv", ".json", ".events"}) {
        EXPECT_TRUE(file(std::to_string(threads) + kind) == file("1" + kind)) << command << kind;
      }
    }
  }
}

TEST_F(LongRun, SummarisesTheSameOnAnyNumberOfThreads) {
  const std::string one = run_program("analyze four_bar.toml --samples 9000 --threads 1 --summary").out;
  EXPECT_TRUE(contains(one, "rows: 9000 ok"));
  EXPECT_EQ(run_program("analyze four_bar.toml --samples 9000 --threads 3 --summary").out, one);
}

TEST_F(LongRun, WritesHdf5WithUnitsAndEvents) {
  if (!HIGHERPAIR_HAS_HDF5) {
    GTEST_SKIP() << "built without HDF5";
  }
  const Outcome outcome =
      run_program("analyze ellipse_cam_roller.toml --samples 9000 --threads 2 --hdf5 two.h5");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(run_program("analyze ellipse_cam_roller.toml --samples 9000 --threads 1 --hdf5 one.h5").code, 0);
  EXPECT_THAT(file("one.h5"), StartsWith("\x89HDF\r\n"));
  EXPECT_TRUE(file("one.h5") == file("two.h5"));
  const std::string head = dumped("-A one.h5");
  if (head.empty()) {
    GTEST_SKIP() << "there is no h5dump (hdf5-tools)";
  }
  EXPECT_TRUE(contains(head, "DATASET \"follower.angle\""));
  EXPECT_TRUE(contains(head, "SIMPLE { ( 9000 )"));
  EXPECT_TRUE(contains(dumped("-a follower.alpha/unit one.h5"), "\"deg/s^2\""));
  EXPECT_TRUE(contains(dumped("-a events/driver/unit one.h5"), "\"deg\""));
  EXPECT_TRUE(contains(dumped("-a ok one.h5"), "\"yes\""));
  EXPECT_TRUE(contains(dumped("-a events one.h5"), "stroke_end at driver = "));
  EXPECT_TRUE(contains(dumped("-d events/type one.h5"), "\"stroke_end\""));
  EXPECT_TRUE(contains(dumped("-d status -s 8999 -c 1 one.h5"), "(8999): ok"));
}

TEST_F(LongRun, WritesSmallHdf5FilesForFewRows) {
  if (!HIGHERPAIR_HAS_HDF5) {
    GTEST_SKIP() << "built without HDF5";
  }
  EXPECT_EQ(run_program("analyze ellipse_cam_roller.toml --hdf5 few.h5 --csv few.csv --quiet").code, 0);
  EXPECT_EQ(
      run_program("analyze ellipse_cam_roller.toml --hdf5 many.h5 --csv many.csv --samples 70000 --quiet")
          .code,
      0);
  const auto ratio = [&](const std::string& name) {
    return static_cast<double>(fs::file_size(folder_ / (name + ".h5"))) /
           static_cast<double>(fs::file_size(folder_ / (name + ".csv")));
  };
  EXPECT_LT(ratio("few"), 3);  // every column has a header and an index of some kilobytes
  EXPECT_LT(ratio("many"), 1);
}

TEST_F(LongRun, WritesHdf5BesideOtherFilesOrNone) {
  if (!HIGHERPAIR_HAS_HDF5) {
    GTEST_SKIP() << "built without HDF5";
  }
  EXPECT_EQ(run_program("analyze four_bar.toml --hdf5 t.h5 --quiet").code, 0);
  EXPECT_TRUE(fs::remove(folder_ / "t.h5"));
  EXPECT_EQ(run_program("analyze four_bar.toml --hdf5 t.h5 --csv none/t.csv").code, 1);
  EXPECT_EQ(run_program("analyze four_bar.toml --hdf5 none/t.h5 --csv t.csv").code, 1);
  EXPECT_FALSE(fs::exists(folder_ / "t.h5"));
  EXPECT_FALSE(fs::exists(folder_ / "t.csv"));
  const int full = std::system(fmt::format("cd '{}' && trap '' XFSZ; ulimit -f 100; {} analyze four_bar.toml "
                                           "--samples 90000 --hdf5 t.h5 2>err",
                                           folder_.string(), HIGHERPAIR_PROGRAM)
                                   .c_str());
  EXPECT_EQ(WEXITSTATUS(full), 1);
  EXPECT_TRUE(contains(file("err"), "cannot write t.h5: HDF5 failed at"));
  EXPECT_FALSE(fs::exists(folder_ / "t.h5"));
}

TEST_F(LongRun, RefusesHdf5WhereItCannotBe) {
  const auto refusal = [&](const std::string& options) {
    const Outcome outcome = run_program("analyze four_bar.toml " + options);
    EXPECT_EQ(outcome.code, 2) << options;
    return outcome.err;
  };
  if (!HIGHERPAIR_HAS_HDF5) {
    GTEST_SKIP() << "built without HDF5";
  }
  EXPECT_TRUE(contains(refusal("--hdf5 -"), "HDF5 needs a regular file"));
  EXPECT_TRUE(contains(refusal("--hdf5 /dev/null"), "HDF5 needs a regular file"));
  EXPECT_TRUE(contains(refusal("--hdf5 t --csv t"), "give each a file of its own"));
  EXPECT_TRUE(contains(refusal("--hdf5 four_bar.toml"), "give the output a name of its own"));
  EXPECT_TRUE(contains(refusal("--threads 0"), "--threads"));
}

// Copied without the modules beside it.
TEST_F(LongRun, RefusesHdf5WhereTheModuleIsMissing) {
  fs::copy_file(HIGHERPAIR_PROGRAM, folder_ / "alone");
  for (const char* command : {"analyze four_bar.toml --hdf5 t.h5", "sweep four_bar.toml -o t.h5"}) {
    const Outcome outcome = run_script(fmt::format("./alone {}\n", command));
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_TRUE(contains(outcome.err, "built without HDF5, or cannot load it (higherpair-hdf5.so: "))
        << command;
    EXPECT_FALSE(fs::exists(folder_ / "t.h5")) << command;
  }
  EXPECT_EQ(run_script("./alone analyze four_bar.toml --csv t.csv\n").code, 0);
}

TEST_F(LongRun, SaysThatADiskIsFull) {
  const int full =
      std::system(fmt::format("cd '{}' && trap '' XFSZ; ulimit -f 1000; {} analyze four_bar.toml "
                              "--samples 90000 --csv t.csv 2>err",
                              folder_.string(), HIGHERPAIR_PROGRAM)
                      .c_str());
  EXPECT_EQ(WEXITSTATUS(full), 1);
  EXPECT_TRUE(contains(file("err"), "cannot write t.csv: File too large"));
  EXPECT_FALSE(fs::exists(folder_ / "t.csv"));
}

// This many rows would take minutes.
TEST_F(LongRun, EndsAtOnceWhereItIsInterrupted) {
  const std::string command = "analyze four_bar.toml --samples 100000000 --csv t.csv";
  const Outcome outcome = run_interrupted(SIGINT, 0.5, command);
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err, IsEmpty());
  expect_no_output(command);
}

// The axes are too close for the teeth, so that no start exists, and the search for one takes long.
TEST_F(LongRun, EndsAtOnceWhileItLooksForAStart) {
  const Outcome outcome =
      run_interrupted(SIGINT, 2,
                      "analyze gear_teeth.toml --set bodies.pinion.curves.teeth.teeth=100 --set "
                      "bodies.wheel.curves.teeth.teeth=200 --set bodies.ground.points.O2.0=298 --set "
                      "bodies.wheel.pose.x=298 --set contacts.mesh.approach=nearest --csv t.csv");
  EXPECT_EQ(outcome.code, 130);
  EXPECT_FALSE(contains(outcome.err, "driver.start"));
}

TEST_F(LongRun, OfAMapEndsWithoutAWordWhereItsWriteIsInterrupted) {
  copy_profiles({"lock_up"});
  const UnreadPipe pipe(folder_ / "slow");
  const Outcome outcome = run_interrupted(SIGINT, 1, "map lock_up.toml --samples 20000 --csv slow");
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err, IsEmpty());
}

// Maps of conics, of curves of many parts, and a page that holds a map: each would take long.
TEST_F(LongRun, OfAMapEndsAtOnceWhereItIsInterrupted) {
  copy_profiles({"lock_up", "four_arc_cam", "gear_teeth"});
  const std::string gears =
      "gear_teeth.toml --set bodies.pinion.curves.teeth.teeth=10 --set bodies.wheel.curves.teeth.teeth=10 "
      "--set bodies.pinion.curves.teeth.profile_shift=0.5 --set bodies.wheel.curves.teeth.profile_shift=0.5 "
      "--set bodies.ground.points.O2='[22,0]' --set bodies.wheel.pose.x=22 --set bodies.wheel.pose.angle=18 "
      "--samples 7";
  for (const int signal : {SIGINT, SIGTERM}) {
    for (const std::string& command : {std::string("map lock_up.toml --samples 10000000 --csv t.csv"),
                                       std::string("map four_arc_cam.toml --samples 10000000 --json t.json"),
                                       "map " + gears + " --csv t.csv", "report " + gears + " -o t.html"}) {
      const Outcome outcome = run_interrupted(signal, 0.5, command);
      EXPECT_EQ(outcome.code, 130) << signal << " " << command;
      EXPECT_FALSE(contains(outcome.err, "error")) << command;
      expect_no_output(command);
    }
  }
}

// Many turns between two rows; draw follows the motion all the way to its position.
TEST_F(LongRun, OfAPictureEndsAtOnceWhereItIsInterrupted) {
  const std::string profile = "ellipse_cam_roller.toml --set driver.end=1e9 -o t.svg ";
  for (const int signal : {SIGINT, SIGTERM}) {
    for (const std::string command :
         {"plot --y follower.alpha --samples 2 ", "draw --at 1e9 ", "polygon --at 1e9 "}) {
      const Outcome outcome = run_interrupted(signal, 0.5, command + profile);
      EXPECT_EQ(outcome.code, 130) << signal << " " << command;
      EXPECT_THAT(outcome.err, IsEmpty()) << command;
      expect_no_output(command);
    }
  }
}

// A program that reads a pipe without a writer, or writes one without a reader, waits until it is ended.
TEST_F(LongRun, OfAnyCommandEndsWithoutAWordWhereItIsInterrupted) {
  copy_profiles({"ellipse_cam_roller"});
  ASSERT_EQ(run_script("mkfifo pipe pipe.svg").code, 0);
  for (const int signal : {SIGINT, SIGTERM}) {
    for (const std::string command :
         {"branches four_bar.toml --csv pipe",
          "mobility four_bar.toml --json pipe",
          "verify --quiet --json pipe",
          "export ellipse_cam_roller.toml --curve cam.oval --points 10000000 -o t.csv",
          "verify pipe four_bar.toml --json t.json",
          "branches pipe --csv t.csv",
          "mobility pipe --json t.json",
          "export pipe -o t.svg",
          "check pipe --csv t.csv",
          "report pipe -o t.html",
          "map pipe --csv t.csv",
          "sensitivity pipe --csv t.csv",
          "sweep pipe -o t.csv",
          "design pipe -o t.toml",
          "fit pipe four_bar.toml -o t.toml",
          "plot pipe --y driver -o t.svg",
          "draw pipe -o t.svg",
          "polygon pipe --at 0 -o t.svg",
          "analyze pipe --csv t.csv",
          "analyze four_bar.toml --csv pipe",
          "draw four_bar.toml -o pipe.svg"}) {
      const Outcome outcome = run_interrupted(signal, 0.2, command);
      EXPECT_EQ(outcome.code, 130) << signal << " " << command;
      EXPECT_THAT(outcome.err, IsEmpty()) << command;
      expect_no_output(command);
    }
  }
}

// What was found in time waits for a reader of the pipe.
TEST_F(LongRun, OfASearchEndsWithoutAWordWhereItsResultIsInterrupted) {
  copy_profiles({"design_eccentric", "sixbar_measured"});
  ASSERT_EQ(run_script("mkfifo pipe").code, 0);
  for (const std::string& command :
       {std::string("design design_eccentric.toml --starts 1 --quiet -o pipe"),
        "fit sixbar_measured.toml " + shipped_profile("sixbar_measured.csv") + " --quiet -o pipe"}) {
    const Outcome outcome = run_interrupted(SIGINT, 3, command);
    EXPECT_EQ(outcome.code, 130) << command;
    EXPECT_EQ(outcome.out + outcome.err, "") << command;
  }
}

// A motion that is lost once a turn: the stack does not grow with the number of turns.
TEST_F(LongRun, IsTakenUpAgainAThousandTimesBetweenTwoRows) {
  const Outcome outcome = run_script(
      fmt::format("ulimit -s 512\n{} analyze four_bar.toml --set bodies.coupler.points.B.0=1 --set "
                  "bodies.rocker.points.B.0=1.3 --set bodies.coupler.pose.angle=30 --set "
                  "bodies.rocker.pose.angle=30 --set "
                  "driver.end=360000 --samples 2 --events t.events --quiet --csv t.csv\n",
                  HIGHERPAIR_PROGRAM));
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  const std::string events = file("t.events");
  EXPECT_GE(std::count(events.begin(), events.end(), '\n'), 1000);
}

}  // namespace
}  // namespace higherpair::testing
