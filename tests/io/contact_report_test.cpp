#include "higherpair/io/contact_report.hpp"

#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <atomic>
#include <cmath>
#include <regex>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::Overrides;

constexpr double kDegrees = 180 / kPi;

Profile shipped(const std::string& name, const Overrides& overrides = {}) {
  return read_profile_file(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + name + ".toml", overrides)
      .value();
}

ContactForceReport report(const Profile& profile, std::optional<std::int64_t> samples = std::nullopt) {
  const DriverSchedule schedule = DriverSchedule::analyze(profile, samples).value();
  return report_contacts(profile, schedule, start_run(profile.mechanism, schedule.first_positions()).value());
}

Overrides at_900_rpm(const Overrides& more = {}) {
  Overrides overrides{"driver.velocity=\"900 rpm\""};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}

// N = 10.943 N - (m e w² - k e) sin θ, see the profile.
double opening_at(double rpm) {
  const double w = rpm * 2 * kPi / 60;
  return std::asin(10.943 / (0.003 * w * w - 8)) * 180 / kPi;
}

double lowest_at(double rpm) {
  const double w = rpm * 2 * kPi / 60;
  return 18.943 - 0.003 * w * w;
}

TEST(ContactForceReport, IsTheSameForAnyNumberOfRows) {
  const Profile profile = shipped("cam_with_return_spring", at_900_rpm());
  const ContactForceReport expected = report(profile);
  ASSERT_EQ(expected.openings.size(), 1U);
  EXPECT_NEAR(kDegrees * expected.openings[0].what.driver, opening_at(900), 1e-12);
  EXPECT_NEAR(expected.openings[0].row, opening_at(900), 1e-11);
  EXPECT_NEAR(expected.lowest[0]->force, lowest_at(900), 1e-12);
  EXPECT_NEAR(kDegrees * expected.lowest[0]->driver, 90, 1e-10);
  EXPECT_NEAR(expected.highest_speed.value() * 900, std::sqrt(18.943 / 0.003) * 60 / (2 * kPi), 1e-9);
  for (const int samples : {2, 3, 37, 3601}) {
    const ContactForceReport other = report(profile, samples);
    ASSERT_EQ(other.openings.size(), 1U);
    EXPECT_NEAR(kDegrees * other.openings[0].what.driver, kDegrees * expected.openings[0].what.driver, 1e-12);
    EXPECT_NEAR(other.openings[0].row * 360 / (samples - 1), opening_at(900), 1e-11);
    EXPECT_EQ(other.openings[0].cause, expected.openings[0].cause);
    EXPECT_NEAR(other.lowest[0]->force, expected.lowest[0]->force, 1e-12);
  }
}

TEST(ContactForceReport, OfListedPositionsIsThatOfTheWayThroughThem) {
  Profile profile = shipped("cam_with_return_spring", {"driver.velocity=\"900 rpm\""});
  for (DriverProgram& program : profile.programs) {
    program.positions = {0, 10, 11, 200, 200, 360};
    program.samples.reset();
  }
  const ContactForceReport there = report(profile);
  ASSERT_EQ(there.openings.size(), 1U);
  EXPECT_NEAR(kDegrees * there.openings[0].what.driver, opening_at(900), 1e-12);
  EXPECT_NEAR(there.openings[0].row, 2 + (opening_at(900) - 11) / 189, 1e-12);
  // On the way there and back it opens from both sides.
  profile.programs[0].positions = {0, 180, 0};
  const ContactForceReport back = report(profile);
  ASSERT_EQ(back.openings.size(), 2U);
  EXPECT_NEAR(kDegrees * back.openings[0].what.driver, opening_at(900), 1e-12);
  EXPECT_NEAR(kDegrees * back.openings[1].what.driver, 180 - opening_at(900), 1e-12);
  EXPECT_NEAR(back.openings[1].row, 1 + opening_at(900) / 180, 1e-12);
  profile.programs[0].positions = {90};
  EXPECT_TRUE(contains(report(profile).openings.at(0).cause, "here already"));
}

// The driver turns back at 180 degrees. With its acceleration -a the follower's is -e (ω² sin θ + a cos θ).
TEST(ContactForceReport, OfARunInTimeHasTheSpeedOfEveryMoment) {
  const Profile profile = shipped(
      "cam_with_return_spring",
      {"driver.velocity=6000", "driver.acceleration=-1e5", "driver.duration=0.12", "driver.time_step=0.017"});
  const DriverSchedule schedule = DriverSchedule::step(profile).value();
  const higherpair::Run start = start_run(profile.mechanism, schedule.first_positions()).value();
  const ContactForceReport timed = report_contacts(profile, schedule, start);
  const auto N = [](double t) {
    const double theta = (6e3 * t - 5e4 * t * t) / kDegrees, w = (6e3 - 1e5 * t) / kDegrees,
                 a = -1e5 / kDegrees;
    return 10.943 + 8 * std::sin(theta) + 0.003 * (a * std::cos(theta) - w * w * std::sin(theta));
  };
  // On the way there and on the way back.
  ASSERT_EQ(timed.openings.size(), 2U);
  for (const ContactForceReport::Opening& opening : timed.openings) {
    const double t = opening.what.at;
    EXPECT_NEAR(N(t), 0, 1e-10);
    EXPECT_GT(N(t - 1e-5), 0);
    EXPECT_NEAR(opening.row, t < 0.119 ? t / 0.017 : 7 + (t - 0.119) / 0.001, 1e-9);
    EXPECT_NEAR(kDegrees * opening.what.driver, 6e3 * t - 5e4 * t * t, 1e-9);
  }
}

TEST(ContactForceReport, AdvisesAFreeLengthThatIsRoundedToTheSafeSide) {
  for (const double rpm : {800.0, 900.0, 1000.0, 1234.5}) {
    const std::string speed = fmt::format("driver.velocity=\"{} rpm\"", rpm);
    const ContactForceReport opened = report(shipped("cam_with_return_spring", {speed}), 3);
    ASSERT_EQ(opened.openings.size(), 1U);
    std::smatch match;
    const std::string cause = opened.openings[0].cause;
    ASSERT_TRUE(std::regex_search(
        cause, match,
        std::regex(
            "; every contact stays closed on the whole path if springs.return pushes by ([0-9.]+) N more "
            "\\(free_length ([0-9.]+) mm instead of 80 mm\\)$")))
        << cause;
    const double push = std::stod(match[1]), free = std::stod(match[2]);
    EXPECT_GE(push, -lowest_at(rpm));
    EXPECT_LE(push, -lowest_at(rpm) * (1 + 2e-5));
    EXPECT_GE(free, 80 - lowest_at(rpm) / 0.8);
    EXPECT_LE(free, 80 - lowest_at(rpm) / 0.8 + 2e-4);
    const auto with = [&](double length) {
      return report(
          shipped("cam_with_return_spring", {speed, fmt::format("springs.return.free_length={}", length)}));
    };
    EXPECT_TRUE(with(free).openings.empty());
    EXPECT_FALSE(with(free - 2e-4).openings.empty());
  }
}

TEST(ContactForceReport, AdvisesAnEffortWhereThereIsNoSpring) {
  Profile profile = shipped("cam_with_return_spring", at_900_rpm());
  profile.mechanism.springs.clear();
  const double missing = 0.003 * std::pow(30 * kPi, 2) - 2.943;
  const ContactForceReport opened = report(profile, 2);
  ASSERT_EQ(opened.openings.size(), 1U);
  EXPECT_TRUE(contains(opened.openings[0].cause,
                       "; every contact stays closed on the whole path if a constant force of -" +
                           fmt::format("{:.2f}", missing)));
  EXPECT_TRUE(contains(opened.openings[0].cause, " N acts on joints.guide"));
}

// Two arms in series. A torsion spring on the second one presses the second contact and lifts the first.
Overrides arms(double first, double second) {
  return {"bodies.arm.mass=0.3",
          "bodies.arm.center_of_mass=[0, 0]",
          "bodies.arm.inertia=200",
          "bodies.second_arm.mass=0.2",
          "bodies.second_arm.center_of_mass=[20, 0]",
          "bodies.second_arm.inertia=100",
          "driver.velocity=\"12 rad/s\"",
          "driver.acceleration=0",
          fmt::format("springs.one={{ joint = \"arm_pivot\", stiffness = {}, free_angle = 0 }}", first),
          fmt::format("springs.two={{ joint = \"second_pivot\", stiffness = 10, free_angle = {} }}", second)};
}

TEST(ContactForceReport, OfAChainGivesOneAnswerForItsSpringsOrSaysThatThereIsNone) {
  bool advised = false;
  for (const double first : {0.0, 5.0, 40.0}) {
    for (const double second : {-300.0, 0.0, 300.0}) {
      const ContactForceReport opened = report(shipped("cam_chain", arms(first, second)), 5);
      for (const ContactForceReport::Opening& opening : opened.openings) {
        EXPECT_FALSE(contains(opening.cause, "acts on joints"));
        EXPECT_EQ(opening.cause.substr(opening.cause.find(';')),
                  opened.openings[0].cause.substr(opened.openings[0].cause.find(';')));
        if (opening.cause.find("; no preload of") != std::string::npos) {
          continue;
        }
        advised = true;
        Overrides changed = arms(first, second);
        const std::regex number(
            "springs\\.(\\w+) turns by [0-9.]+ N\\*mm more towards (?:smaller|larger) "
            "coordinates \\(free_angle (-?[0-9.]+) deg instead of");
        const std::sregex_iterator begin(opening.cause.begin(), opening.cause.end(), number), end;
        EXPECT_NE(begin, end) << opening.cause;
        for (std::sregex_iterator i = begin; i != end; ++i) {
          changed.push_back("springs." + (*i)[1].str() + ".free_angle=" + (*i)[2].str());
        }
        EXPECT_TRUE(report(shipped("cam_chain", changed)).openings.empty()) << opening.cause;
      }
    }
  }
  EXPECT_TRUE(advised);
}

TEST(ContactForceReport, EndsEarlyWhereItIsWantedNoLonger) {
  const Profile profile = shipped("cam_with_return_spring", at_900_rpm({"driver.end=1e9"}));
  const DriverSchedule schedule = DriverSchedule::analyze(profile, 2).value();
  const std::atomic<bool> stop = true;
  higherpair::Run run = start_run(profile.mechanism, schedule.first_positions()).value();
  run.stop = &stop;
  (void)report_contacts(profile, schedule, run);  // which would take hours
}

std::string sentence(const Preload& preload, double addition) {
  Profile profile = shipped("cam_with_return_spring");
  Spring line = profile.mechanism.springs.front();
  line.name = "line";
  line.stiffness = 2000;
  line.free = 0.04;
  Spring slide = line;
  slide.name = "slide";
  slide.joint = 1;
  Spring pivot = line;
  pivot.name = "pivot";
  pivot.joint = 0;
  pivot.stiffness = 2e-3 * 180 / kPi;
  pivot.free = 40 * kPi / 180;
  profile.mechanism.springs = {line, slide, pivot};
  return describe(preload, addition, profile);
}

TEST(Preloads, AreDescribedBySpringsInTheProfilesUnits) {
  using On = Preload::On;
  EXPECT_EQ(sentence({On::kSpring, 0}, 3),
            "springs.line pulls by 3 N more (free_length 38.5 mm instead of 40 mm)");
  EXPECT_EQ(sentence({On::kSpring, 0}, -3),
            "springs.line pushes by 3 N more (free_length 41.5 mm instead of 40 mm)");
  EXPECT_EQ(
      sentence({On::kSpring, 1}, 90),
      "springs.slide pushes by 90 N more towards smaller coordinates (free_length -5 mm instead of 40 mm)");
  EXPECT_EQ(
      sentence({On::kSpring, 2}, -0.004),
      "springs.pivot turns by 4 N*mm more towards larger coordinates (free_angle 42 deg instead of 40 deg)");
  EXPECT_EQ(sentence({On::kJoint, 1}, -3), "a constant force of -3 N acts on joints.guide");
  EXPECT_EQ(sentence({On::kJoint, 0}, 0.3), "a constant torque of 300 N*mm acts on joints.cam_pivot");
  EXPECT_EQ(sentence({On::kJoint, 1}, 1.23456001), "a constant force of 1.23457 N acts on joints.guide");
}

}  // namespace
}  // namespace higherpair
