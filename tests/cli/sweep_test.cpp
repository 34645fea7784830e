// The command `sweep` on the command line: its table, and that nothing is lost however it ends.
#include "cli/program_testing.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace higherpair::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class SweepProgram : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("plain.toml", read_file(shipped_profile("four_bar.toml")));
    write("four_bar.toml", file("plain.toml") + R"(
[sweep]
method = "sobol"
count  = 3000
[sweep.variables]
coupler = { path = ["bodies.coupler.points.B.0"], normal = [3.5, 0.01] }
rocker  = { path = "bodies.rocker.points.B.0", min = 3.9, max = 4.1 }
[sweep.results]
fast = { column = "rocker.omega", of = "max", where = true }
peak = { column = "rocker.alpha", of = "maxabs" }
)");
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  [[nodiscard]] Outcome run(const std::string& arguments) const { return run_program("sweep " + arguments); }
};

TEST_F(SweepProgram, WritesATableAndASummary) {
  const Outcome outcome = run("four_bar.toml -o out.csv --set sweep.count=200");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  const std::string csv = file("out.csv");
  EXPECT_THAT(
      csv,
      StartsWith("variant[1],coupler[cm],rocker[cm],fast[deg/s],fast.where[deg],peak[deg/s^2],status,cause\n"
                 "0,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 201);
  EXPECT_TRUE(contains(outcome.out, "200 variants: 200 ok\n"));
  EXPECT_TRUE(contains(outcome.out, "fast [deg/s]\n"));
  EXPECT_TRUE(contains(outcome.out, "50 %"));
  EXPECT_TRUE(contains(outcome.out, "####"));
  EXPECT_FALSE(fs::exists(folder_ / "out.csv.blocks"));
  const Outcome quiet = run("four_bar.toml -o quiet.csv --quiet --set sweep.count=200");
  EXPECT_EQ(quiet.out, "");
  EXPECT_EQ(file("quiet.csv"), csv);
  EXPECT_EQ(run("four_bar.toml --set sweep.count=200").out, csv);
}

TEST_F(SweepProgram, WritesTheSameBytesOnAnyNumberOfThreads) {
  for (const std::string name : {"one", "two", "five"}) {
    const std::string threads = name == "one" ? "1" : name == "two" ? "2" : "5";
    EXPECT_EQ(
        run(fmt::format("four_bar.toml -o {}.csv --quiet --samples 37 --threads {}", name, threads)).code, 0);
    EXPECT_EQ(file(name + ".csv"), file("one.csv"));
  }
}

TEST_F(SweepProgram, OfItsPartsMakesTheWhole) {
  EXPECT_EQ(run("four_bar.toml -o whole.csv --quiet --samples 37").code, 0);
  const Outcome parts =
      run_script(fmt::format("for k in 1 2 3; do {} sweep four_bar.toml -o part$k.csv --quiet --samples 37 "
                             "--part $k/3 || exit 9; done\n"
                             "cat part1.csv; tail -q -n +2 part2.csv part3.csv\n",
                             HIGHERPAIR_PROGRAM));
  EXPECT_EQ(parts.code, 0) << parts.err;
  EXPECT_EQ(parts.out, file("whole.csv"));
}

// Killed twenty times at random moments and resumed: the table is the same as without interruption.
TEST_F(SweepProgram, GoesOnAfterItIsKilled) {
  const std::string options = "four_bar.toml --quiet --samples 181 --set sweep.count=24000";
  EXPECT_EQ(run(options + " -o whole.csv").code, 0);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> seconds(0.01, 0.12);
  int killed = 0;
  for (int i = 0; i < 20; ++i) {
    const Outcome outcome =
        run_script(fmt::format("{0} sweep {1} -o killed.csv --resume & program=$!\n"
                               "sleep {2:.3f}; kill -KILL $program 2>&1; wait $program\n",
                               HIGHERPAIR_PROGRAM, options, seconds(random)));
    killed += outcome.code == 137 ? 1 : 0;
    if (outcome.code == 0) break;  // a fast machine has finished
  }
  EXPECT_GT(killed, 0);
  const Outcome last = run(options + " -o killed.csv --resume");
  EXPECT_EQ(last.code, 0) << last.err;
  EXPECT_EQ(file("killed.csv"), file("whole.csv"));
  EXPECT_FALSE(fs::exists(folder_ / "killed.csv.blocks"));
}

class InterruptedSweep : public SweepProgram {
protected:
  // The size of a journal of a few blocks: the largest file that the program may write.
  void SetUp() override {
    SweepProgram::SetUp();
    EXPECT_EQ(run("four_bar.toml -o whole.csv --quiet --samples 37").code, 0);
    full_ = run_script(fmt::format(
        "trap '' XFSZ; ulimit -f 200\n{} sweep four_bar.toml -o out.csv --samples 37", HIGHERPAIR_PROGRAM));
  }

  void expect_the_rest() const {
    const Outcome outcome = run("four_bar.toml -o out.csv --quiet --samples 37 --resume");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(file("out.csv"), file("whole.csv"));
  }

  Outcome full_;
  fs::path blocks_ = folder_ / "out.csv.blocks";
};

TEST_F(InterruptedSweep, OnAFullDiskSaysSoAndGoesOn) {
  EXPECT_EQ(full_.code, 1);
  EXPECT_TRUE(contains(full_.err, "cannot write out.csv.blocks: File too large"));
  EXPECT_TRUE(
      contains(full_.err, "of 3000 variants are kept in out.csv.blocks: --resume goes on from there"));
  EXPECT_FALSE(fs::exists(folder_ / "out.csv"));
  expect_the_rest();
}

TEST_F(InterruptedSweep, WithATornBlockLosesThatAlone) {
  fs::resize_file(blocks_, fs::file_size(blocks_) - 13);
  expect_the_rest();
}

TEST_F(InterruptedSweep, WithABlockThatHasChangedGoesOnBeforeIt) {
  std::fstream file(blocks_, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(fs::file_size(blocks_) / 2));
  file.put('?').put('!');
  file.close();
  expect_the_rest();
}

TEST_F(InterruptedSweep, IsNotBegunAnewByMistake) {
  const Outcome outcome = run("four_bar.toml -o out.csv --samples 37");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err,
                       "out.csv.blocks: this holds what an interrupted run of this sweep has done: "
                       "--resume goes on from there; remove it to begin anew"));
  expect_the_rest();
}

TEST_F(InterruptedSweep, IsNotGoneOnWithByAnother) {
  const auto refusal = [&](const std::string& options) {
    const Outcome outcome = run("four_bar.toml -o out.csv --resume " + options);
    EXPECT_EQ(outcome.code, 2) << options;
    return outcome.err;
  };
  EXPECT_TRUE(
      contains(refusal("--samples 38"), "this is of another sweep: not the same --samples; remove it"));
  EXPECT_TRUE(contains(refusal("--samples 37 --part 1/2"), "not the same --part;"));
  EXPECT_TRUE(contains(refusal("--samples 37 --set sweep.seed=2"), "not the same --set;"));
  EXPECT_TRUE(contains(refusal("--samples 37 --tolerance 1e-8"), "not the same --tolerance;"));
  const std::string text = read_file(folder_ / "four_bar.toml");
  write("four_bar.toml", text + "\n# another file\n");
  EXPECT_TRUE(contains(refusal("--samples 37"), "not the same profile;"));
  write("four_bar.toml", text);
  expect_the_rest();
}

TEST_F(InterruptedSweep, LeavesAFileAloneThatIsNone) {
  write("other.csv.blocks", "my own notes\n");
  const Outcome outcome = run("four_bar.toml -o other.csv --resume");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err, "this is no journal of a sweep"));
  EXPECT_EQ(file("other.csv.blocks"), "my own notes\n");
}

TEST_F(SweepProgram, HeedsItsSignals) {
  for (const std::string signal : {"INT", "TERM"}) {
    const Outcome outcome =
        run_script(fmt::format("{} sweep four_bar.toml -o {}.csv --set sweep.count=100000000 & program=$!\n"
                               "while kill -0 $program && [ ! -s {}.csv.blocks ]; do sleep 0.05; done; sleep "
                               "0.3; kill -{} $program; wait $program\n",
                               HIGHERPAIR_PROGRAM, signal, signal, signal));
    EXPECT_EQ(outcome.code, 130) << signal;
    EXPECT_TRUE(contains(outcome.err, "interrupted; "));
    EXPECT_TRUE(contains(outcome.err, "--resume goes on from there"));
    EXPECT_FALSE(fs::exists(folder_ / (signal + ".csv")));
  }
}

TEST_F(SweepProgram, SaysThatADeviceIsFull) {
  const Outcome outcome = run("four_bar.toml -o /dev/full --set sweep.count=9 --samples 5");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(contains(outcome.err, "cannot write /dev/full: No space left on device"));
}

TEST_F(SweepProgram, SaysBeforeTheStartWhatShareCannotBeRead) {
  const Outcome outcome =
      run("four_bar.toml -o out.csv --samples 5 --set sweep.count=1000 --set 'sweep.variables.w={ path = "
          "\"driver.samples\", values = [5, 5, 5, -5] }'");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.err,
                       "of 1000 variants that were tried 250 cannot be read, about 25 % of all; they "
                       "become rows with the status not_started. The first, variant "));
  EXPECT_TRUE(contains(outcome.err, "driver.samples = -5"));
  EXPECT_TRUE(
      contains(outcome.out, "1000 variants: 750 ok 250 not_started\n250 variants: the path is not good"));
  const std::string csv = file("out.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1001);
}

TEST_F(SweepProgram, RefusesWhatIsWrong) {
  const auto message = [&](const std::string& arguments, int code = 2) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments;
    EXPECT_FALSE(fs::exists(folder_ / "w.csv")) << arguments;
    EXPECT_FALSE(fs::exists(folder_ / "w.csv.blocks")) << arguments;
    return outcome.err;
  };
  EXPECT_TRUE(contains(message("plain.toml -o w.csv"), "there is no [sweep]"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.txt"), "expected a name that ends in .csv, .h5 or .hdf5"));
  EXPECT_TRUE(contains(message("four_bar.toml -o none/w.csv", 1), "there is no folder none; make it first"));
  EXPECT_TRUE(contains(message("four_bar.toml -o . ", 1), "is a folder"));
  EXPECT_TRUE(contains(message("four_bar.toml -o ./four_bar.toml"), "is the file that is read as FILE"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.csv --part 3/2"), "'3/2' is no part; expected K/N"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.csv --part half"), "'half' is no part"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.csv --threads 0"), "--threads"));
  EXPECT_TRUE(contains(message("four_bar.toml -o - --resume"), "needs a regular file as --output"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.csv --set sweep.results.peak.column=rocker.alfa"),
                       "there is no such column; did you mean `rocker.alpha`"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.csv --set sweep.count=1000000000000"),
                       "expected an integer from 1 to 100000000000"));
  EXPECT_TRUE(contains(message("none.toml -o w.csv"), "cannot be opened"));
  for (const char* round : {"round.csv", "round.h5"}) {
    fs::create_symlink(round, folder_ / round);
    const Outcome outcome = run(std::string("four_bar.toml --samples 7 -o ") + round);
    const bool possible = HIGHERPAIR_HAS_HDF5 || round == std::string("round.csv");
    EXPECT_EQ(outcome.code, possible ? 1 : 2);
    EXPECT_TRUE(contains(outcome.err, possible ? "leads round in a circle" : "built without HDF5"));
  }
  EXPECT_FALSE(fs::exists(folder_ / ".blocks"));
}

TEST_F(SweepProgram, RefusesToWriteOverAFileThatTheProfileReads) {
  fs::copy_file(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/spline_cam.csv", folder_ / "spline_cam.csv");
  write("spline.toml", read_file(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/spline_cam.toml") + R"(
[sweep]
method = "list"
variables.v = { path = "driver.velocity", values = [1, 2] }
)");
  const std::string before = file("spline_cam.csv");
  const Outcome outcome = run("spline.toml -o ./spline_cam.csv");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err,
                       "is the file that is read as part of the profile; give the output a name of its own"));
  EXPECT_EQ(file("spline_cam.csv"), before);
}

TEST_F(SweepProgram, WritesHdf5TheSameWayEveryTime) {
  if (!HIGHERPAIR_HAS_HDF5) {
    GTEST_SKIP() << "built without HDF5";
  }
  const Outcome outcome = run("four_bar.toml -o one.h5 --quiet --samples 37 --threads 1");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(run("four_bar.toml -o two.h5 --quiet --samples 37 --threads 3").code, 0);
  EXPECT_THAT(file("one.h5"), StartsWith("\x89HDF\r\n"));
  EXPECT_TRUE(file("one.h5") == file("two.h5"));
  const Outcome full = run_script(
      fmt::format("trap '' XFSZ; ulimit -f 500\n{} sweep four_bar.toml -o three.h5 --quiet --samples 37",
                  HIGHERPAIR_PROGRAM));
  EXPECT_EQ(full.code, 1);
  EXPECT_TRUE(contains(full.err, "cannot write three.h5: HDF5 failed at"));
  EXPECT_FALSE(fs::exists(folder_ / "three.h5"));
  EXPECT_EQ(run("four_bar.toml -o three.h5 --quiet --samples 37 --resume").code, 0);
  EXPECT_TRUE(file("three.h5") == file("one.h5"));
}

}  // namespace
}  // namespace higherpair::testing
