// The command `export` on the command line.
#include "program_testing.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>

namespace {

using higherpair::testing::contains;
using higherpair::testing::Outcome;
using higherpair::testing::ProgramTest;
using higherpair::testing::read_file;
using higherpair::testing::shipped_profile;
namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::StartsWith;

long lines_of(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

class ExportCommand : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    fs::copy_file(shipped_profile("law_cam_roller.toml"), folder_ / "cam.toml",
                  fs::copy_options::overwrite_existing);
  }

  [[nodiscard]] Outcome run(const std::string& arguments) const { return run_program("export " + arguments); }

  [[nodiscard]] std::string refused(const std::string& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    for (const char* name : {"w.csv", "w.dxf", "w.svg"}) {
      EXPECT_FALSE(fs::exists(folder_ / name)) << arguments;
    }
    return outcome.err;
  }
};

TEST_F(ExportCommand, WritesWhatTheEndingSays) {
  for (const char* name : {"a flank.csv", "flank.dxf", "FLANK.SVG"}) {
    const Outcome outcome = run("cam.toml --curve cam.flank -o '" + std::string(name) + "'");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, IsEmpty());
  }
  EXPECT_THAT(read_file(folder_ / "a flank.csv"),
              StartsWith("x[mm],y[mm],nx[1],ny[1],curvature[1/mm],arc[mm]\n"));
  EXPECT_TRUE(contains(read_file(folder_ / "flank.dxf"), "POLYLINE\n  8\ncam-flank\n"));
  EXPECT_TRUE(contains(read_file(folder_ / "FLANK.SVG"), "data-name=\"cam.flank\""));
  const Outcome piped = run("cam.toml --curve cam.flank -o - --points 90 --units in");
  EXPECT_EQ(piped.code, 0);
  EXPECT_THAT(piped.out, StartsWith("x[in],"));
  EXPECT_EQ(lines_of(piped.out), 91);
}

TEST_F(ExportCommand, TakesLengthsWithTheirUnits) {
  const Outcome plain = run("cam.toml --curve cam.flank --cutter 6 --tolerance 0.01 -o -");
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_EQ(run("cam.toml --curve cam.flank --cutter '6 mm' --tolerance '10 um' -o -").out, plain.out);
  EXPECT_GT(lines_of(run("cam.toml --curve cam.flank --cutter 6 --tolerance 0.0001 -o -").out),
            5 * lines_of(plain.out));
  EXPECT_EQ(run("cam.toml --curve cam.flank --pitch -o -").out,
            run("cam.toml --curve cam.flank --cutter 10 -o -").out);
}

TEST_F(ExportCommand, WritesSeveralCurvesOnLayers) {
  const Outcome outcome = run("cam.toml --curve cam.flank --body follower -o all.dxf");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string dxf = read_file(folder_ / "all.dxf");
  EXPECT_TRUE(contains(dxf, "POLYLINE\n  8\ncam-flank\n"));
  EXPECT_TRUE(contains(dxf, "CIRCLE\n  8\nfollower-roller\n"));
}

TEST_F(ExportCommand, RefusesWhatIsWrong) {
  const std::string flank = "cam.toml --curve cam.flank ";
  EXPECT_TRUE(contains(refused(flank), "--output is required"));
  EXPECT_TRUE(contains(refused(flank + "-o w.step"),
                       "w.step: a curve goes to a file that ends in .csv, .dxf or .svg"));
  EXPECT_TRUE(contains(refused("cam.toml -o cam.toml"), "is the file that is read as FILE"));
  EXPECT_TRUE(contains(refused(flank + "-o w.dxf --points 9"), "--points: is for .csv; arcs are as many as"));
  EXPECT_TRUE(contains(refused(flank + "-o w.csv --points 1"), "--points"));
  EXPECT_TRUE(
      contains(refused(flank + "-o w.csv --body follower"), "a .csv holds one curve; name it with --curve"));
  EXPECT_TRUE(contains(refused(flank + "--curve follower.roller -o w.csv"), "a .csv holds one curve"));
  EXPECT_TRUE(contains(refused(flank + "-o w.dxf --pitch --cutter 3"), "excludes"));
  EXPECT_TRUE(contains(refused(flank + "-o w.dxf --cutter -3"), "--cutter: `-3`: expected a length above 0"));
  EXPECT_TRUE(
      contains(refused(flank + "-o w.dxf --cutter nan"), "--cutter: `nan`: expected a length above 0"));
  EXPECT_TRUE(contains(refused(flank + "-o w.dxf --cutter '3 kg'"), "--cutter: `3 kg`: kg is a mass"));
  EXPECT_TRUE(contains(refused(flank + "-o w.dxf --tolerance small"), "--tolerance: `small`: "));
  EXPECT_TRUE(contains(refused(flank + "-o w.dxf --reach 0"), "--reach: `0`: expected a length above 0"));
  EXPECT_THAT(refused(flank + "-o w.dxf --units kg"),
              ::testing::EndsWith("--units: `kg`: expected a unit of length: m, cm, mm, um, km, in, ft\n"));
  EXPECT_TRUE(contains(refused(flank + "-o w.dxf --units millimetre"),
                       "expected a unit of length: m, cm, mm, um, km, in, ft; did you mean `mm`?"));
  EXPECT_TRUE(
      contains(refused(flank + "-o w.dxf --tolerance 1e-12"), "is finer than cam.flank can be drawn"));
  EXPECT_TRUE(contains(refused("cam.toml --curve cam.flnk -o w.dxf"),
                       "there is no curve cam.flnk; did you mean `cam.flank`?"));
  EXPECT_TRUE(contains(refused("cam.toml -o w.dxf"), "name the curve to export: cam.flank, follower.roller"));
  EXPECT_TRUE(contains(refused("nothing.toml -o w.dxf"), "nothing.toml"));
  EXPECT_TRUE(contains(refused(flank + "-o w.dxf --curves a"), "did you mean `--curve`?"));
}

TEST_F(ExportCommand, RefusesTheCutterOfItsPageAsThatSays) {
  const std::string page = read_file(HIGHERPAIR_SOURCE_DIR "/docs/export.md");
  const std::string profile = "profiles/groove_cam.toml";
  const std::size_t begin = page.find(profile + ": a cutter") + profile.size();
  const std::string message = page.substr(begin, page.find('\n', begin) - begin);
  const Outcome outcome = run(shipped_profile("groove_cam.toml") + " --curve cam.inner --cutter 35 -o w.dxf");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(contains(outcome.err, message));
}

}  // namespace
