#include "higherpair/io/driver_schedule.hpp"

#include "higherpair/io/profile_reader.hpp"
#include "higherpair/io/row_path.hpp"
#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::crank_profile;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using testing::read;
using testing::slider_profile;
using Samples = std::optional<std::int64_t>;
using testing::lines_are;
using testing::part;

DriverSchedule analyze(const std::string& text, Samples samples = {}) {
  return DriverSchedule::analyze(read(text), samples).value();
}

DriverSchedule step(const std::string& text, Samples samples = {}) {
  return DriverSchedule::step(read(text), samples).value();
}

std::vector<std::string> lines(const tl::expected<DriverSchedule, Diagnostics>& schedule) {
  std::vector<std::string> result;
  if (!schedule) {
    for (const Diagnostic& diagnostic : schedule.error()) result.push_back(to_string(diagnostic));
  }
  return result;
}

std::vector<double> positions(const DriverSchedule& schedule) {
  std::vector<double> result;
  for (std::int64_t k = 0; k < schedule.size(); ++k) result.push_back(schedule.state(k).profile.position);
  return result;
}

std::vector<double> times(const DriverSchedule& schedule) {
  std::vector<double> result;
  for (std::int64_t k = 0; k < schedule.size(); ++k) result.push_back(schedule.time(k));
  return result;
}

TEST(AnalyzeSchedule, SpacesItsRowsEquallyWithBothEnds) {
  EXPECT_THAT(positions(analyze(crank_profile("start = -10\nend = 20\nsamples = 4\n"))),
              ElementsAre(-10, 0, 10, 20));
  EXPECT_THAT(positions(analyze(crank_profile("start = 0.1\nend = 0.5\nsamples = 5\n"))),
              ElementsAre(0.1, 0.2, 0.3, 0.4, 0.5));
  EXPECT_THAT(positions(analyze(crank_profile("start = 1\nend = 0\nsamples = 6\n"))),
              ElementsAre(1, 0.8, 0.6, 0.4, 0.2, 0));
}

TEST(AnalyzeSchedule, GivesWholeDegreesOverATurn) {
  const DriverSchedule schedule = analyze(crank_profile("start = 0\nend = 360\n"));
  ASSERT_EQ(schedule.size(), 361);
  EXPECT_FALSE(schedule.is_timed());
  EXPECT_EQ(schedule.driver_count(), 1U);
  for (std::int64_t k = 0; k <= 360; ++k)
    EXPECT_EQ(schedule.state(k).profile.position, static_cast<double>(k));
  EXPECT_EQ(schedule.state(90).si.position, kPi / 2);
}

TEST(AnalyzeSchedule, EndsExactlyWhateverTheRounding) {
  const DriverSchedule schedule = analyze(slider_profile("start = 1e17\nend = 0.3\nsamples = 1000003\n"));
  EXPECT_EQ(schedule.state(0).profile.position, 1e17);
  EXPECT_EQ(schedule.state(schedule.size() - 1).profile.position, 0.3);
}

TEST(AnalyzeSchedule, OneSampleIsTheStart) {
  EXPECT_THAT(positions(analyze(crank_profile("start = 7\nend = 20\nsamples = 1\n"))), ElementsAre(7));
}

TEST(AnalyzeSchedule, WithoutEndATurnIsMadeOrASliderStays) {
  const DriverSchedule turn = analyze(crank_profile("start = 30\n"));
  EXPECT_EQ(turn.size(), 361);
  EXPECT_EQ(turn.state(360).profile.position, 390);
  EXPECT_EQ(turn.state(17).profile.position, 47);
  EXPECT_THAT(positions(analyze(slider_profile("start = 30\n"))), ElementsAre(30));
}

TEST(AnalyzeSchedule, RepeatsExplicitPositionsDigitByDigit) {
  EXPECT_THAT(positions(analyze(
                  crank_profile("start = 5\nend = 6\nsamples = 9\npositions = [0.1, 40, -15.7, 40]\n"))),
              ElementsAre(0.1, 40, -15.7, 40));
}

TEST(AnalyzeSchedule, HasTheVelocityAndAccelerationOfTheProfileInEveryRow) {
  const DriverSchedule schedule =
      analyze(crank_profile("end = 90\nvelocity = \"300 rpm\"\nacceleration = 45\n"));
  for (const std::int64_t k : {0, 77, 360}) {
    const DriverState state = schedule.state(k);
    EXPECT_EQ(state.profile.velocity, 1800);
    EXPECT_EQ(state.profile.acceleration, 45);
    EXPECT_EQ(state.si.velocity, 10 * kPi);
    EXPECT_EQ(state.si.acceleration, kPi / 4);
    EXPECT_EQ(schedule.time(k), 0);
  }
}

TEST(AnalyzeSchedule, TheOptionSamplesTakesThePlaceOfTheProfiles) {
  EXPECT_THAT(positions(analyze(crank_profile("start = 0\nend = 30\nsamples = 99\n"), 3)),
              ElementsAre(0, 15, 30));
  EXPECT_EQ(analyze(crank_profile(), 10'000'001).size(), 10'000'001);
  EXPECT_TRUE(lines_are(lines(DriverSchedule::analyze(read(crank_profile()), 0)),
                        {"setting samples 0: must be an integer from 1 to 2^53"}));
}

TEST(AnalyzeSchedule, RefusesWhatHasNoMeaning) {
  EXPECT_TRUE(lines_are(lines(DriverSchedule::analyze(read(crank_profile("positions = [1, 2]\n")), 5)),
                        {"test.toml:12:13: driver.positions are given one by one, and each is a row: leave "
                         "--samples out, or give `end` in place of `positions`"}));
  EXPECT_TRUE(lines_are(
      lines(DriverSchedule::analyze(read(slider_profile("samples = 7\n")))),
      {"test.toml:11:1: driver.end is missing: 7 samples need one (the same as start to stay there)"}));
}

constexpr const char* kTwoDrivers = R"([bodies.ground]
points.A = [0, 0]
[bodies.crank]
points.A = [0, 0]
points.B = [31, 0]
[bodies.arm]
points.B = [0, 0]
[joints.one]
type = "revolute"
between = ["ground.A", "crank.A"]
[joints.two]
type = "prismatic"
between = ["crank.B", "arm.B"]
direction = 0
)";

TEST(AnalyzeSchedule, SeveralDriversHaveEquallyManyPositions) {
  const std::string one = "[drivers.a]\njoint = \"one\"\nend = 360\nsamples = 3\n";
  const std::string two = "[drivers.b]\njoint = \"two\"\n";
  const DriverSchedule schedule = analyze(kTwoDrivers + one + two + "positions = [4, 5, 7]\n");
  EXPECT_EQ(schedule.size(), 3);
  EXPECT_EQ(schedule.driver_count(), 2U);
  EXPECT_EQ(schedule.state(1, 0).profile.position, 180);
  EXPECT_EQ(schedule.state(1, 1).profile.position, 5);
  EXPECT_EQ(schedule.state(1, 1).si.position, 0.005);
  EXPECT_TRUE(
      lines_are(lines(DriverSchedule::analyze(read(kTwoDrivers + one + two + "positions = [4, 5]\n"))),
                {"test.toml:21:13: drivers.b.positions are 2 positions where the first driver has 3: "
                 "all drivers need equally many"}));
  EXPECT_TRUE(
      lines_are(lines(DriverSchedule::analyze(read(kTwoDrivers + one + two + "end = 4\nsamples = 2\n"))),
                {part("drivers.b.samples gives 2 positions where the first driver has 3")}));
}

TEST(StepSchedule, HasARowAtEveryTimeStepAndAtBothEnds) {
  const DriverSchedule schedule = step(testing::kCamProfile);
  ASSERT_EQ(schedule.size(), 601);
  EXPECT_TRUE(schedule.is_timed());
  for (std::int64_t k = 0; k <= 600; ++k) {
    EXPECT_EQ(schedule.time(k), static_cast<double>(k) / 100);
    EXPECT_EQ(schedule.time_si(k), schedule.time(k));
    EXPECT_NEAR(schedule.state(k).profile.position, 0.6 * static_cast<double>(k), 1e-13);
  }
}

TEST(StepSchedule, TakesTheTimeStepForTheDecimalNumberThatItIs) {
  const DriverSchedule tenths = step(crank_profile("duration = 0.7\ntime_step = 0.1\n"));
  EXPECT_THAT(times(tenths), ElementsAre(0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7));
  const DriverSchedule fine = step(crank_profile("duration = 1e6\ntime_step = 1e-9\n"));
  EXPECT_EQ(fine.time(300'000'000'000'003), 300000.000000003);
  const DriverSchedule coarse = step(crank_profile("velocity = 0\nduration = 1e30\ntime_step = 1.7e28\n"));
  EXPECT_EQ(coarse.time(3), 5.1e28);
}

// start + 20 t - 10 t² is 9 beyond the start at 1 - √0.1 and 1 + √0.1: before and after the driver's turning
// point.
TEST(StepSchedule, TellsTheTimeOfAPassageOnTheRightSideOfTheTurningPoint) {
  const DriverSchedule schedule = step(
      crank_profile("start = 29.2\nvelocity = 20\nacceleration = -20\nduration = 2.1\ntime_step = 0.7\n"));
  EXPECT_NEAR(schedule.passing_time(1, 38.2, 0.99), 1 - std::sqrt(0.1), 1e-14);
  EXPECT_NEAR(schedule.passing_time(2, 38.2, 0.1), 1 + std::sqrt(0.1), 1e-14);
  EXPECT_NEAR(schedule.passing_time(3, 29.2, 0.9), 2, 1e-14);
  // At the turning point itself, and beyond it by a rounding.
  EXPECT_NEAR(schedule.passing_time(2, 39.2, 0.4), 1, 1e-7);
  EXPECT_NEAR(schedule.passing_time(2, 39.2000000000001, 0.4), 1, 1e-7);
  const auto turning = schedule.turning_points(2);
  ASSERT_EQ(turning.size(), 1U);
  EXPECT_NEAR(turning[0].si.position, 39.2 * kPi / 180, 1e-15);
  EXPECT_EQ(turning[0].si.velocity, 0);
  EXPECT_NEAR(turning[0].si.acceleration, -20 * kPi / 180, 1e-15);
  EXPECT_NEAR(turning[0].share, 3.0 / 7, 1e-15);
  for (const std::int64_t row : {0, 1, 3}) EXPECT_THAT(schedule.turning_points(row), ::testing::IsEmpty());
  const DriverSchedule uniform = step(crank_profile("velocity = -5\nduration = 4\ntime_step = 1\n"));
  EXPECT_NEAR(uniform.passing_time(3, -12, 0.4), 2.4, 1e-15);
}

TEST(StepSchedule, EndsAtTheDurationAlsoIfItIsNoMultiple) {
  EXPECT_THAT(times(step(crank_profile("duration = 1\ntime_step = 0.3\n"))),
              ElementsAre(0, 0.3, 0.6, 0.9, 1));
  EXPECT_THAT(times(step(crank_profile("duration = 0.1\ntime_step = 0.3\n"))), ElementsAre(0, 0.1));
  EXPECT_THAT(times(step(crank_profile("duration = 0\ntime_step = 0.3\n"))), ElementsAre(0));
}

TEST(StepSchedule, RoundingOfDurationAndTimeStepMakesNoRow) {
  for (const double step_size : {0.1, 0.2, 0.3, 0.7, 0.001, 1e-4, 1.0 / 3, 0.07}) {
    for (const int steps : {1, 3, 10, 57, 999, 100'000}) {
      Profile profile = read(crank_profile());
      profile.programs[0].time_step = step_size;
      profile.programs[0].duration = step_size * steps;
      const auto schedule = DriverSchedule::step(profile);
      ASSERT_TRUE(schedule);
      EXPECT_EQ(schedule->size(), steps + 1) << step_size;
      EXPECT_EQ(schedule->time(steps), step_size * steps);
    }
  }
}

TEST(StepSchedule, TakesATimeStepOfElevenDigitsForTheThirdThatItIs) {
  EXPECT_EQ(step(crank_profile("duration = 1\ntime_step = 0.33333333333\n")).size(), 4);
}

TEST(StepSchedule, MovesUniformlyAccelerated) {
  const DriverSchedule schedule =
      step(crank_profile("start = 3\nvelocity = -7\nacceleration = 11\nduration = 2\ntime_step = 0.25\n"));
  for (std::int64_t k = 0; k < schedule.size(); ++k) {
    const double t = 0.25 * static_cast<double>(k);
    const DriverState state = schedule.state(k);
    EXPECT_DOUBLE_EQ(state.profile.position, 3 - 7 * t + 5.5 * t * t);
    EXPECT_DOUBLE_EQ(state.profile.velocity, -7 + 11 * t);
    EXPECT_EQ(state.profile.acceleration, 11);
    EXPECT_NEAR(state.si.position, state.profile.position * kPi / 180, 1e-16);
  }
}

TEST(StepSchedule, CountsTimeInTheUnitOfTheProfile) {
  const DriverSchedule schedule = step(crank_profile(
      "velocity = \"60 deg/s\"\nduration = \"2 s\"\ntime_step = 500\n", "[units]\ntime = \"ms\"\n"));
  EXPECT_THAT(times(schedule), ElementsAre(0, 500, 1000, 1500, 2000));
  EXPECT_EQ(schedule.time_si(1), 0.5);
  EXPECT_NEAR(schedule.state(1).profile.position, 30, 1e-14);
}

TEST(StepSchedule, TheOptionSamplesDividesTheDuration) {
  EXPECT_THAT(times(step(crank_profile("duration = 1\ntime_step = 0.3\n"), 5)),
              ElementsAre(0, 0.25, 0.5, 0.75, 1));
  EXPECT_THAT(times(step(crank_profile("duration = 1\n"), 2)), ElementsAre(0, 1));
  EXPECT_THAT(times(step(crank_profile("duration = 1\n"), 1)), ElementsAre(0));
}

TEST(StepSchedule, NeedsADurationAndATimeStep) {
  EXPECT_TRUE(lines_are(lines(DriverSchedule::step(read(crank_profile()))),
                        {"test.toml:10:1: driver.duration is missing: `step` needs to know how long to run",
                         "test.toml:10:1: driver.time_step is missing: give the time between two rows, or "
                         "the number of rows by --samples"}));
}

TEST(StepSchedule, RefusesAbsurdNumbersOfRowsAndPositions) {
  EXPECT_TRUE(lines_are(
      lines(DriverSchedule::step(read(crank_profile("duration = 1e9\ntime_step = 1e-9\n")))),
      {"test.toml:13:13: driver.time_step is too small: the duration would have more than 2^53 rows; "
       "give a longer one"}));
  EXPECT_TRUE(lines_are(lines(DriverSchedule::step(read(
                            slider_profile("duration = 1e40\ntime_step = 1e39\nacceleration = 1e10\n")))),
                        {"test.toml:13:12: driver.duration takes the driver beyond 1e50 m"}));
  EXPECT_TRUE(lines_are(
      lines(DriverSchedule::step(read(crank_profile("duration = 1e9\ntime_step = 1e8\nvelocity = 400\n")))),
      {"test.toml:12:12: driver.duration takes the driver over more than 1e9 turns: its place "
       "within the turn is rounding"}));
  EXPECT_EQ(step(crank_profile("duration = 1e6\ntime_step = 1e-9\n")).size(), 1'000'000'000'000'001);
}

TEST(StepSchedule, SeveralDriversShareTheirTime) {
  const std::string drivers =
      "[drivers.a]\njoint = \"one\"\nduration = 2\n[drivers.b]\njoint = \"two\"\ntime_step = 1\n";
  EXPECT_THAT(times(step(kTwoDrivers + drivers)), ElementsAre(0, 1, 2));
  EXPECT_EQ(step(kTwoDrivers + drivers).state(2, 1).profile.position, -29);  // its pose is at -31 mm; 1 mm/s
  EXPECT_TRUE(
      lines_are(lines(DriverSchedule::step(read(kTwoDrivers + drivers + "duration = 3\n"))),
                {"test.toml:21:12: drivers.b.duration differs from that of another driver: all move in the "
                 "same time; give it to one, or the same to all"}));
}

TEST(StepSchedule, EndsWithTheLastLaw) {
  const std::string laws =
      "[laws]\nlong.segments = [{ over = 5, law = \"uniform\", rise = 8 }]\n"
      "short.segments = [{ over = 3, law = \"uniform\", rise = 8 }]\n";
  for (const char* of_a : {"long", "short"}) {
    const std::string of_b = of_a == std::string("long") ? "short" : "long";
    const std::string drivers =
        fmt::format("[drivers.a]\njoint = \"one\"\nlaw = \"{}\"\ntime_step = 1\n", of_a) +
        fmt::format("[drivers.b]\njoint = \"two\"\nlaw = \"{}\"\n", of_b);
    EXPECT_THAT(times(step(kTwoDrivers + drivers + laws)), ElementsAre(0, 1, 2, 3, 4, 5));
  }
}

TEST(RowPath, ThroughListedPositionsHasKnotsWhereTheDriverTurnsBack) {
  const double degree = kPi / 180;
  // After a pause as well.
  EXPECT_THAT(path_of(analyze(crank_profile("positions = [0, 30, 30, 10]\n"))).path.knots,
              ElementsAre(0, DoubleNear(30 * degree, 1e-15), DoubleNear(50 * degree, 1e-15)));
  EXPECT_THAT(path_of(analyze(crank_profile("positions = [0, 30, 30, 40]\n"))).path.knots,
              ElementsAre(0, DoubleNear(40 * degree, 1e-15)));
}

TEST(RowPath, OfSeveralDriversHasKnotsWhereOneDoesNotGoOnAsItCame) {
  const auto knots = [](const std::string& of_b) {
    const std::string drivers =
        "[drivers.a]\njoint = \"one\"\npositions = [0, 0.1, 0.2, 0.3, 0.4]\n"
        "[drivers.b]\njoint = \"two\"\npositions = " +
        of_b + "\n";
    return path_of(analyze(kTwoDrivers + drivers)).path.knots;
  };
  EXPECT_THAT(knots("[0, 0.7, 1.4, 2.1, 2.8]"), ElementsAre(0, 4));
  EXPECT_THAT(knots("[0, 0.7, 1.4, 2.1, 2.0]"), ElementsAre(0, 3, 4));
}

TEST(OneWay, IsHowASingleDriverGoesBetweenRows) {
  EXPECT_TRUE(analyze(crank_profile(), 100).is_one_way(0, 99));
  const DriverSchedule back = step(crank_profile("velocity = 30\nacceleration = -10\nduration = 6\n"), 13);
  EXPECT_TRUE(back.is_one_way(0, 6));  // turns back at 3 s, in row 6
  EXPECT_TRUE(back.is_one_way(6, 12));
  EXPECT_FALSE(back.is_one_way(5, 7));
  EXPECT_FALSE(back.is_one_way(0, 12));
  const DriverSchedule listed = analyze(crank_profile("positions = [1, 3, 3, 7, 2, -1, 0]\n"));
  EXPECT_TRUE(listed.is_one_way(0, 3));
  EXPECT_TRUE(listed.is_one_way(3, 5));
  EXPECT_FALSE(listed.is_one_way(2, 4));
  EXPECT_FALSE(listed.is_one_way(4, 6));
}

TEST(OneWay, IsNotAskedOfSeveralDrivers) {
  const std::string drivers =
      "[drivers.a]\njoint = \"one\"\nend = 20\n[drivers.b]\njoint = \"two\"\nend = 30\n";
  EXPECT_FALSE(analyze(kTwoDrivers + drivers, 5).is_one_way(0, 4));
}

TEST(DriverSchedule, ErrorsNameTheSettingThatTheValueComesFrom) {
  const auto place = [](const testing::Overrides& overrides) {
    const auto schedule = DriverSchedule::step(
        testing::read(testing::crank_profile("duration = 1\ntime_step = 1\n"), overrides));
    return schedule ? "" : to_string(schedule.error().front());
  };
  EXPECT_THAT(
      place({"driver.velocity=1e12", "driver.duration=1e9"}),
      ::testing::StartsWith("override driver.duration=1e9: driver.duration takes the driver over more"));
  EXPECT_THAT(place({"driver.velocity=1e12"}),
              ::testing::StartsWith("test.toml:12:12: driver.duration takes the driver over more"));
}

}  // namespace
}  // namespace higherpair
