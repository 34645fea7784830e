// The commands that draw plots, polygons and maps, on the command line.
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
namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class PictureFiles : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    copy_profiles({"sixbar_slider", "lock_up", "ellipse_cam_roller", "four_bar"});
  }

  [[nodiscard]] Outcome run(const std::string& arguments) const { return run_program(arguments); }

  // The message about wrong arguments; nothing may be written.
  [[nodiscard]] std::string refusal(const std::string& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_FALSE(fs::exists(folder_ / "w.svg")) << arguments;
    EXPECT_THAT(outcome.out, IsEmpty());
    return outcome.err;
  }
};

TEST_F(PictureFiles, OfColumnsAreWrittenAndNothingIsSaid) {
  const Outcome outcome =
      run("plot ellipse_cam_roller.toml -o 'a plot.svg' --y follower.alpha,touch.pressure");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out + outcome.err, IsEmpty());
  EXPECT_TRUE(contains(file("a plot.svg"), "data-name=\"touch.pressure\""));
  const Outcome piped = run("plot ellipse_cam_roller.toml -o - --y follower.alpha --width 500");
  EXPECT_THAT(piped.out, StartsWith("<?xml"));
  EXPECT_TRUE(contains(piped.out, "width=\"500\""));
}

TEST_F(PictureFiles, OfARunThatIsNotGoodAreWrittenAllTheSame) {
  EXPECT_EQ(run("plot lock_up.toml -o p.svg --y follower.angle").code, 4);
  EXPECT_TRUE(contains(file("p.svg"), "not assemblable"));
}

TEST_F(PictureFiles, OfTimeAndOfOtherColumns) {
  EXPECT_EQ(run("plot sixbar_slider.toml -o t.svg --y slider.vx --time").code, 0);
  EXPECT_TRUE(contains(file("t.svg"), "time [s]"));
  EXPECT_EQ(run("plot four_bar.toml -o c.svg --y driver.velocity --x driver --samples 5").code, 0);
  EXPECT_EQ(run("plot ellipse_cam_roller.toml -o e.svg --y driver.effort").code, 0);
  EXPECT_TRUE(contains(file("e.svg"), "driver.effort"));
}

TEST_F(PictureFiles, RefuseUnknownColumns) {
  EXPECT_TRUE(
      contains(refusal("plot ellipse_cam_roller.toml -o w.svg --y follower.alfa"),
               "--y follower.alfa: no column of this run has such a name; did you mean `follower.alpha"));
  EXPECT_TRUE(contains(refusal("plot ellipse_cam_roller.toml -o w.svg --y driver --x drvier"),
                       "--x drvier: no column"));
  EXPECT_TRUE(contains(refusal("plot ellipse_cam_roller.toml -o w.svg --y status"), "holds words"));
  EXPECT_TRUE(contains(refusal("plot ellipse_cam_roller.toml -o w.svg"), "--y is required"));
  EXPECT_TRUE(contains(refusal("plot ellipse_cam_roller.toml --y driver"), "--output is required"));
}

TEST_F(PictureFiles, RefuseFilesThatCannotBe) {
  for (const std::string command : {"plot ellipse_cam_roller.toml --y driver", "map ellipse_cam_roller.toml",
                                    "polygon ellipse_cam_roller.toml --at 30"}) {
    EXPECT_TRUE(contains(refusal(command + " -o w.gif"), "w.gif: a picture ends in .svg, .pdf or .png"));
    EXPECT_TRUE(contains(refusal(command + " -o w"), "a picture ends in"));
  }
  fs::copy_file(folder_ / "four_bar.toml", folder_ / "profile.svg");
  EXPECT_TRUE(
      contains(refusal("plot profile.svg -o ./profile.svg --y driver"), "is the file that is read as FILE"));
  EXPECT_TRUE(contains(refusal("map ellipse_cam_roller.toml --csv w.svg -o w.svg"), "both name w.svg"));
  EXPECT_TRUE(contains(file("profile.svg"), "[driver]"));
}

// Without librsvg and cairo the program reports that it cannot write them.
TEST_F(PictureFiles, ArePdfAndPngWhereThatCanBe) {
  const Outcome pdf = run("polygon sixbar_slider.toml -o p.pdf --at 45");
  if (!HIGHERPAIR_HAS_PICTURES) {
    EXPECT_EQ(pdf.code, 2);
    EXPECT_TRUE(contains(pdf.err, "install librsvg2-dev and libcairo2-dev and build again"));
    return;
  }
  EXPECT_EQ(pdf.code, 0) << pdf.err;
  EXPECT_THAT(file("p.pdf"), StartsWith("%PDF"));
  EXPECT_EQ(run("map ellipse_cam_roller.toml -o m.PNG").code, 0);
  EXPECT_THAT(file("m.PNG"), StartsWith("\x89PNG"));
}

// Copied without the modules beside it.
TEST_F(PictureFiles, AreSvgOnlyWhereTheModuleIsMissing) {
  fs::copy_file(HIGHERPAIR_PROGRAM, folder_ / "alone");
  const Outcome pdf = run_script("./alone draw four_bar.toml -o p.pdf\n");
  EXPECT_EQ(pdf.code, 2);
  EXPECT_TRUE(contains(pdf.err,
                       "p.pdf: this higherpair was built without librsvg and cairo, which .pdf needs, or "
                       "cannot load them (higherpair-pictures.so: "));
  EXPECT_FALSE(fs::exists(folder_ / "p.pdf"));
  EXPECT_EQ(run_script("./alone draw four_bar.toml -o p.svg\n").code, 0);
}

TEST_F(PictureFiles, OfPolygonsHaveVelocitiesAccelerationsAndForces) {
  const Outcome outcome = run("polygon sixbar_slider.toml -o p.svg --at 45 --forces");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out + outcome.err, IsEmpty());
  EXPECT_TRUE(contains(file("p.svg"), "Six-bar with slider, driver = 45 deg"));
  EXPECT_TRUE(contains(file("p.svg"), "data-label=\"a_BA^n\""));
}

TEST_F(PictureFiles, OfPolygonsAreOfTheLimitWhereThePositionCannotBeReached) {
  const Outcome outcome = run("polygon lock_up.toml -o p.svg --at 120");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.err,
                       "lock_up.toml: driver = 120 cannot be reached: drawn at the limit position 65.83442"));
  EXPECT_TRUE(fs::exists(folder_ / "p.svg"));
}

TEST_F(PictureFiles, OfPolygonsSayWhichLimitsLieOnTheWay) {
  const Outcome outcome = run("polygon lock_up.toml -o p.svg --at 359");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_TRUE(contains(outcome.err, "limit_position at driver = 65.83442"));
  EXPECT_TRUE(fs::exists(folder_ / "p.svg"));
}

TEST_F(PictureFiles, OfPolygonsNeedAPosition) {
  EXPECT_TRUE(contains(refusal("polygon sixbar_slider.toml -o w.svg"), "--at is required"));
  EXPECT_TRUE(contains(refusal("polygon sixbar_slider.toml -o w.svg --at nan"), "'nan' is no number"));
}

TEST_F(PictureFiles, OfAMapComeBesidesItsTables) {
  const Outcome outcome = run("map ellipse_cam_roller.toml -o m.svg");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, run("map ellipse_cam_roller.toml").out);
  EXPECT_TRUE(contains(file("m.svg"), "branch 3, the mechanism's own"));
  EXPECT_EQ(run("map ellipse_cam_roller.toml -o m2.svg --csv m.csv").code, 0);
  EXPECT_EQ(file("m2.svg"), file("m.svg"));
}

}  // namespace
