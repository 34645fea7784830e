// Measures: each compared with the columns of the whole run, and their origin.
#include "front/cam_profile.hpp"
#include "higherpair/higherpair.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::kCam;
using testing::lines_are;
using testing::model_of;

Measure measure(const std::string& column, MeasureKind of, double at = 0) {
  return {column, of, at, {"test.toml", 7, 3}, "results.m.column"};
}

std::vector<Measure> every_measure(const std::string& column, double at) {
  std::vector<Measure> measures;
  for (std::size_t k = 0; k < kMeasureNames.size(); ++k) {
    measures.push_back(measure(column, static_cast<MeasureKind>(k), at));
  }
  return measures;
}

std::vector<Measured> measured(const Model& model, const std::vector<Measure>& measures,
                               const RunSettings& settings = {}) {
  Analysis analysis = model.start(settings_for(model, measures, settings).value()).value();
  MeasureSet set(measures, analysis.columns());
  Row row;
  while (analysis.next(row)) {
    set.add(row);
  }
  std::vector<Measured> values;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    values.push_back(set.value(i));
  }
  return values;
}

std::string measure_refusal(const Model& model, const std::vector<Measure>& measures,
                            const RunSettings& settings = {}) {
  const auto made = settings_for(model, measures, settings);
  return made ? "" : to_string(made.error());
}

// Beyond 70 degrees coupler and rocker do not reach each other: rows without values.
constexpr const char* kShortFourBar = R"(
[bodies.ground]
points.A = [0, 0]
points.D = [70, 0]
[bodies.crank]
points.A = [0, 0]
points.B = [31, 0]
[bodies.coupler]
pose = { x = 31, y = 0, angle = 60 }
points.B = [0, 0]
points.C = [37, 0]
[bodies.rocker]
pose = { x = 70, y = 0, angle = 110 }
points.D = [0, 0]
points.C = [29, 0]
[joints]
A = { type = "revolute", between = ["ground.A", "crank.A"] }
B = { type = "revolute", between = ["crank.B", "coupler.B"] }
C = { type = "revolute", between = ["coupler.C", "rocker.C"] }
D = { type = "revolute", between = ["ground.D", "rocker.D"] }
[driver]
joint = "A"
samples = 181
)";

TEST(Measures, AgreeWithTheColumnsOfTheWholeRun) {
  const Model model = model_of(kCam, {"driver.samples=97", "driver.end=337"});
  RunSettings settings;
  settings.columns = {"driver", "follower.ay", "follower.y"};
  const Motion motion = model.run(settings).value();
  const ColumnValues driver = motion.column("driver");
  for (const std::string name : {"follower.y", "follower.ay"}) {
    const ColumnValues v = motion.column(name);
    const std::size_t row = 31;
    const auto m = measured(model, every_measure(name, driver[row]));
    const auto at = [&](auto found) { return driver[found - v.begin()]; };
    const auto [low, high] =
        std::pair(std::min_element(v.begin(), v.end()), std::max_element(v.begin(), v.end()));
    const auto farther = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto far = std::max_element(v.begin(), v.end(), farther);
    const double n = static_cast<double>(v.size());
    EXPECT_EQ(m[0].value, *high);
    EXPECT_EQ(m[0].where, at(high));
    EXPECT_EQ(m[1].value, *low);
    EXPECT_EQ(m[1].where, at(low));
    EXPECT_EQ(m[2].value, std::abs(*far));
    EXPECT_EQ(m[2].where, at(far));
    EXPECT_EQ(m[3].value, *high - *low);
    EXPECT_TRUE(std::isnan(m[3].where));
    EXPECT_NEAR(m[4].value, std::accumulate(v.begin(), v.end(), 0.0) / n, 1e-13 * m[2].value);
    EXPECT_NEAR(m[5].value, std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0) / n),
                1e-13 * m[2].value);
    EXPECT_EQ(m[6].value, v[0]);
    EXPECT_EQ(m[6].where, driver[0]);
    EXPECT_EQ(m[7].value, v[v.size() - 1]);
    EXPECT_EQ(m[7].where, driver[v.size() - 1]);
    EXPECT_EQ(m[8].value, v[row]);
    EXPECT_EQ(m[8].where, driver[row]);
  }
}

// y = 30 + 10 sin of the angle.
TEST(Measures, OfASineAreThoseOfTheClosedForm) {
  const Model model = model_of(kCam, {"driver.end=359", "driver.samples=360"});
  const auto m = measured(model, every_measure("follower.y", 30));
  const std::vector<double> expected = {
      40, 20, 40, 20, 30, std::sqrt(950.0), 30, 30 - 10 * std::sin(kPi / 180), 35};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(m[i].value, expected[i], 1e-12) << kMeasureNames[i];
  }
  EXPECT_EQ(m[0].where, 90);
  EXPECT_EQ(m[1].where, 270);
}

TEST(Measures, LeaveRowsWithoutAValueOut) {
  const Model model = model_of(kShortFourBar);
  RunSettings settings;
  settings.columns = {"rocker.angle"};
  const Motion motion = model.run(settings).value();
  const ColumnValues v = motion.column("rocker.angle");
  double sum = 0;
  int defined = 0;
  for (const double value : v) {
    sum += std::isnan(value) ? 0 : value;
    defined += std::isnan(value) ? 0 : 1;
  }
  ASSERT_GT(defined, 20);
  ASSERT_LT(defined, 160);
  std::vector<Measure> measures = every_measure("rocker.angle", 180);
  const auto m = measured(model, measures);
  EXPECT_NEAR(m[4].value, sum / defined, 1e-12);
  EXPECT_FALSE(std::isnan(m[0].value));
  EXPECT_TRUE(std::isnan(m[8].value)) << "the row is there, its value is not";
  EXPECT_TRUE(std::isnan(m[8].where));
}

TEST(Measures, WithoutAnyRowAreUndefined) {
  const Model model = model_of(kCam);
  const std::vector<Measure> measures = every_measure("follower.y", 0);
  const Analysis analysis = model.start(settings_for(model, measures).value()).value();
  const MeasureSet set(measures, analysis.columns());
  for (std::size_t i = 0; i < set.size(); ++i) {
    EXPECT_TRUE(std::isnan(set.value(i).value)) << kMeasureNames[i];
    EXPECT_TRUE(std::isnan(set.value(i).where)) << kMeasureNames[i];
  }
}

TEST(Measures, CanBeTakenOfOneRunAfterTheOther) {
  const Model model = model_of(kCam);
  const std::vector<Measure> measures = every_measure("follower.y", 0);
  const RunSettings settings = settings_for(model, measures).value();
  MeasureSet set(measures, model.start(settings)->columns());
  std::vector<Measured> first;
  for (int pass = 0; pass < 2; ++pass) {
    set.clear();
    Analysis analysis = model.start(settings).value();
    Row row;
    while (analysis.next(row)) set.add(row);
    for (std::size_t i = 0; i < set.size(); ++i) {
      if (pass == 0) first.push_back(set.value(i));
      EXPECT_EQ(set.value(i).value, first[i].value);
    }
  }
}

TEST(Measures, ComeInTheUnitsOfTheRun) {
  const Model model = model_of(kCam);
  const std::vector<Measure> measures = {measure("follower.y", MeasureKind::kMax)};
  RunSettings settings;
  settings.units = kSiUnits;
  Analysis analysis = model.start(settings_for(model, measures, settings).value()).value();
  const MeasureSet set(measures, analysis.columns());
  EXPECT_EQ(set.unit(0), "m");
  EXPECT_EQ(set.where_unit(), "rad");
  EXPECT_NEAR(measured(model, measures, settings)[0].value, 0.040, 1e-12);
}

TEST(Measures, OfARunInTimeSayWhen) {
  const Model model = model_of(kCam, {"driver.velocity=90", "driver.duration=4", "driver.time_step=0.25"});
  RunSettings settings;
  settings.in_time = true;
  const auto m =
      measured(model, {measure("follower.y", MeasureKind::kMax), measure("follower.y", MeasureKind::kAt, 3)},
               settings);
  EXPECT_EQ(m[0].where, 1);
  EXPECT_NEAR(m[1].value, 20, 1e-12);
}

TEST(Measures, AskForForcesAndJerkOnlyWhereAColumnNeedsThem) {
  const Model model = model_of(kCam);
  const auto wants = [&](const std::string& column) {
    const std::vector<Measure> measures = {measure(column, MeasureKind::kMax)};
    const RunSettings settings = settings_for(model, measures).value();
    return std::pair(settings.forces, settings.jerk);
  };
  EXPECT_EQ(wants("follower.y"), std::pair(false, false));
  EXPECT_EQ(wants("touch.force"), std::pair(true, false));
  EXPECT_EQ(wants("follower.jy"), std::pair(false, true));
}

TEST(Measures, AskForNoColumnsThatTheyDoNotNeed) {
  const Model model = model_of(kCam);
  const std::vector<Measure> measures = {measure("follower.y", MeasureKind::kMax),
                                         measure("follower.y", MeasureKind::kMin)};
  EXPECT_TRUE(lines_are(settings_for(model, measures)->columns, {"driver", "follower.y"}));
}

TEST(Measures, NameTheColumnsThatAreLikeAWrongOne) {
  const Model model = model_of(kCam);
  EXPECT_EQ(
      measure_refusal(model, {measure("folower.y", MeasureKind::kMax), measure("status", MeasureKind::kMax)}),
      "test.toml:7:3: results.m.column = \"folower.y\": there is no such column; did you mean "
      "`follower.y` or "
      "`follower.x` or `follower.vy`?\n"
      "test.toml:7:3: results.m.column = \"status\": this column holds words; a measure needs numbers");
  Measure own;  // of a program
  own.column = "folower.y";
  EXPECT_THAT(measure_refusal(model, {own}), ::testing::StartsWith("test.toml: \"folower.y\": there is no"));
}

TEST(Measures, WantARowWhereTheyAreTaken) {
  const Model model = model_of(kCam);
  const auto at = [&](double place) {
    return measure_refusal(model, {measure("follower.y", MeasureKind::kAt, place)});
  };
  EXPECT_EQ(at(17), "");
  EXPECT_EQ(
      at(90.5),
      "test.toml:7:3: results.m.at = 90.5: no row is at 90.5: the rows next to it are at 90 and 91; choose "
      "one of the rows, or let driver.samples or driver.positions have a row there");
  EXPECT_TRUE(contains(at(400), "the rows end at 360;"));
  EXPECT_TRUE(contains(at(-1), "the rows begin at 0;"));
  EXPECT_EQ(at(std::nan("")), "test.toml:7:3: results.m.at = nan: must be finite");
}

// A place is one of the run's own units.
TEST(Measures, WantARowWhereTheyAreTakenInTheUnitsOfTheRun) {
  const Model model = model_of(kCam);
  RunSettings settings;
  settings.units = kSiUnits;
  const std::vector<Measure> quarter = {measure("follower.y", MeasureKind::kAt, kPi / 2)};
  EXPECT_NEAR(measured(model, quarter, settings)[0].value, 0.040, 1e-12);
  const auto none = settings_for(model, std::vector{measure("follower.y", MeasureKind::kAt, 30)}, settings);
  ASSERT_FALSE(none);
  EXPECT_TRUE(contains(to_string(none.error()), "no row is at 30: the rows end at 6.28"));
}

TEST(Measures, OfAMechanismThatCannotRunSayWhy) {
  const Model model = model_of(kCam, {"bodies.loose.points.P=[0, 0]"});
  const auto made = settings_for(model, std::vector<Measure>{measure("follower.y", MeasureKind::kMax)});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().kind, ErrorKind::kMechanism);
}

}  // namespace
}  // namespace higherpair
