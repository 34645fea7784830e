// The command `draw` on the command line.
#include "program_testing.hpp"
#include "support/texts.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>

namespace {

using higherpair::testing::contains;
using higherpair::testing::Outcome;
using higherpair::testing::ProgramTest;
using higherpair::testing::read_file;
namespace fs = std::filesystem;
using ::testing::IsEmpty;

class Draw : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    copy_profiles({"four_bar", "lock_up", "ellipse_cam_roller"});
  }

  [[nodiscard]] Outcome run(const std::string& arguments) const { return run_program("draw " + arguments); }
};

TEST_F(Draw, WritesAPicture) {
  EXPECT_EQ(run("four_bar.toml -o 'a picture.svg' --at 30 --trace coupler.A").code, 0);
  const std::string svg = read_file(folder_ / "a picture.svg");
  EXPECT_TRUE(contains(svg, "data-scale"));
  EXPECT_TRUE(contains(svg, "data-name=\"coupler.A\""));
  const Outcome piped = run("ellipse_cam_roller.toml -o - --every 45 --strip --width 200");
  EXPECT_EQ(piped.code, 0);
  EXPECT_TRUE(contains(piped.out, "width=\"1800\""));
  EXPECT_THAT(piped.err, IsEmpty());
}

TEST_F(Draw, SaysWhereThePositionCannotBeReached) {
  const Outcome outcome = run("lock_up.toml -o l.svg --at 100");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.err, "driver = 100 cannot be reached; drawn at the limit position 65.83442"));
  EXPECT_TRUE(fs::exists(folder_ / "l.svg"));
}

TEST_F(Draw, SaysWhichOfSeveralPositionsAreLeftOut) {
  const Outcome outcome = run("lock_up.toml -o l.svg --every 60");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(
      contains(outcome.err, "positions that cannot be reached are left out: driver = 120, 180, 240\n"));
  EXPECT_TRUE(fs::exists(folder_ / "l.svg"));
}

// At 359 degrees the bodies could touch again, but no motion leads there.
TEST_F(Draw, SaysWhichLimitsLieOnTheWay) {
  for (const std::string where : {"--at 359", "--every 359"}) {
    const Outcome outcome = run("lock_up.toml -o l.svg " + where);
    EXPECT_EQ(outcome.code, 4) << where;
    EXPECT_TRUE(contains(outcome.err,
                         "the motion from the first position to what is drawn goes over\n"
                         "limit_position at driver = 65.83442"));
    EXPECT_TRUE(fs::exists(folder_ / "l.svg"));
  }
  const Outcome before = run("lock_up.toml -o l.svg --at 65");
  EXPECT_EQ(before.code, 0);
  EXPECT_THAT(before.err, IsEmpty());
}

TEST_F(Draw, RefusesPositionsAndWidthsWithoutAPlace) {
  const auto message = [&](const std::string& arguments) {
    const Outcome outcome = run("four_bar.toml -o w.svg " + arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_FALSE(fs::exists(folder_ / "w.svg")) << arguments;
    return outcome.err;
  };
  EXPECT_TRUE(contains(message("--at nan"), "--at: 'nan' is no number"));
  EXPECT_TRUE(contains(message("--at 1e20"), "driver = 1e+20: expected a position of at most 1e9 turns"));
  EXPECT_TRUE(contains(message("--at 1e300"), "expected a position of at most 1e9 turns"));
  EXPECT_TRUE(contains(message("--width 1e300"), "--width 1e300: must be a number from 50 to 10000;"));
  EXPECT_TRUE(contains(message("--strip"), "--strip requires --every"));
}

TEST_F(Draw, DrawsRowsThatAreNotToBeTrusted) {
  const Outcome outcome =
      run("ellipse_cam_roller.toml -o r.svg --quiet --set 'driver.positions=[77]' --tolerance 1e-30");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(read_file(folder_ / "r.svg"), "data-role=\"contact\""));
}

TEST_F(Draw, RefusesWhatIsWrong) {
  const auto message = [&](const std::string& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_FALSE(fs::exists(folder_ / "w.svg")) << arguments;
    return outcome.err;
  };
  EXPECT_TRUE(contains(message("four_bar.toml -o w.svg --layers joints"),
                       "--layers: there is no layer joints; did you mean `joint`?"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.svg --layers forces"),
                       "--layers: there is no layer forces; did you mean `force`?"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.svg --layers bodies"),
                       "--layers: there is no layer bodies; did you mean `body`?"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.svg --layers xyz"), "force, driver, label"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.svg --layers force"), "there are no forces to draw"));
  EXPECT_TRUE(
      contains(message("four_bar.toml -o w.svg --trace E"), "there is no point E; there are ground.O2"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.svg --at 1 --every 2"), "--at excludes --every"));
  EXPECT_TRUE(contains(message("four_bar.toml -o w.svg --width 0"), "--width"));
  EXPECT_TRUE(contains(message("four_bar.toml -o ./four_bar.toml"), "is the file that is read as FILE"));
  EXPECT_TRUE(contains(message("four_bar.toml"), "--output is required"));
  EXPECT_TRUE(contains(message("none.toml -o w.svg"), "cannot be opened"));
  const Outcome folder = run("four_bar.toml -o none/w.svg");
  EXPECT_EQ(folder.code, 1);
  EXPECT_TRUE(contains(folder.err, "there is no folder none; make it first"));
}

}  // namespace
