// Mechanisms of textbooks with their recomputed numbers, from a profile's text to the table.
#include "analysis/run_testing.hpp"
#include "linkage/linkage_testing.hpp"

#include <fmt/core.h>

namespace higherpair {
namespace {

using namespace higherpair::testing;
using nlohmann::json;

// The reference has 18 digits, angles are printed in degrees, and the condition numbers of the loops are at
// most 20: 1e-12 relative.
constexpr double kTolerance = 1e-12;

std::string pose(const std::string& body, Complex p, double angle) {
  return fmt::format("bodies.{}.pose={{x = {:.3g}, y = {:.3g}, angle = {:.3g}}}", body, p.real(), p.imag(),
                     angle / kDegree);
}

Settings driver(double position, double velocity, double acceleration, const std::string& unit) {
  return {fmt::format("driver.positions=[\"{} {}\"]", position, unit),
          fmt::format("driver.velocity=\"{} {}/s\"", velocity, unit),
          fmt::format("driver.acceleration=\"{} {}/s^2\"", acceleration, unit)};
}

Settings operator+(Settings a, const Settings& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

double angle_error_at(const RunTable& motion, std::size_t row, const std::string& column,
                      const json& expected) {
  return angle_error(motion.radians(row, column), number(expected));
}

double rate_error(const RunTable& motion, std::size_t row, const std::string& column, const json& expected) {
  return relative_error(motion.radians(row, column), number(expected));
}

// A dial: a body on a pin that only a driver turns. A cross slide transfers its angle to the body `to`
// without constraining that body's position, so that a driver can set the angle of any body.
std::string dial(const std::string& to, double angle) {
  return fmt::format(R"(
[bodies.dial]
pose     = {{ x = 0, y = 0, angle = {0} }}
points.O = [0, 0]
[bodies.cross]
pose     = {{ x = 0, y = 0, angle = {0} }}
points.O = [0, 0]
[joints.dial_pivot]
type    = "revolute"
between = ["ground.O2", "dial.O"]
[joints.dial_slide]
type      = "prismatic"
between   = ["dial.O", "cross.O"]
direction = [1, 0]
angle     = 0
[joints.cross_slide]
type      = "prismatic"
between   = ["cross.O", "{1}.A"]
direction = [0, 1]
angle     = 0
)",
                     angle, to);
}

std::string text_of(const std::string& name) {
  std::ifstream file(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + name + ".toml");
  return {std::istreambuf_iterator<char>(file), {}};
}

Settings four_bar_poses(double theta2, double theta3, double theta4) {
  return {pose("crank", 0, theta2), pose("coupler", 2.0 * direction(theta2), theta3),
          pose("rocker", 1, theta4)};
}

// At 90 deg the printed table has 87 for A = 8, and -143.85 deg for theta3 = -148.85 deg; the correct values
// are computed from the loop.
TEST(TextbookFourBar, HasThePositionsVelocitiesAndAccelerationsOfTheChapterInBothAssemblies) {
  const json table = textbook("fourbar_000_table");
  const json rates = textbook("fourbar_000_velocity_acceleration");
  ASSERT_EQ(rates.size(), 2 * table.size());
  Worst angles, velocities, accelerations;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const json& place = table[i / 2];
    const json& row = rates[i];
    const double theta2 = number(row["theta2"]);
    const Profile profile = shipped(
        "four_bar", driver(theta2, number(row["omega2"]), number(row["alpha2"]), "rad") +
                        four_bar_poses(theta2, number(place["theta3_rad"]), number(place["theta4_rad"])));
    const RunTable motion = analyze(profile);
    ASSERT_EQ(motion.count(RowStatus::kOk), 1U) << motion.failure();
    angles.see(angle_error_at(motion, 0, "coupler.angle", place["theta3_rad"]));
    angles.see(angle_error_at(motion, 0, "rocker.angle", place["theta4_rad"]));
    velocities.see(rate_error(motion, 0, "coupler.omega", row["omega3"]));
    velocities.see(rate_error(motion, 0, "rocker.omega", row["omega4"]));
    accelerations.see(rate_error(motion, 0, "coupler.alpha", row["alpha3"]));
    accelerations.see(rate_error(motion, 0, "rocker.alpha", row["alpha4"]));
  }
  EXPECT_AT_MOST(angles.value(), kTolerance);
  EXPECT_AT_MOST(velocities.value(), kTolerance);
  EXPECT_AT_MOST(accelerations.value(), kTolerance);
}

TEST(TextbookFourBar, PassesThroughTheChaptersPositionsInATurn) {
  const json table = textbook("fourbar_000_table");
  const RunTable motion = analyze(shipped("four_bar"));
  expect_all_ok(motion);
  for (const json& row : table) {
    if (row["sigma"] != 1) continue;
    const auto degrees = static_cast<std::size_t>(std::lround(number(row["theta2"]) / kDegree) + 360) % 360;
    EXPECT_AT_MOST(angle_error_at(motion, degrees, "coupler.angle", row["theta3_rad"]), kTolerance);
    EXPECT_AT_MOST(angle_error_at(motion, degrees, "rocker.angle", row["theta4_rad"]), kTolerance);
  }
  // A drag link: both grounded links and the coupler turn fully.
  EXPECT_NEAR(motion.value(360, "coupler.angle") - motion.value(0, "coupler.angle"), 360, 1e-11);
  EXPECT_NEAR(motion.value(360, "rocker.angle") - motion.value(0, "rocker.angle"), 360, 1e-11);
}

// The printed value a_E = (-475.76, -912.56) comes from a rounded alpha3.
TEST(TextbookFourBar, HasTheMotionOfThePointE) {
  const json expected = textbook("fourbar_000_pointE");
  const RunTable motion = analyze(shipped("four_bar", {"driver.samples=1"}));
  ASSERT_EQ(motion.count(RowStatus::kOk), 1U);
  const Complex v(number(expected["v"][0]), number(expected["v"][1]));
  const Complex a(number(expected["a"][0]), number(expected["a"][1]));
  EXPECT_AT_MOST(std::abs(motion.vector(0, "coupler.E.v") - v), kTolerance * std::abs(v));
  EXPECT_AT_MOST(std::abs(motion.vector(0, "coupler.E.a") - a), kTolerance * std::abs(a));
}

TEST(TextbookFourBar, CanBeDrivenByItsCouplersAngle) {
  const json expected = textbook("fourbar_000_coupler_driven");
  Worst angles, velocities, accelerations;
  for (const json& row : expected["rows"]) {
    const double theta3 = row["theta3_deg"].get<double>() * kDegree;
    const std::string text = text_of("four_bar") + dial("coupler", theta3 / kDegree);
    const Profile profile =
        profile_of(text, Settings{"driver.joint=dial_pivot"} +
                             driver(theta3, number(expected["omega3"]), number(expected["alpha3"]), "rad") +
                             four_bar_poses(number(row["theta2"]), theta3, number(row["theta4"])));
    const RunTable motion = analyze(profile);
    ASSERT_EQ(motion.count(RowStatus::kOk), 1U) << motion.failure();
    angles.see(angle_error_at(motion, 0, "crank.angle", row["theta2"]));
    angles.see(angle_error_at(motion, 0, "rocker.angle", row["theta4"]));
    velocities.see(rate_error(motion, 0, "crank.omega", row["omega2"]));
    velocities.see(rate_error(motion, 0, "rocker.omega", row["omega4"]));
    accelerations.see(rate_error(motion, 0, "crank.alpha", row["alpha2"]));
    accelerations.see(rate_error(motion, 0, "rocker.alpha", row["alpha4"]));
  }
  EXPECT_AT_MOST(angles.value(), kTolerance);
  EXPECT_AT_MOST(velocities.value(), kTolerance);
  EXPECT_AT_MOST(accelerations.value(), 5 * kTolerance);
}

struct SliderCrankRow {
  double theta2, theta3, r1, r1_dot, r1_ddot, omega3, alpha3;
};

std::vector<SliderCrankRow> slider_crank_rows() {
  std::vector<SliderCrankRow> rows;
  const json table = textbook("slider_crank_000");
  for (const json& row : table["rows"]) {
    rows.push_back({row["theta2_deg"].get<double>() * kDegree, number(row["theta3"]), number(row["r1"]),
                    number(row["r1_dot"]), number(row["r1_ddot"]), number(row["omega3"]),
                    number(row["alpha3"])});
  }
  return rows;
}

Settings slider_crank_poses(const SliderCrankRow& row) {
  const Complex A = 2.0 * direction(row.theta2);
  return {pose("crank", 0, row.theta2), pose("rod", A, row.theta3),
          pose("piston", A + 5.0 * direction(row.theta3), 20 * kDegree)};
}

TEST(TextbookSliderCrank, HasTheNumbersOfEveryRowInBothAssemblies) {
  Worst worst;
  for (const SliderCrankRow& row : slider_crank_rows()) {
    const RunTable motion =
        analyze(shipped("slider_crank", driver(row.theta2, 3, -2, "rad") + slider_crank_poses(row)));
    ASSERT_EQ(motion.count(RowStatus::kOk), 1U) << motion.failure();
    worst.see(angle_error(motion.radians(0, "rod.angle"), row.theta3));
    worst.see(relative_error(motion.value(0, "slide.position"), row.r1));
    worst.see(relative_error(motion.value(0, "slide.velocity"), row.r1_dot));
    worst.see(relative_error(motion.value(0, "slide.acceleration"), row.r1_ddot));
    worst.see(relative_error(motion.radians(0, "rod.omega"), row.omega3));
    worst.see(relative_error(motion.radians(0, "rod.alpha"), row.alpha3));
  }
  EXPECT_AT_MOST(worst.value(), kTolerance);
}

TEST(TextbookSliderCrank, GivesTheCrankBackWhenDrivenByItsPiston) {
  Worst worst;
  for (const SliderCrankRow& row : slider_crank_rows()) {
    // Near the ends of the stroke the crank is determined less well, the slower the piston is; the input
    // itself has an error of one rounding.
    const double condition = std::pow(6 / std::abs(row.r1_dot), 3);
    const RunTable motion = analyze(
        shipped("slider_crank", Settings{"driver.joint=slide"} +
                                    driver(row.r1, row.r1_dot, row.r1_ddot, "cm") + slider_crank_poses(row)));
    ASSERT_EQ(motion.count(RowStatus::kOk), 1U) << motion.failure();
    worst.see(angle_error(motion.radians(0, "crank.angle"), row.theta2) / condition);
    worst.see(angle_error(motion.radians(0, "rod.angle"), row.theta3) / condition);
    worst.see(relative_error(motion.radians(0, "crank.omega"), 3) / condition);
    worst.see(relative_error(motion.radians(0, "crank.alpha"), -2) / condition);
    worst.see(relative_error(motion.radians(0, "rod.alpha"), row.alpha3) / condition);
  }
  EXPECT_AT_MOST(worst.value(), kTolerance);
}

TEST(TextbookSliderCrank, GivesTheCrankBackWhenDrivenByItsRodsAngle) {
  Worst worst;
  for (const SliderCrankRow& row : slider_crank_rows()) {
    const double condition = std::pow(1.2 / std::abs(row.omega3), 3);
    const std::string text = text_of("slider_crank") + dial("rod", row.theta3 / kDegree);
    const RunTable motion = analyze(profile_of(text, Settings{"driver.joint=dial_pivot"} +
                                                         driver(row.theta3, row.omega3, row.alpha3, "rad") +
                                                         slider_crank_poses(row)));
    ASSERT_EQ(motion.count(RowStatus::kOk), 1U) << motion.failure();
    worst.see(angle_error(motion.radians(0, "crank.angle"), row.theta2) / condition);
    worst.see(relative_error(motion.value(0, "slide.position"), row.r1) / condition);
    worst.see(relative_error(motion.radians(0, "crank.omega"), 3) / condition);
    worst.see(relative_error(motion.radians(0, "crank.alpha"), -2) / condition);
  }
  EXPECT_AT_MOST(worst.value(), kTolerance);
}

// The text exchanges omega and alpha of the crank (5 and 8); its slider acceleration of 0.961 m/s^2 at 0.5 s
// should be 0.96544.
TEST(TextbookSixBarWithSlider, HasTheWholeTable) {
  const json table = textbook("sixbar_002")["table"];
  const RunTable motion = step(shipped("sixbar_slider"));
  expect_all_ok(motion);
  ASSERT_EQ(motion.size(), table.size());
  Worst angles, rates;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const json& row = table[i];
    for (const char* link : {"2", "3", "4", "5"}) {
      const std::string body = std::string("link") + link;
      angles.see(angle_error_at(motion, i, body + ".angle", row[std::string("theta") + link]));
      rates.see(rate_error(motion, i, body + ".omega", row[std::string("omega") + link]));
    }
    for (const char* link : {"3", "4", "5"}) {
      rates.see(
          rate_error(motion, i, std::string("link") + link + ".alpha", row[std::string("alpha") + link]));
    }
    angles.see(std::abs(motion.value(i, "slide.position") / 100 - number(row["xG"])));
    rates.see(relative_error(motion.value(i, "slide.velocity") / 100, number(row["vG"])));
    rates.see(relative_error(motion.value(i, "slide.acceleration") / 100, number(row["aG"])));
  }
  EXPECT_AT_MOST(angles.value(), kTolerance);
  EXPECT_AT_MOST(rates.value(), kTolerance);
}

Settings watt_poses(const json& row) {
  const auto place = [&](const char* name) {
    return Complex(number(row[name][0]), number(row[name][1])) * 1000.0;
  };
  return {pose("link5", place("D"), number(row["theta5"])), pose("link6", place("D"), number(row["theta6"]))};
}

void compare_watt_row(const RunTable& motion, std::size_t i, const json& row, Worst& worst) {
  for (const char* link : {"3", "4", "5", "6"}) {
    const std::string body = std::string("link") + link;
    worst.see(angle_error_at(motion, i, body + ".angle", row[std::string("theta") + link]));
    worst.see(rate_error(motion, i, body + ".omega", row[std::string("omega") + link]));
    worst.see(rate_error(motion, i, body + ".alpha", row[std::string("alpha") + link]));
  }
  for (const char* point : {"4.C", "4.H", "6.D"}) {
    const json& p = row[std::string(point).substr(2)];
    worst.see(std::abs(motion.vector(i, std::string("link") + point + ".") / 1000.0 -
                       Complex(number(p[0]), number(p[1]))));
  }
}

// The printed accelerations of mass centres treat every link as turning about A; here every link has its own
// pivot.
TEST(TextbookWattSixBar, HasTheMotionOfBothAssembliesOverTwoTurns) {
  const json branches = read_data("watt_sixbar.json")["branches"];
  for (const json& branch : branches) {
    if (branch["full_rotation"] == false) continue;
    const json& rows = branch["rows"];
    const RunTable motion = analyze(shipped("watt_sixbar", watt_poses(rows[0])));
    expect_all_ok(motion);
    ASSERT_EQ(motion.size(), 2 * rows.size() - 1);
    Worst worst;
    for (std::size_t i = 0; i < motion.size(); ++i) {
      compare_watt_row(motion, i, rows[i % (rows.size() - 1)], worst);
    }
    EXPECT_AT_MOST(worst.value(), kTolerance);
  }
}

// With C to the right of the line from B to E only part of the turn can be assembled; the poses select this
// assembly.
TEST(TextbookWattSixBar, TakesEachOfTheFourAssembliesThatThePosesShow) {
  const json branches = read_data("watt_sixbar.json")["branches"];
  ASSERT_EQ(branches.size(), 4U);
  for (const json& branch : branches) {
    Worst worst;
    int assembled = 0;
    for (const json& row : branch["rows"]) {
      if (row.contains("assembles") && row["assembles"] == false) continue;
      ++assembled;
      const double theta2 = row["theta2_deg"].get<double>() * kDegree;
      const Complex C(number(row["C"][0]) * 1000, number(row["C"][1]) * 1000);
      const RunTable motion = analyze(
          shipped("watt_sixbar", driver(theta2, 1, 0, "rad") + watt_poses(row) +
                                     Settings{pose("link2", 0, theta2),
                                              pose("link3", 40.0 * direction(theta2), number(row["theta3"])),
                                              pose("link4", C, number(row["theta4"]))}));
      ASSERT_EQ(motion.count(RowStatus::kOk), 1U) << motion.failure();
      compare_watt_row(motion, 0, row, worst);
    }
    EXPECT_GT(assembled, 0);
    EXPECT_AT_MOST(worst.value(), 10 * kTolerance);
  }
}

// Arms of 7 on a frame of 10 with a coupler of 1: a <= d and a + d <= c, so that the coupler turns fully.
TEST(TextbookDoubleRocker, TurnsItsCouplerFullyAndSwingsItsArmsInTheTextsRange) {
  const json expected = textbook("exercise3_000");
  const RunTable motion = analyze(shipped("double_rocker"));
  expect_all_ok(motion);
  EXPECT_NEAR(motion.value(360, "coupler.angle") - motion.value(0, "coupler.angle"), 360, 1e-10);
  double low = 1e9, high = 0;
  int ends = 0;
  for (const RunEvent& event : motion.events()) {
    if (event.type != EventType::kStrokeEnd) continue;
    ++ends;
    const RunTable there = analyze(shipped("double_rocker", driver(event.driver, 1, 0, "rad")));
    low = std::min(low, there.radians(0, "left_arm.angle"));
    high = std::max(high, there.radians(0, "left_arm.angle"));
  }
  EXPECT_EQ(ends, 4);  // two of each arm
  // To first order the angle at the end of a stroke does not depend on an error of the position found.
  EXPECT_NEAR(low / kDegree, number(expected["arm_angle_range_deg"][0]), 1e-10);
  EXPECT_NEAR(high / kDegree, number(expected["arm_angle_range_deg"][1]), 1e-10);
}

TEST(TextbookDoubleRocker, MovesTheSameWhenTheCouplersAngleAgainstGroundIsDriven) {
  const RunTable motion = analyze(shipped("double_rocker"));
  Worst worst;
  for (std::size_t i = 0; i < motion.size(); i += 7) {
    const double angle = motion.radians(i, "coupler.angle");
    const Complex A = motion.vector(i, "coupler.A.");
    const std::string text = text_of("double_rocker") + dial("coupler", angle / kDegree);
    const RunTable other = analyze(profile_of(
        text,
        Settings{"driver.joint=dial_pivot"} +
            driver(angle, motion.radians(i, "coupler.omega"), motion.radians(i, "coupler.alpha"), "rad") +
            Settings{pose("left_arm", 0, motion.radians(i, "left_arm.angle")), pose("coupler", A, angle),
                     pose("right_arm", 10, motion.radians(i, "right_arm.angle"))}));
    ASSERT_EQ(other.count(RowStatus::kOk), 1U) << other.failure();
    for (const char* column : {"left_arm.angle", "left_arm.omega", "left_arm.alpha", "right_arm.angle",
                               "right_arm.omega", "right_arm.alpha"}) {
      const double scale = std::abs(motion.radians(i, "coupler.omega"));
      worst.see(std::abs(other.radians(0, column) - motion.radians(i, column)) / (1 + scale * scale));
    }
    worst.see(std::abs(other.vector(0, "coupler.T.") - motion.vector(i, "coupler.T.")));
  }
  EXPECT_AT_MOST(worst.value(), kTolerance);
}

TEST(TextbookChain, HasTheMotionOfBothFollowersOfTwoContactsInSeries) {
  const json reference = read_data("chain/pub14_chain_circles.json");
  std::string positions;
  for (const json& row : reference["rows"]) positions += row["th1_deg"].dump() + ", ";
  const RunTable motion = analyze(shipped("cam_chain", {"driver.positions=[" + positions + "]"}));
  expect_all_ok(motion);
  ASSERT_EQ(motion.size(), reference["rows"].size());
  Worst worst;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const json& row = reference["rows"][i];
    const auto point = [&](const char* name) { return Complex(row[name][0], row[name][1]); };
    worst.see(angle_error_at(motion, i, "arm.angle", row["q2"]));
    worst.see(angle_error_at(motion, i, "second_arm.angle", row["q3"]));
    worst.see(rate_error(motion, i, "arm.omega", row["omega2"]));
    worst.see(rate_error(motion, i, "arm.alpha", row["alpha2"]));
    worst.see(rate_error(motion, i, "second_arm.omega", row["omega3"]));
    worst.see(rate_error(motion, i, "second_arm.alpha", row["alpha3"]));
    worst.see(std::abs(motion.vector(i, "first.") - point("P12")) / 80);
    worst.see(std::abs(motion.vector(i, "second.") - point("P23")) / 80);
    worst.see(angle_error(motion.radians(i, "first.normal"), std::arg(point("n12"))));
    worst.see(angle_error(motion.radians(i, "second.normal"), std::arg(point("n23"))));
    worst.see(std::abs(motion.value(i, "first.sliding") - number(row["v_slide12"])) / 200);
    worst.see(std::abs(motion.value(i, "second.sliding") - number(row["v_slide23"])) / 200);
    worst.see(std::abs(motion.radians(i, "first.pressure") - number(row["pressure_angle12"])));
    worst.see(std::abs(motion.radians(i, "second.pressure") - number(row["pressure_angle23"])));
  }
  EXPECT_AT_MOST(worst.value(), kTolerance);
}

}  // namespace
}  // namespace higherpair
