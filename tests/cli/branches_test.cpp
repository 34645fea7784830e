#include "higherpair/contact/certify.hpp"
#include "io/cam_lever_tappet.hpp"
#include "program_testing.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using higherpair::testing::contains;
using higherpair::testing::shipped_profile;

// Standard output of `branches`.
std::string output_of(const std::string& arguments) {
  const std::string command = std::string(HIGHERPAIR_PROGRAM) + " branches " + arguments;
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
    text += static_cast<char>(c);
  }
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

TEST(Branches, ListsEveryContactInTheUnitsOfTheProfile) {
  // Centre (8, 0), radius 20: the flat face, whose normal is along the slide, is at ±20 whatever the cam
  // does.
  const auto json =
      nlohmann::json::parse(output_of(shipped_profile("flat_faced_translating.toml") + " --json -"));
  EXPECT_EQ(json.at("driver"), 0.0);
  ASSERT_EQ(json.at("assemblies").size(), 1U);
  EXPECT_EQ(json.at("assemblies").at(0).at("position").size(), 2U);
  ASSERT_EQ(json.at("contacts").size(), 2U);
  const nlohmann::json& upper = json.at("contacts").at(1);
  EXPECT_EQ(upper.at("contact"), "touch");
  EXPECT_NEAR(upper.at("position").get<double>(), 20, 1e-14);
  EXPECT_NEAR(upper.at("x").get<double>(), 8, 1e-14);
  EXPECT_NEAR(upper.at("y").get<double>(), 20, 1e-14);
  EXPECT_NEAR(upper.at("normal").get<double>(), 90, 1e-13);
  EXPECT_TRUE(upper.at("opposed").get<bool>());
  EXPECT_TRUE(upper.at("free").get<bool>());
  EXPECT_FALSE(json.at("contacts").at(0).at("free").get<bool>());
}

TEST(Branches, OfADriverPositionThatIsOverriddenAreThoseThere) {
  const auto json = nlohmann::json::parse(
      output_of(shipped_profile("flat_faced_translating.toml") + " --set driver.start=90 --json -"));
  EXPECT_EQ(json.at("driver"), 90.0);
  EXPECT_NEAR(json.at("contacts").at(1).at("position").get<double>(), 28, 1e-13);
}

TEST(Branches, OfWhatCannotBeStartedAreRefused) {
  const std::string command = std::string(HIGHERPAIR_PROGRAM) + " branches " +
                              shipped_profile("lock_up.toml") + " --set driver.start=100 >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()) >> 8, 3);
}

TEST(Branches, AtADeadPointAreOneAssembly) {
  for (const auto& [start, count] : {std::pair("0", 1U), std::pair("60", 2U)}) {
    const auto json = nlohmann::json::parse(
        output_of(shipped_profile("parallelogram.toml") + " --json - --set driver.start=" + start));
    EXPECT_EQ(json.at("assemblies").size(), count);
  }
}

TEST(Branches, AreCertifiedByIntervalsInTheUnitsOfTheProfile) {
  if (!higherpair::has_exact_arithmetic()) GTEST_SKIP() << "this build has no exact arithmetic";
  // Disc of radius 30 about (10, 0) and a knife edge above the origin: at ±sqrt(30² - 10²).
  const auto json =
      nlohmann::json::parse(output_of(shipped_profile("knife_edge.toml") + " --certify --quiet --json -"));
  ASSERT_EQ(json.at("contacts").size(), 2U);
  const nlohmann::json& interval = json.at("contacts").at(1).at("certified");
  EXPECT_LE(interval.at(0).get<double>(), std::sqrt(800.0));
  EXPECT_GE(interval.at(1).get<double>(), std::sqrt(800.0));
  EXPECT_LE(interval.at(1).get<double>() - interval.at(0).get<double>(), 1e-11);
}

TEST(Branches, SayWhatIsCertified) {
  if (!higherpair::has_exact_arithmetic()) GTEST_SKIP() << "this build has no exact arithmetic";
  EXPECT_TRUE(contains(output_of(shipped_profile("disc_in_ring.toml") + " --certify"),
                       "certified: exactly these contacts exist"));
}

TEST(Branches, AreNotCertifiedByABuildWithoutExactArithmetic) {
  if (higherpair::has_exact_arithmetic()) GTEST_SKIP() << "this build has exact arithmetic";
  const std::string command = std::string(HIGHERPAIR_PROGRAM) + " branches " +
                              shipped_profile("knife_edge.toml") + " --certify 2>&1 >/dev/null; echo $?";
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
    text += static_cast<char>(c);
  }
  pclose(pipe);
  EXPECT_EQ(text,
            "higherpair: --certify: this build has no exact arithmetic; configure it with "
            "-DHIGHERPAIR_EXACT=ON, which needs CGAL, GMP and MPFR\n2\n");
}

TEST(Branches, AreTextWithUnitsWhereNoFileIsAskedFor) {
  const std::string text = output_of(shipped_profile("knife_edge.toml"));
  EXPECT_TRUE(contains(text, "slide [mm]"));
  EXPECT_TRUE(contains(text, "28.2842712475"));
}

TEST(Branches, AsCsvHaveAHeadWithUnits) {
  const std::string text = output_of(shipped_profile("knife_edge.toml") + " --csv -");
  EXPECT_THAT(text, ::testing::StartsWith(
                        "contact,position[mm],x[mm],y[mm],normal[deg],opposed,free\ntouch,-28.2842712474"));
}

TEST(Branches, AsCsvHaveAColumnForEachUnitOfAPosition) {
  if (!higherpair::has_exact_arithmetic()) GTEST_SKIP() << "this build has no exact arithmetic";
  const std::string path =
      (std::filesystem::temp_directory_path() / ("higherpair-units-" + std::to_string(getpid()) + ".toml"))
          .string();
  std::ofstream(path) << higherpair::testing::kCamLeverTappet;
  const std::string text = output_of(path + " --certify --quiet --csv -");
  std::filesystem::remove(path);
  EXPECT_THAT(text,
              ::testing::StartsWith("contact,position[deg],position[mm],x[mm],y[mm],normal[deg],opposed,free,"
                                    "certified_low[deg],certified_low[mm],certified_high[deg],"
                                    "certified_high[mm]\nlower,"));
  const std::string upper = text.substr(text.find("\nupper,"));
  EXPECT_THAT(upper, ::testing::StartsWith("\nupper,,"));
}

TEST(Branches, OfCurvesInPartsAreProven) {
  for (const char* name : {"tangent_cam.toml", "flat_faced_translating.toml"}) {
    const auto json = nlohmann::json::parse(output_of(shipped_profile(name) + " --json -"));
    EXPECT_EQ(json.at("lists"),
              nlohmann::json::parse(R"([{"contact": "touch", "complete": true, "undecided": []}])"));
  }
  EXPECT_TRUE(contains(output_of(shipped_profile("tangent_cam.toml")),
                       "proven: there are no other contacts of opposed normals"));
}

using OpenBranches = higherpair::testing::ProgramTest;

// A square of 40 mm with one side flat on the face.
TEST_F(OpenBranches, SayWhereNothingIsProven) {
  std::ofstream(folder_ / "square.toml") << R"(
[bodies.ground]
points.O = [0, 0]
[bodies.cam]
points.O = [0, 0]
curves.flank = { type = "chain", closed = true, spans = [
  { type = "segment", from = [-20, -20], to = [20, -20] }, { type = "segment", from = [20, -20], to = [20, 20] },
  { type = "segment", from = [20, 20], to = [-20, 20] }, { type = "segment", from = [-20, 20], to = [-20, -20] }] }
[bodies.tappet]
pose = { x = 0, y = 20 }
points.P = [0, 0]
curves.face = { type = "line", point = [0, 0], normal = [0, -1] }
[joints]
O     = { type = "revolute", between = ["ground.O", "cam.O"] }
guide = { type = "prismatic", between = ["ground.O", "tappet.P"], direction = [0, 1] }
[contacts.touch]
between = ["cam.flank", "tappet.face"]
[driver]
joint = "O"
)";
  const auto outcome = run_program("branches square.toml --json -");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(
      outcome.err,
      "square.toml: contacts.touch: not proven to be all: at 20 mm contacts merge or the curves lie on each "
      "other, to within rounding\n");
  const auto list = nlohmann::json::parse(outcome.out).at("lists").at(0);
  EXPECT_FALSE(list.at("complete").get<bool>());
  ASSERT_EQ(list.at("undecided").size(), 1U);
  EXPECT_NEAR(list.at("undecided").at(0).at(0).get<double>(), 20, 1e-9);
}

// Willis' equation is linear: no other assembly can exist.
TEST(Branches, OfAGearTrainAreComplete) {
  const std::string text = output_of(shipped_profile("planetary_gear.toml"));
  EXPECT_TRUE(contains(text, "assemblies: 1\n"));
}

}  // namespace
