// Designs that are killed, are interrupted or run out of disk space, and are resumed.
#include "cli/program_testing.hpp"
#include "support/texts.hpp"

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace higherpair::testing {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTask = "design_eighteen_points.toml --starts 48 --best 3 --quiet";

class ResumedDesign : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    copy_profiles({"design_eighteen_points"});
    ASSERT_EQ(run(std::string(kTask) + files("whole")).code, 0);
  }

  [[nodiscard]] Outcome run(const std::string& arguments) const { return run_program("design " + arguments); }

  /// Options for all files that a design writes.
  static std::string files(const std::string& name) {
    return fmt::format(" -o {0}.toml --json {0}.json --report {0}.html", name);
  }

  void expect_the_whole(const std::string& name) const {
    for (const std::string ending : {".toml", ".2.toml", ".3.toml", ".json", ".html"}) {
      EXPECT_TRUE(file(name + ending) == file("whole" + ending)) << ending;
    }
    EXPECT_FALSE(fs::exists(folder_ / (name + ".toml.searches")));
  }

  /// Ends the program by a signal when some searches are complete.
  [[nodiscard]] Outcome run_until(const std::string& signal, const std::string& name) const {
    return run_script(
        fmt::format("{0} design {1} -o {2}.toml & program=$!\n"
                    "while kill -0 $program && [ $(stat -c %s {2}.toml.searches || echo 0) -lt 2000 ]; "
                    "do sleep 0.01; done 2>/dev/null\n"
                    "kill -{3} $program; wait $program\n",
                    HIGHERPAIR_PROGRAM, kTask, name, signal));
  }
};

// Killed ten times at random moments, with any number of threads.
TEST_F(ResumedDesign, GoesOnAfterItIsKilled) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> seconds(0.02, 0.15);
  int killed = 0;
  for (int i = 0; i < 10; ++i) {
    const Outcome outcome =
        run_script(fmt::format("{0} design {1}{2} --resume --threads {3} & program=$!\n"
                               "sleep {4:.3f}; kill -KILL $program 2>&1; wait $program\n",
                               HIGHERPAIR_PROGRAM, kTask, files("killed"), 1 + i % 3, seconds(random)));
    killed += outcome.code == 137 ? 1 : 0;
    if (outcome.code == 0) break;  // a fast machine has finished
  }
  EXPECT_GT(killed, 0);
  const Outcome last = run(kTask + files("killed") + " --resume");
  EXPECT_EQ(last.code, 0) << last.err;
  expect_the_whole("killed");
}

TEST_F(ResumedDesign, DoesNotMakeASearchTwice) {
  EXPECT_EQ(run_until("KILL", "killed").code, 137);
  // No time is left: the result is what was found before.
  EXPECT_EQ(
      run_script(fmt::format("cp killed.toml.searches kept; {} design {} -o killed.toml --json killed.json "
                             "--resume --time 1e-9",
                             HIGHERPAIR_PROGRAM, kTask))
          .code,
      0);
  const auto found = nlohmann::json::parse(file("killed.json")).at("search");
  EXPECT_EQ(found.at("end"), "time");
  EXPECT_GE(found.at("starts").get<int>(), 10);
  fs::copy_file(folder_ / "kept", folder_ / "killed.toml.searches");
  EXPECT_EQ(run(kTask + files("killed") + " --resume").code, 0);
  expect_the_whole("killed");
}

TEST_F(ResumedDesign, InterruptedWritesTheBestSoFarAndGoesOn) {
  for (const std::string signal : {"INT", "TERM"}) {
    const Outcome outcome = run_until(signal, signal);
    EXPECT_EQ(outcome.code, 130) << signal;
    EXPECT_TRUE(
        contains(outcome.err,
                 fmt::format("searches are kept in {}.toml.searches: --resume goes on from there", signal)));
    EXPECT_EQ(run_program(fmt::format("analyze {}.toml --csv -", signal)).code, 0);
    EXPECT_EQ(run(kTask + files(signal) + " --resume").code, 0);
    expect_the_whole(signal);
  }
}

TEST_F(ResumedDesign, OnAFullDiskSearchesOnAndSaysWhatIsNotKept) {
  const Outcome full = run_script(
      fmt::format("trap '' XFSZ; ulimit -f 1\n{} design {} -o full.toml", HIGHERPAIR_PROGRAM, kTask));
  EXPECT_EQ(full.code, 1);
  EXPECT_TRUE(contains(full.err, "full.toml.searches: File too large"));
  EXPECT_TRUE(contains(full.err, "searches are kept in full.toml.searches: --resume goes on from there"));
  EXPECT_FALSE(fs::exists(folder_ / "full.toml"));
  EXPECT_EQ(run(kTask + files("full") + " --resume").code, 0);
  expect_the_whole("full");
}

class InterruptedDesign : public ResumedDesign {
protected:
  void SetUp() override {
    ResumedDesign::SetUp();
    ASSERT_EQ(run_until("KILL", "out").code, 137);
  }

  void expect_the_rest() const {
    const Outcome outcome = run(kTask + files("out") + " --resume");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    expect_the_whole("out");
  }

  fs::path searches_ = folder_ / "out.toml.searches";
};

TEST_F(InterruptedDesign, WithATornSearchLosesThatAlone) {
  fs::resize_file(searches_, fs::file_size(searches_) - 13);
  expect_the_rest();
}

TEST_F(InterruptedDesign, WithASearchThatHasChangedGoesOnBeforeIt) {
  std::fstream change(searches_, std::ios::in | std::ios::out | std::ios::binary);
  change.seekp(static_cast<std::streamoff>(fs::file_size(searches_) / 2));
  change.put('?').put('!');
  change.close();
  expect_the_rest();
}

TEST_F(InterruptedDesign, IsNotBegunAnewByMistake) {
  const Outcome outcome = run(std::string(kTask) + " -o out.toml");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err,
                       "out.toml.searches: this holds what an interrupted run of this search has "
                       "done: --resume goes on from there; remove it to begin anew"));
  expect_the_rest();
}

TEST_F(InterruptedDesign, IsNotGoneOnWithByAnother) {
  const auto refusal = [&](const std::string& options) {
    const Outcome outcome = run(kTask + (" -o out.toml --resume " + options));
    EXPECT_EQ(outcome.code, 2) << options;
    EXPECT_FALSE(fs::exists(folder_ / "out.toml"));
    return outcome.err;
  };
  EXPECT_TRUE(contains(refusal("--seed 2"),
                       "out.toml.searches: this is of another search: not the same --seed; "
                       "remove it to begin anew, or give the output another name"));
  const std::string text = file("design_eighteen_points.toml");
  std::ofstream(folder_ / "design_eighteen_points.toml") << text << "\n# another task\n";
  EXPECT_TRUE(contains(refusal(""), "not the same profile;"));
  std::ofstream(folder_ / "design_eighteen_points.toml") << text;
  expect_the_rest();
}

// The total number of searches has no influence on any of them.
TEST_F(InterruptedDesign, GoesOnToMoreSearches) {
  const std::string more = "design_eighteen_points.toml --starts 64 --best 3 --quiet";
  EXPECT_EQ(run(more + files("out") + " --resume").code, 0);
  EXPECT_EQ(run(more + files("whole")).code, 0);
  expect_the_whole("out");
}

TEST_F(InterruptedDesign, LeavesAFileAloneThatIsNoJournal) {
  std::ofstream(folder_ / "other.toml.searches") << "my own notes\n";
  const Outcome outcome = run(std::string(kTask) + " -o other.toml --resume");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(
      contains(outcome.err, "this is no journal of a search; move it away, or give the output another name"));
  EXPECT_EQ(file("other.toml.searches"), "my own notes\n");
}

TEST_F(ResumedDesign, LeavesNothingWhereItDoesNotBegin) {
  copy_profiles({"four_bar"});
  EXPECT_EQ(run("four_bar.toml -o none.toml").code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "none.toml.searches"));
  const Outcome direct = run("design_eighteen_points.toml -o - --resume");
  EXPECT_EQ(direct.code, 2);
  EXPECT_TRUE(contains(direct.err, "--resume: needs a regular file as --output"));
  const Outcome folder = run(std::string(kTask) + " -o none/b.toml");
  EXPECT_EQ(folder.code, 1);
  EXPECT_TRUE(contains(folder.err, "none/b.toml: there is no folder none; make it first"));
}

// A journal without a completed search is useless.
TEST_F(ResumedDesign, BeginsAnewWhereNothingWasDone) {
  EXPECT_EQ(run_until("KILL", "out").code, 137);
  const std::string journal = file("out.toml.searches");
  std::ofstream(folder_ / "out.toml.searches", std::ios::binary)
      << journal.substr(0, journal.find("\n\n") + 2 + 10);
  const Outcome outcome = run(kTask + files("out"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  expect_the_whole("out");
}

TEST_F(ResumedDesign, RefusesToWriteOverAFileThatTheProfileReads) {
  copy_profiles({"design_film_hook"});
  fs::copy_file(shipped_profile("design_film_hook.csv"), folder_ / "design_film_hook.csv");
  const std::string points = file("design_film_hook.csv");
  const Outcome outcome = run("design_film_hook.toml -o b.toml --json ./design_film_hook.csv --starts 1");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err,
                       "--json: ./design_film_hook.csv is the file that is read as part of the profile"));
  EXPECT_EQ(file("design_film_hook.csv"), points);
}

}  // namespace
}  // namespace higherpair::testing
