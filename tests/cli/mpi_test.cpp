// higherpair-sweep-mpi on 2 to 8 ranks: the same table as an ordinary sweep, whatever happens in between.
#include "cli/program_testing.hpp"
#include "support/texts.hpp"

#include <fstream>
#include <random>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#ifdef HIGHERPAIR_MPI_PROGRAM

namespace higherpair::testing {
namespace {

namespace fs = std::filesystem;

// More ranks than cores, also in containers. OpenMPI is known to leak memory under the address sanitizer.
constexpr const char* kRun =
    "ASAN_OPTIONS=detect_leaks=0 mpirun --allow-run-as-root --oversubscribe --bind-to none";

class MpiSweep : public ProgramTest {
protected:
  void SetUp() override {
    if (std::system("command -v mpirun >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "there is no mpirun (openmpi-bin)";
    }
    ProgramTest::SetUp();
    std::ofstream(folder_ / "four_bar.toml") << read_file(shipped_profile("four_bar.toml")) << R"(
[sweep]
method = "sobol"
count  = 24000
[sweep.variables]
rocker  = { path = "bodies.rocker.points.B.0", min = 3.9, max = 4.1 }
coupler = { path = "bodies.coupler.points.B.0", normal = [3.5, 0.01] }
[sweep.results]
fast = { column = "rocker.omega", of = "max", where = true }
)";
    ASSERT_EQ(run_program("sweep four_bar.toml --samples 181 --quiet -o whole.csv").code, 0);
  }

  // Ten times as many variants, so that a signal arrives while the program is working.
  static constexpr const char* kLong = " --set sweep.count=240000";
  [[nodiscard]] std::string long_table() {
    const std::string arguments = "sweep four_bar.toml --samples 181 --quiet -o long.csv";
    EXPECT_EQ(run_program(arguments + kLong).code, 0);
    return file("long.csv");
  }

  [[nodiscard]] static std::string command(int ranks, const std::string& arguments) {
    return fmt::format("{} -n {} {} four_bar.toml --samples 181 --quiet {}", kRun, ranks,
                       HIGHERPAIR_MPI_PROGRAM, arguments);
  }
};

TEST_F(MpiSweep, WritesTheTableOfOneMachine) {
  for (const int ranks : {1, 2, 3, 8}) {
    const Outcome outcome = run_script(command(ranks, "-o ranks.csv"));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(file("ranks.csv") == file("whole.csv")) << ranks << " ranks";
    EXPECT_FALSE(fs::exists(folder_ / "ranks.csv.blocks"));
  }
  const Outcome threads = run_script(command(2, "--threads 2 -o -"));
  EXPECT_TRUE(threads.out == file("whole.csv")) << threads.err;
}

// Kills the whole job at random moments, as batch systems do; each time it resumes where it was, also on a
// single process.
TEST_F(MpiSweep, GoesOnAfterItIsKilled) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> seconds(0.2, 0.9);
  int killed = 0;
  for (int i = 0; i < 10; ++i) {
    const Outcome outcome =
        run_script(fmt::format("{} & job=$!\n"
                               "sleep {:.2f}; kill -KILL $job $(pgrep -P $job) 2>&1\n"
                               "wait $job\n",
                               command(3, "-o killed.csv --resume") + kLong, seconds(random)));
    killed += outcome.code == 137 ? 1 : 0;
    if (outcome.code == 0) break;  // a fast machine has finished
  }
  EXPECT_GT(killed, 0);
  const Outcome last =
      run_program(std::string("sweep four_bar.toml --samples 181 --quiet -o killed.csv --resume") + kLong);
  EXPECT_EQ(last.code, 0) << last.err;
  EXPECT_TRUE(file("killed.csv") == long_table());
}

// One rank is stopped: the table is completed without it.
TEST_F(MpiSweep, DoesNotWaitForASlowRank) {
  const Outcome outcome = run_script(command(3, "-o slow.csv") +
                                     " & job=$!\n"
                                     "while kill -0 $job && [ ! -s slow.csv.blocks ]; do sleep 0.02; done\n"
                                     "last=$(pgrep -P $job | tail -1); kill -STOP $last\n"
                                     "for i in $(seq 200); do [ -s slow.csv ] && break; sleep 0.05; done\n"
                                     "[ -s slow.csv ] && echo there\n"
                                     "kill -CONT $last; wait $job\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "there"));
  EXPECT_TRUE(file("slow.csv") == file("whole.csv"));
}

TEST_F(MpiSweep, SaysWhatIsWrongOnce) {
  const Outcome none = run_script(command(3, "-o none/w.csv"));
  EXPECT_EQ(none.code, 1);
  EXPECT_EQ(none.err.find("there is no folder none"), none.err.rfind("there is no folder none"));
  const Outcome wrong = run_script(command(3, "-o w.csv --set sweep.results.fast.column=rocker.omeha"));
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(contains(wrong.err, "did you mean `rocker.omega`"));
  EXPECT_EQ(wrong.err.find("did you mean"), wrong.err.rfind("did you mean"));
}

TEST_F(MpiSweep, HeedsASignalAndGoesOn) {
  const Outcome outcome = run_script(command(3, "-o out.csv") + kLong +
                                     " & job=$!\n"
                                     "while kill -0 $job && [ ! -s out.csv.blocks ]; do sleep 0.02; done\n"
                                     "kill -TERM $(pgrep -P $job | head -1); wait $job\n");
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "interrupted; "));
  EXPECT_TRUE(contains(outcome.err, "--resume goes on from there"));
  EXPECT_EQ(run_script(command(2, "-o out.csv --resume") + kLong).code, 0);
  EXPECT_TRUE(file("out.csv") == long_table());
}

}  // namespace
}  // namespace higherpair::testing

#endif
