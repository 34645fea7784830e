// Motions whose driver follows a law.
#include "cam_profile.hpp"
#include "higherpair/front/model.hpp"
#include "linkage/slider_crank_profile.hpp"
#include "sliding_cam.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using testing::model_of;
using testing::motion_of;

using ::testing::ElementsAre;

// A slider-crank whose crank's driver follows a law; or the slide alone, with a mass.
const std::string kLawCrank =
    testing::slider_crank_profile(31, 87, "mass = 2\ncenter_of_mass = [0, 0]") + R"([driver]
joint = "main"
law = "turn"
)";

RunSettings in_time() {
  RunSettings settings;
  settings.in_time = true;
  return settings;
}

RunSettings at(const std::vector<double>& positions) {
  RunSettings settings;
  settings.positions = positions;
  return settings;
}

// Each column is the derivative of the one before, by five-point differences over closely spaced rows.
TEST(LawDriver, EveryRateIsTheDerivativeOfTheOneBefore) {
  const Model model =
      model_of(kLawCrank +
               "duration = 0.4\ntime_step = 0.0001\n[laws.turn]\norigin = -0.1\nsegments = [{ over = "
               "1, law = \"polynomial-4567\", rise = 300 }]\n");
  const Motion motion = [&] {
    RunSettings settings = in_time();
    settings.jerk = true;
    settings.derivatives = 6;
    return motion_of(model, settings);
  }();
  EXPECT_TRUE(motion.good());
  const double h = 0.0001;
  const std::vector<std::vector<std::string>> chains = {
      {"driver", "driver.velocity", "driver.acceleration", "driver.jerk"},
      {"piston.x", "piston.vx", "piston.ax", "piston.jx", "piston.d4x", "piston.d5x", "piston.d6x"},
      {"crank.angle", "crank.omega", "crank.alpha", "crank.d3angle", "crank.d4angle", "crank.d5angle",
       "crank.d6angle"},
      {"piston.ax", "piston.d3x"},
      {"rod.alpha", "rod.jerk"},
  };
  for (const auto& chain : chains) {
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
      const ColumnValues f = motion.column(chain[k]);
      const ColumnValues df = motion.column(chain[k + 1]);
      double largest = 0, error = 0;
      for (std::size_t i = 2; i + 2 < motion.size(); i += 7) {
        const double slope = (8 * (f[i + 1] - f[i - 1]) - (f[i + 2] - f[i - 2])) / (12 * h);
        largest = std::max(largest, std::abs(df[i]));
        error = std::max(error, std::abs(df[i] - slope));
      }
      EXPECT_LT(error, 1e-7 * largest) << chain[k + 1];
    }
  }
}

TEST(LawDriver, ReportsJumpsOfVelocityAndAcceleration) {
  const Model model =
      model_of(kLawCrank +
               "time_step = 0.25\n[laws.turn]\nsegments = [{ over = 1, law = \"parabolic\", rise = 90 "
               "}, { over = 0.5, law = \"dwell\" }, { over = 0.6, law = \"uniform\", rise = 30 }]\n");
  const Motion motion = motion_of(model, in_time());
  EXPECT_TRUE(motion.good());
  std::vector<double> times;
  std::vector<std::string> causes;
  std::vector<std::int64_t> rows;
  for (const Event& event : motion.events()) {
    if (event.type == EventType::kLawJump) {
      times.push_back(event.time.value());
      causes.push_back(event.cause);
      rows.push_back(event.row);
      EXPECT_EQ(event.item, "main");
      EXPECT_EQ(name_of(event.type), "law_jump");
    }
  }
  EXPECT_THAT(times, ElementsAre(0.5, 1, 1.5));
  EXPECT_THAT(rows, ElementsAre(2, 4, 6));
  EXPECT_EQ(causes[0],
            "laws.turn: acceleration jumps from 360 to -360 deg/s^2; a row there shows what is after it");
  EXPECT_EQ(causes[2], "laws.turn: velocity jumps from 0 to 50 deg/s; a row there shows what is after it");
  const ColumnValues acceleration = motion.column("driver.acceleration");
  EXPECT_EQ(acceleration[1], 360);
  EXPECT_EQ(acceleration[2], -360);
  EXPECT_NEAR(motion.column("driver.velocity")[6], 50, 1e-12);
  EXPECT_NEAR(motion.column("driver.velocity")[motion.size() - 1], 50, 1e-12);
}

// A jump of the velocity at 1 s of a run of 9 rows from 0 to 3 s: on the path from 0.75 to 1.125 s.
TEST(LawDriver, SaysWhereBetweenTheRowsItJumps) {
  const Model model = model_of(R"(
[bodies.ground]
points.O = [0, 0]
[bodies.slide]
points.S = [0, 0]
[joints]
guide = { type = "prismatic", between = ["ground.O", "slide.S"], direction = [1, 0] }
[laws.go]
segments = [{ over = 1, law = "uniform", rise = 10 }, { over = 2, law = "uniform", rise = -5 }]
[driver]
joint = "guide"
law = "go"
samples = 9
)");
  for (const bool in_time : {false, true}) {
    RunSettings settings;
    settings.in_time = in_time;
    const Motion motion = motion_of(model, settings);
    int jumps = 0;
    for (const Event& event : motion.events()) {
      if (event.type != EventType::kLawJump) continue;
      ++jumps;
      EXPECT_EQ(event.row, 3);
      EXPECT_NEAR(event.share, 2.0 / 3, 1e-12);
      EXPECT_NEAR(event.time.value(), 1, 1e-12);
    }
    EXPECT_EQ(jumps, 1);
  }
}

// With two rows the same events are found as with many: the driver turns back twice between them.
TEST(LawDriver, EventsDoNotDependOnTheRows) {
  const std::string law =
      "[laws.turn]\nrepeat = true\nsegments = [{ over = 1, law = \"cycloidal\", rise = 200 }, { over = 1, "
      "law = "
      "\"polynomial-345\", rise = -200 }]\n";
  const auto ends_of_stroke = [&](const std::string& step) {
    std::vector<double> times;
    const Model model = model_of(kLawCrank + "duration = 4\ntime_step = " + step + "\n" + law);
    const Motion motion = motion_of(model, in_time());
    for (const Event& event : motion.events()) {
      if (event.type == EventType::kStrokeEnd) times.push_back(*event.time);
    }
    return times;
  };
  const std::vector<double> few = ends_of_stroke("4");
  const std::vector<double> many = ends_of_stroke("0.01");
  ASSERT_EQ(few.size(), many.size());
  ASSERT_GE(few.size(), 4U);  // at 180 degrees, forward and back, twice
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_NEAR(few[i], many[i], 1e-6);
  }
}

TEST(LawDriver, AnalyzeIsStepOverTheWholeLaw) {
  const Model model = model_of(
      kLawCrank + "samples = 11\n[laws.turn]\nsegments = [{ over = 2, law = \"harmonic\", rise = 90 }]\n");
  const Motion analyzed = motion_of(model);
  const Motion stepped = motion_of(model, in_time());
  ASSERT_EQ(analyzed.size(), 11U);
  ASSERT_EQ(stepped.size(), 11U);
  EXPECT_EQ(stepped.columns().front().name, "time");
  EXPECT_EQ(analyzed.columns().front().name, "driver");
  for (const char* column : {"driver", "piston.x", "piston.ax"}) {
    for (std::size_t k = 0; k < 11; ++k) EXPECT_EQ(analyzed.column(column)[k], stepped.column(column)[k]);
  }
}

// A slide is driven against its inertia m a only.
TEST(LawDriver, ForcesInTimeAreThoseOfTheAcceleration) {
  const std::string text = R"(
[bodies.ground]
points.O = [0, 0]
[bodies.slide]
points.S = [0, 0]
mass = 12
center_of_mass = [0, 0]
[joints]
guide = { type = "prismatic", between = ["ground.O", "slide.S"], direction = [1, 0] }
[laws.feed]
segments = [{ over = 0.3, law = "modified-sine", rise = 80 }, { over = 0.1, law = "dwell" }]
[driver]
joint = "guide"
law = "feed"
time_step = 0.01
)";
  const Motion motion = [&] {
    RunSettings settings = in_time();
    settings.forces = true;
    return motion_of(model_of(text), settings);
  }();
  const ColumnValues effort = motion.column("driver.effort");
  const ColumnValues acceleration = motion.column("driver.acceleration");
  ASSERT_EQ(motion.size(), 41U);
  double largest = 0;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    EXPECT_NEAR(effort[k], 12e-3 * acceleration[k], 1e-10);
    largest = std::max(largest, effort[k]);
  }
  EXPECT_NEAR(largest, 12 * 5.527957 * 0.08 / 0.09, 1);
}

// A disc lifts a follower with a mass by a law in time; the follower is thrown off where the deceleration
// exceeds gravity. This is found between two rows, and with a dwell in the law.
TEST(LawDriver, ContactsOpenWhereTheLawThrowsThemOff) {
  const std::string text = R"(gravity = [0, -9810]
[bodies.ground]
points.O = [0, 0]
[bodies.table]
points.O = [0, 0]
curves.top = { type = "line", point = [0, 0], normal = [0, 1] }
[bodies.load]
points.P = [0, 0]
curves.foot = { type = "circle", center = [0, 5], radius = 5 }
mass = 1
center_of_mass = [0, 0]
[joints]
lift  = { type = "prismatic", between = ["ground.O", "table.O"], direction = [0, 1] }
guide = { type = "prismatic", between = ["ground.O", "load.P"], direction = [0, 1] }
[contacts.rest]
between = ["table.top", "load.foot"]
[driver]
joint = "lift"
law = "up"
time_step = 0.2
[laws.up]
segments = [{ over = 0.1, law = "dwell" }, { over = 0.1, law = "harmonic", rise = 25 }]
)";
  const Motion motion = [&] {
    RunSettings settings = in_time();
    settings.forces = true;
    return motion_of(model_of(text), settings);
  }();
  EXPECT_FALSE(motion.good());
  std::vector<double> places;
  for (const Event& event : motion.events()) {
    if (event.type == EventType::kContactOpen) places.push_back(event.driver);
  }
  // a = h/2 (π/T)² cos πu = -g
  const double a = 12.5 * std::pow(kPi / 0.1, 2);
  const double u = std::acos(-9810 / a) / kPi;
  ASSERT_EQ(places.size(), 1U);
  EXPECT_NEAR(places[0], 12.5 * (1 - std::cos(kPi * u)), 1e-8);
}

TEST(LawDriver, APositionByItselfHasTheRatesOfTheLaw) {
  const Model model =
      model_of(kLawCrank + "[laws.turn]\nsegments = [{ over = 2, law = \"parabolic\", rise = 90 }]\n");
  const Motion motion = motion_of(model, at({45, 0}));
  EXPECT_NEAR(motion.column("driver.velocity")[0], 90, 1e-9);
  EXPECT_EQ(motion.column("driver.velocity")[1], 0);
  const auto beyond = model.run(at({91}));
  ASSERT_FALSE(beyond);
  EXPECT_TRUE(contains(to_string(beyond.error()), "driver.law laws.turn does not come to 91"));
}

// Rounding of the slide's point does not become the size of the mechanism: its rows are those without it.
TEST(LawDriver, ASlideHasTheSizeOfItsMotion) {
  const auto rows_with = [](const std::string& x) {
    const Model model = testing::shipped_model("law_driven_slider", {"bodies.slide.points.S.0=" + x});
    EXPECT_TRUE(model.start()) << x << to_string(model.start().error());
    return motion_of(model, in_time());
  };
  const Motion exact = rows_with("0");
  for (const char* x : {"-1e-6", "-1e-5", "1e-4"}) {
    const Motion rounded = rows_with(x);
    EXPECT_TRUE(rounded.good());
    EXPECT_THAT(rounded.column("slide.vx").values,
                ::testing::ElementsAreArray(exact.column("slide.vx").values))
        << x;
  }
}

TEST(LawDriver, OtherUnitsThanTheProfilesAreThoseOfTheTable) {
  const Model model = model_of(kLawCrank +
                               "samples = 3\n[laws.turn]\nsegments = [{ over = 2, law = \"parabolic\", rise "
                               "= 90 }, { over = 1, law = \"dwell\" }]\n");
  const Motion motion = [&] {
    RunSettings settings = in_time();
    settings.jerk = true;
    settings.units = kSiUnits;
    return motion_of(model, settings);
  }();
  EXPECT_NEAR(motion.column("driver.acceleration")[0], kPi / 2, 1e-14);
  EXPECT_EQ(motion.column("driver.jerk")[0], 0);
  bool found = false;
  for (const Event& event : motion.events()) {
    found = found || event.cause.find("from 1.5708 to -1.5708 rad/s^2") != std::string::npos;
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace higherpair
