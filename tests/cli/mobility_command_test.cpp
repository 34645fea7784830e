#include "program_testing.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using higherpair::testing::contains;
using higherpair::testing::contains_all;
using higherpair::testing::Outcome;
using higherpair::testing::ProgramTest;
using higherpair::testing::read_file;
using higherpair::testing::shipped_profile;
namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Drawn in ground coordinates, with all angles 0.
const char* const kFourBar = R"(
[bodies.ground]
points.O2 = [0, 0]
points.O4 = [3, 0]
[bodies.crank]
points.O = [0, 0]
points.A = [0, 1]
[bodies.coupler]
points.A = [0, 1]
points.B = [3, 2]
[bodies.rocker]
points.B = [3, 2]
points.O = [3, 0]
[joints]
crank_pivot = { type = "revolute", between = ["ground.O2", "crank.O"] }
crank_pin = { type = "revolute", between = ["crank.A", "coupler.A"] }
rocker_pin = { type = "revolute", between = ["coupler.B", "rocker.B"] }
rocker_pivot = { type = "revolute", between = ["ground.O4", "rocker.O"] }
)";

const char* const kSliderCrank = R"(
[bodies.ground]
points.O = [0, 0]
[bodies.crank]
points.O = [0, 0]
points.A = [0, 30]
[bodies.rod]
points.A = [0, 30]
points.C = [72, 0]
[bodies.piston]
points.C = [72, 0]
[joints]
main = { type = "revolute", between = ["ground.O", "crank.O"] }
big_end = { type = "revolute", between = ["crank.A", "rod.A"] }
small_end = { type = "revolute", between = ["rod.C", "piston.C"] }
cylinder = { type = "prismatic", between = ["ground.O", "piston.C"], direction = [1, 0] }
[driver]
joint = "main"
)";

class MobilityCommand : public ProgramTest {
protected:
  [[nodiscard]] Outcome run(const std::string& profile, const std::string& options = "") const {
    std::ofstream(folder_ / "profile.toml") << profile;
    return run_program("mobility profile.toml " + options);
  }
};

// A pinion and a wheel on ground, `distance` apart.
std::string gear_pair(double distance, const std::string& keys) {
  return "[bodies.ground]\npoints.A = [0, 0]\npoints.B = [" + std::to_string(distance) +
         ", 0]\n[bodies.pinion]\npoints.A = [0, 0]\n[bodies.wheel]\npose = { x = " +
         std::to_string(distance) +
         " }\npoints.B = [0, 0]\n[joints]\na = { type = \"revolute\", between = [\"ground.A\", \"pinion.A\"] "
         "}\n"
         "b = { type = \"revolute\", between = [\"ground.B\", \"wheel.B\"] }\n[joints.mesh]\ntype = "
         "\"gears\"\n"
         "between = [\"pinion.A\", \"wheel.B\"]\n" +
         keys + "[driver]\njoint = \"a\"\n";
}

TEST_F(MobilityCommand, SaysHowTeethOfGearsMesh) {
  const Outcome good = run(gear_pair(60, "ratio = 0.5\nmodule = 2\n"), "--json -");
  const auto json = nlohmann::json::parse(good.out);
  const auto& pair = json["gears"][0];
  EXPECT_EQ(pair["joint"], "mesh");
  EXPECT_EQ(pair["teeth"], nlohmann::json({20, 40}));
  EXPECT_NEAR(pair["mesh"]["contact_ratio"].get<double>(), 1.635185964, 1e-9);
  EXPECT_NEAR(pair["mesh"]["length"].get<double>(), 2 * 4.827283884, 1e-8);
  const Outcome text = run(gear_pair(60, "ratio = 0.5\nmodule = 2\n"));
  EXPECT_THAT(
      text.out,
      AllOf(HasSubstr("Gears mesh: pinion with 20 teeth, wheel with 40 teeth; pitch radii 20 and 40 mm, "
                      "pressure angle 20 deg\n"),
            HasSubstr("contact ratio 1.635186; path of contact 9.654568 mm: "),
            Not(HasSubstr("interference")), Not(HasSubstr("undercuts"))));
}

TEST_F(MobilityCommand, SaysWhereTeethInterfere) {
  const Outcome text = run(gear_pair(26.5, "ratio = 0.325\nmodule = 1\n"));
  EXPECT_TRUE(contains_all(text.out,
                           {"interference: the tips of wheel go 0.3061573 mm past the base circle of pinion",
                            "a rack undercuts the teeth of pinion: fewer than 17.0973 are"}));
}

TEST_F(MobilityCommand, KnowsNoMeshWithoutModuleOrWholeTeeth) {
  const auto gears_of = [&](const std::string& keys) {
    return nlohmann::json::parse(run(gear_pair(60, keys), "--quiet --json -").out)["gears"];
  };
  EXPECT_TRUE(gears_of("ratio = 0.5\n").empty());
  EXPECT_TRUE(gears_of("ratio = 0.5\npressure_angle = 22\n")[0]["module"].is_null());
  EXPECT_TRUE(gears_of("ratio = 0.5\nmodule = 1.9\n")[0]["teeth"].is_null());
  const auto ring = gears_of("ratio = 0.5\nmodule = 2\ninternal = true\n")[0];
  EXPECT_EQ(ring["teeth"], nlohmann::json({60, 120}));
  EXPECT_TRUE(ring["mesh"].is_null());
}

TEST_F(MobilityCommand, PrintsCountRankPlanAndLoops) {
  const Outcome outcome = run(std::string(kFourBar) + "[driver]\njoint = \"crank_pivot\"\n");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_TRUE(contains_all(
      outcome.out, {"3 (4 - 4 - 1) + 4 = 1", "have rank 8", "1 needed, 1 given",
                    "1. crank: driven at crank_pivot", "2. coupler, rocker: dyad RRR", "Instant centres"}));
}

TEST_F(MobilityCommand, GivesTheInstantCentresOfAFourBar) {
  const Outcome outcome = run(std::string(kFourBar) + "[driver]\njoint = \"crank_pivot\"\n", "--json -");
  ASSERT_EQ(outcome.code, 0);
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  // Crank and rocker are parallel: the coupler translates, and line AB meets the ground line at x = -3.
  int found = 0;
  for (const nlohmann::json& center : json.at("instant_centers")) {
    if (center.at("bodies") == nlohmann::json({"ground", "coupler"})) {
      ++found;
      EXPECT_EQ(center.at("kind"), "at_infinity");
      EXPECT_NEAR(std::abs(center.at("y").get<double>()), 1, 1e-12);
    } else if (center.at("bodies") == nlohmann::json({"crank", "rocker"})) {
      ++found;
      EXPECT_NEAR(center.at("x").get<double>(), -3, 1e-9);
      EXPECT_NEAR(center.at("y").get<double>(), 0, 1e-9);
    }
  }
  EXPECT_EQ(found, 2);
  const nlohmann::json& loop = json.at("four_bars").at(0);
  // s + l = 1 + sqrt(10) < 2 + 3, and the crank is the shortest link.
  EXPECT_EQ(loop.at("grashof"), "crank-rocker");
  EXPECT_NEAR(loop.at("margin").get<double>(), 4 - std::sqrt(10.0), 1e-12);
  EXPECT_EQ(loop.at("limits").at("crank").size(), 0U);
  EXPECT_EQ(loop.at("limits").at("rocker").size(), 4U);
  EXPECT_EQ(json.at("rank").at("rank"), 8);
}

TEST_F(MobilityCommand, NamesTheChangePointsOfAParallelogram) {
  std::ostringstream profile;
  profile << std::ifstream(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/parallelogram.toml").rdbuf();
  const Outcome text = run(profile.str());
  EXPECT_TRUE(contains(text.out, "turns fully through change points, at 0 deg; 180 deg"));
  const auto loop = nlohmann::json::parse(run(profile.str(), "--json -").out).at("four_bars").at(0);
  EXPECT_EQ(loop.at("grashof"), "change point");
  EXPECT_EQ(loop.at("limits").at("crank").size(), 2U);
  EXPECT_EQ(loop.at("limits").at("coupler").size(), 4U);
  EXPECT_FALSE(loop.at("full_turn").at("crank").get<bool>());
}

// Coupler and right crank may fold either way at the same position of the left one.
TEST_F(MobilityCommand, NamesAChangePointOfARhombusOnce) {
  std::ostringstream profile;
  profile << std::ifstream(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/parallelogram.toml").rdbuf();
  const Outcome text = run(profile.str(),
                           "--set bodies.left.points.A.0=100 --set bodies.right.points.B.0=100 "
                           "--set bodies.coupler.pose.x=50 --set bodies.coupler.pose.y=86.6");
  EXPECT_TRUE(contains(text.out, "turns fully through change points, at 0 deg; 180 deg\n"));
}

// Coupler and rocker do not turn against each other at the start; their pin is their centre all the same.
TEST_F(MobilityCommand, ACommonPinIsAnInstantCentre) {
  const Outcome text = run_program("mobility " + shipped_profile("four_bar.toml"));
  EXPECT_TRUE(contains(text.out, "coupler, rocker: ("));
  EXPECT_FALSE(contains(text.out, "undefined"));
}

// The valve's follower starts in a dwell.
TEST_F(MobilityCommand, TheCentreOfABodyOnASlideIsAtInfinityAlsoAtRest) {
  const Outcome text = run_program("mobility " + shipped_profile("law_cam_roller.toml"));
  EXPECT_TRUE(contains(text.out, "ground, follower: at infinity along (-1, 0)\n"));
  const Outcome json = run_program("mobility " + shipped_profile("law_cam_roller.toml") + " --json -");
  const nlohmann::json centers = nlohmann::json::parse(json.out).at("instant_centers");
  for (const nlohmann::json& center : centers) EXPECT_NE(center.at("kind"), "undefined") << center;
}

// The law of the crank starts from rest, at a dead centre of the piston.
TEST_F(MobilityCommand, InstantCentresAreThoseOfTheMotionThatBeginsAtRest) {
  const Outcome text = run_program("mobility " + shipped_profile("start_stop_crank.toml"));
  EXPECT_TRUE(contains(text.out, "ground, rod: (120, 0)\n"));
  EXPECT_TRUE(contains(text.out, "ground, piston: at infinity along (0, 1)\n"));
  EXPECT_TRUE(contains(text.out, "crank, piston: (0, 0)\n"));
}

TEST_F(MobilityCommand, GivesStrokeAndHarmonicErrorOfASliderCrank) {
  const Outcome outcome = run(kSliderCrank, "--json -");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json loop = nlohmann::json::parse(outcome.out).at("slider_cranks").at(0);
  EXPECT_NEAR(loop.at("stroke").at("length").get<double>(), 60, 1e-12);
  EXPECT_NEAR(loop.at("stroke").at("time_ratio").get<double>(), 1, 1e-12);
  EXPECT_NEAR(loop.at("stroke").at("outer").at("slider").get<double>(), 108, 1e-12);
  // The coordinate of the slide, wherever that begins and whichever body carries its line.
  for (const std::string slide :
       {R"(between = ["ground.Q", "piston.C"])", R"(between = ["piston.C", "ground.Q"])"}) {
    std::string moved = kSliderCrank;
    moved.replace(moved.find("between = [\"ground.O\", \"piston.C\"]"), 34, slide);
    moved.replace(moved.find("points.O = [0, 0]"), 17, "points = { O = [0, 0], Q = [17, 0] }");
    const nlohmann::json stroke =
        nlohmann::json::parse(run(moved, "--json -").out).at("slider_cranks").at(0).at("stroke");
    const bool ahead = slide.find("ground.Q") < slide.find("piston");
    EXPECT_NEAR(stroke.at("outer").at("slider").get<double>(), ahead ? 91 : -91, 1e-12);
    EXPECT_NEAR(stroke.at("inner").at("slider").get<double>(), ahead ? 31 : -31, 1e-12);
  }
  // At 90°: l - l sqrt(1 - q²) - r q/2 with q = r/l = 30/78, in units of r.
  const double q = 30.0 / 78;
  EXPECT_NEAR(loop.at("harmonic").at("position").get<double>(), (1 - std::sqrt(1 - q * q)) / q - q / 2,
              1e-12);
}

// The table shows the lever's limits, which lie a slow and a fast stroke apart; the swing is 2 asin(4/9).
TEST_F(MobilityCommand, NamesThePartsOfAShaperAndItsTimeRatio) {
  const std::string profile = std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/quick_return.toml";
  const Outcome outcome = run(read_file(profile), "--json -");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json parts =
      nlohmann::json::parse(outcome.out).at("slider_cranks").at(0).at("quick_return");
  EXPECT_EQ(parts.at("frame"), "ground");
  EXPECT_EQ(parts.at("crank"), "crank");
  EXPECT_EQ(parts.at("lever"), "lever");
  EXPECT_TRUE(parts.at("ram").is_null());
  const double swing = 2 * std::asin(4.0 / 9);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(parts.at("swing").get<double>(), swing * 180 / pi, 1e-12);
  EXPECT_NEAR(parts.at("time_ratio").get<double>(), (pi + swing) / (pi - swing), 1e-14);
  EXPECT_THAT(
      run(read_file(profile)).out,
      AllOf(
          HasSubstr("Quick return 1: frame ground, crank crank, slotted lever lever\n"
                    "  frame 90, crank 40, offset of the slot 0 mm\n"
                    "  the lever swings by 52.7756 deg; time ratio 1.829646 of its slow stroke to the fast"),
          ::testing::Not(HasSubstr("Slider-crank"))));
}

TEST_F(MobilityCommand, ExplainsAMissingDriverAndExitsWithThree) {
  const Outcome outcome = run(std::string(kFourBar) + "[drivers]\n");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(contains(outcome.out, "3 (4 - 4 - 1) + 4 = 1"));
  EXPECT_TRUE(contains_all(outcome.err, {"1 driver needed, 0 given", "add 1 driver",
                                         "crank_pivot, crank_pin, rocker_pin, rocker_pivot"}));
}

TEST_F(MobilityCommand, NamesTheDriverThatIsTooManyAndExitsWithThree) {
  const std::string drivers = "[drivers.a]\njoint = \"crank_pivot\"\n[drivers.b]\njoint = \"rocker_pivot\"\n";
  const Outcome outcome = run(std::string(kFourBar) + drivers);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(contains(outcome.err, "remove drivers.b (of rocker_pivot)"));
  EXPECT_THAT(run(std::string(kFourBar) + drivers, "--quiet").err, IsEmpty());
}

TEST_F(MobilityCommand, CountsWhatCannotBeAssembled) {
  const Outcome outcome = run(std::string(kFourBar) + "[driver]\njoint = \"crank_pivot\"\n",
                              "--set bodies.ground.points.O4.0=300 --json -");
  EXPECT_EQ(outcome.code, 3);
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("count").at("mobility"), 1);
  EXPECT_TRUE(json.at("rank").is_null());
}

TEST_F(MobilityCommand, AsCsvHasOneRowAValue) {
  const Outcome table = run(std::string(kFourBar) + "[driver]\njoint = \"crank_pivot\"\n", "--csv -");
  EXPECT_EQ(table.code, 0);
  EXPECT_TRUE(contains_all(table.out, {"key,value\nformat,1\n", "\ncount/bodies,4\n",
                                       "\nfour_bars/0/grashof,crank-rocker\n", "\nrank/rank,8\n"}));
}

TEST_F(MobilityCommand, RefusesWrongFiles) {
  const std::string profile = std::string(kFourBar) + "[driver]\njoint = \"crank_pivot\"\n";
  EXPECT_EQ(run("[bodies.crank]\nmass = -1\n").code, 2);
  EXPECT_EQ(run(profile, "--json /dev/full").code, 1);
}

}  // namespace
