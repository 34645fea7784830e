// Schedules of drivers that follow a law.
#include "higherpair/io/driver_schedule.hpp"
#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::crank_profile;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::read;
using testing::slider_profile;

std::string slider(const std::string& driver, const std::string& law) {
  return slider_profile("law = \"lift\"\n" + driver + "[laws.lift]\n" + law);
}

// A rise of 8 mm with constant acceleration and deceleration, a dwell, and a return with constant velocity.
const std::string kLaw =
    "segments = [{ over = 2, law = \"parabolic\", rise = 8 }, { over = 1, law = \"dwell\" }, { over = 2, law "
    "= "
    "\"uniform\", rise = -4 }]\n";

std::string error_of(const tl::expected<DriverSchedule, Diagnostics>& schedule) {
  return schedule ? "none" : to_string(schedule.error().front());
}

TEST(LawSchedule, StepsTakeTheLawAsItIs) {
  const auto schedule = DriverSchedule::step(read(slider("time_step = 0.5\n", kLaw))).value();
  ASSERT_EQ(schedule.size(), 11);  // up to the end of the law
  EXPECT_TRUE(schedule.is_timed());
  std::vector<double> positions, velocities, accelerations;
  for (std::int64_t k = 0; k < schedule.size(); ++k) {
    const DriverState state = schedule.state(k);
    positions.push_back(state.profile.position);
    velocities.push_back(state.profile.velocity);
    accelerations.push_back(state.profile.acceleration);
    EXPECT_EQ(state.si.position, state.profile.position / 1000);
  }
  EXPECT_THAT(positions, ElementsAre(0, 1, 4, 7, 8, 8, 8, 7, 6, 5, 4));
  // At the joins 1, 2 and 3 the values after them; in the last row the values before its end.
  EXPECT_THAT(velocities, ElementsAre(0, 4, 8, 4, 0, 0, -2, -2, -2, -2, -2));
  EXPECT_THAT(accelerations, ElementsAre(8, 8, -8, -8, 0, 0, 0, 0, 0, 0, 0));
}

TEST(LawSchedule, AnalyzeIsOverTheWholeLaw) {
  const Profile profile = read(slider("samples = 6\n", kLaw));
  const auto schedule = DriverSchedule::analyze(profile).value();
  ASSERT_EQ(schedule.size(), 6);
  EXPECT_EQ(schedule.time(1), 1);
  EXPECT_EQ(schedule.state(1).profile.position, 4);
  EXPECT_EQ(schedule.state(4).profile.velocity, -2);
  EXPECT_EQ(DriverSchedule::analyze(profile, 11)->size(), 11);
  EXPECT_EQ(DriverSchedule::analyze(read(slider("", kLaw)))->size(), kDefaultSamples);
  EXPECT_EQ(DriverSchedule::step(profile)->size(), 6);
  EXPECT_EQ(
      DriverSchedule::step(read(slider("duration = 10\nsamples = 3\n", kLaw)))->state(1).profile.position, 4);
}

TEST(LawSchedule, KnowsWhereTheDriverTurnsBack) {
  const auto schedule =
      DriverSchedule::step(
          read(
              slider("time_step = 5\nduration = 5\n",
                     "segments = [{ over = 2, law = \"cycloidal\", rise = 8 }, { over = 1, law = "
                     "\"dwell\" }, { over = 2, law = \"polynomial\", start = [8, 0], end = [8, 0, -3] }]\n")))
          .value();
  const auto points = schedule.turning_points(1);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_THAT(points[0].share, ::testing::AllOf(::testing::Ge(0.4 - 1e-6), ::testing::Le(0.6 + 1e-6)));
  EXPECT_NEAR(points[0].si.position, 0.008, 1e-15);
  EXPECT_GT(points[1].share, 0.6);
  EXPECT_EQ(points[1].si.velocity, 0);
}

TEST(LawSchedule, NamesWhenTheDriverPassesAPlace) {
  const auto schedule = DriverSchedule::step(read(slider("time_step = 5\n", kLaw))).value();
  EXPECT_NEAR(schedule.passing_time(1, 4, 0.2), 1, 1e-12);
  EXPECT_NEAR(schedule.passing_time(1, 7, 0.3), 1.5, 1e-12);
  EXPECT_NEAR(schedule.passing_time(1, 7, 0.7), 3.5, 1e-12);
}

TEST(LawSchedule, ReportsJumps) {
  const auto schedule = DriverSchedule::step(read(slider("time_step = 1\nduration = 6\n", kLaw))).value();
  std::vector<double> times;
  for (std::int64_t k = 0; k < schedule.size(); ++k) {
    for (const auto& jump : schedule.law_jumps(k)) {
      times.push_back(jump.time);
      EXPECT_EQ(k, std::ceil(jump.time));
    }
  }
  EXPECT_THAT(times, ElementsAre(1, 2, 3, 5));
  const auto jumps = schedule.law_jumps(3);
  ASSERT_EQ(jumps.size(), 1U);
  EXPECT_EQ(jumps[0].position, 8);
  EXPECT_EQ(jumps[0].join.before[1], 0);
  EXPECT_EQ(jumps[0].join.after[1], -2);
  // There is no jump at the end of the run.
  const auto whole = DriverSchedule::step(read(slider("time_step = 1\n", kLaw))).value();
  EXPECT_THAT(whole.law_jumps(5), IsEmpty());
  EXPECT_THAT(whole.breaks(), ElementsAre(1, 2, 3));
}

TEST(LawSchedule, RepetitionsJumpAgain) {
  const auto schedule =
      DriverSchedule::step(
          read(slider("time_step = 10\nduration = 10\n",
                      "repeat = true\nsegments = [{ over = 2, law = \"uniform\", rise = 8 }, { over = 2, "
                      "law = \"uniform\", rise = -8 }]\n")))
          .value();
  std::vector<double> times;
  for (const auto& jump : schedule.law_jumps(1)) times.push_back(jump.time);
  EXPECT_THAT(times, ElementsAre(2, 4, 6, 8));
  EXPECT_EQ(schedule.turning_points(1).size(), 4U);
}

// Between two rows the driver goes there and back any number of times.
TEST(LawSchedule, KnowsItsWholeTravelAndItsGreatestSpeed) {
  const std::string law =
      "repeat = true\nsegments = [{ over = 2, law = \"cycloidal\", rise = 8 }, "
      "{ over = 4, law = \"uniform\", rise = -8 }]\n";
  const auto schedule = DriverSchedule::step(read(slider("time_step = 14\nduration = 14\n", law))).value();
  EXPECT_NEAR(schedule.travel(0), 0.040, 1e-15);
  // Twice the mean, in the middle of the rise; all rows are at rest or on the way back.
  EXPECT_NEAR(schedule.greatest_speed(0), 0.008, 1e-15);
  const auto many = DriverSchedule::step(read(slider("time_step = 1e7\nduration = 1e8\n", law)));
  ASSERT_FALSE(many);
  EXPECT_TRUE(
      contains(to_string(many.error().front()),
               "driver.duration takes the driver through 1.66667e+07 repetitions of laws.lift; at most 1e6"));
}

TEST(LawSchedule, GivesHigherDerivatives) {
  const auto schedule =
      DriverSchedule::step(read(crank_profile("law = \"lift\"\ntime_step = 1\n[laws.lift]\nsegments = [{ "
                                              "over = 2, law = \"cycloidal\", rise = 360 }]\n")))
          .value();
  const DriverState state = schedule.state(1);
  // j = h/T³ 4π² cos 2πu, snap = 0, and so on, in the middle
  EXPECT_NEAR(state.higher_si[0], -2 * kPi / 8 * 4 * kPi * kPi, 1e-12);
  EXPECT_NEAR(state.higher_si[1], 0, 1e-11);
  EXPECT_NEAR(state.higher_si[2], 2 * kPi / 32 * std::pow(2 * kPi, 4), 1e-9);
}

TEST(LawSchedule, ListedPositionsHaveTheRatesOfTheirFirstTime) {
  Profile profile = read(slider("", kLaw));
  profile.programs[0].positions = {4, 7, 0, 8};
  const auto schedule = DriverSchedule::analyze(profile).value();
  EXPECT_FALSE(schedule.is_timed());
  EXPECT_EQ(schedule.state(0).profile.position, 4);
  EXPECT_NEAR(schedule.state(0).profile.velocity, 8, 1e-12);
  EXPECT_NEAR(schedule.state(1).profile.velocity, 4, 1e-12);
  EXPECT_EQ(schedule.state(3).profile.velocity, 0);
  profile.programs[0].positions = {9};
  EXPECT_EQ(error_of(DriverSchedule::analyze(profile)),
            "test.toml:13:7: driver.law laws.lift does not come to 9");
}

TEST(LawSchedule, RefusesWhatHasNoMeaning) {
  EXPECT_TRUE(contains(error_of(DriverSchedule::analyze(read(slider(
                           "", "origin = -9\nsegments = [{ over = 2, law = \"uniform\", rise = 8 }]\n")))),
                       "driver.law laws.lift ends at -7, before time 0: nothing moves"));
  const std::string two = R"([bodies.ground]
points.A = [0, 0]
[bodies.a]
points.A = [0, 0]
points.P = [10, 0]
[bodies.b]
pose = { x = 10 }
points.P = [0, 0]
[joints.one]
type = "revolute"
between = ["ground.A", "a.A"]
[joints.two]
type = "revolute"
between = ["a.P", "b.P"]
[laws.lift]
segments = [{ over = 2, law = "uniform", rise = 8 }]
[drivers.one]
joint = "one"
law = "lift"
samples = 5
[drivers.two]
joint = "two"
)";
  EXPECT_TRUE(contains(
      error_of(DriverSchedule::analyze(read(two + "positions = [1, 2]\n"))),
      "drivers.two.positions have no meaning here: another driver follows a law, and all move in time"));
  EXPECT_TRUE(contains(error_of(DriverSchedule::analyze(read(two + "samples = 6\n"))),
                       "drivers.two.samples differs from that of another driver: all have the same rows"));
  const auto both = DriverSchedule::analyze(read(two + "start = 1\nvelocity = 3\n")).value();
  ASSERT_EQ(both.size(), 5);
  EXPECT_EQ(both.state(4, 0).profile.position, 8);
  EXPECT_EQ(both.state(4, 1).profile.position, 7);
}

}  // namespace
}  // namespace higherpair
