// Several drivers in time move along the curve that their motions make together, whatever the rows are.
#include "analysis/run_testing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace higherpair {
namespace {

using namespace higherpair::testing;

constexpr std::array kRows{2, 3, 4, 7, 13, 61, 361};

Motion in_time(const Profile& profile, int rows) {
  RunSettings settings;
  settings.in_time = true;
  settings.samples = rows;
  auto model = Model::from(profile.mechanism, profile.units, profile.programs);
  if (!model) {
    throw std::runtime_error(to_string(model.error()));
  }
  return *model->run(settings);
}

std::vector<double> times_of(const Motion& motion, EventType type) {
  std::vector<double> times;
  for (const Event& event : motion.events()) {
    if (event.type == type) {
      times.push_back(*event.time);
    }
  }
  return times;
}

void expect_times(const Motion& motion, EventType type, const std::vector<double>& wanted) {
  const std::vector<double> times = times_of(motion, type);
  ASSERT_EQ(times.size(), wanted.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(times[i], wanted[i], 1e-11);
  }
}

// Two blocks on slides at right angles, at (x, 0) and (0, y), joined by links of 100 and 50 mm. The links
// reach from 50 mm on.
std::string two_slides(const std::string& x, const std::string& y) {
  return fmt::format(R"(
    [bodies.ground]
    points.O = [0, 0]
    [bodies.a]
    pose = {{ x = 100 }}
    points.A = [0, 0]
    [bodies.b]
    points.B = [0, 0]
    [bodies.p]
    pose = {{ x = 100, angle = 120 }}
    points.A = [0, 0]
    points.C = [100, 0]
    [bodies.q]
    pose = {{ angle = 60 }}
    points.B = [0, 0]
    points.C = [50, 0]
    [joints]
    x = {{ type = "prismatic", between = ["ground.O", "a.A"], direction = 0 }}
    y = {{ type = "prismatic", between = ["ground.O", "b.B"], direction = 90 }}
    pa = {{ type = "revolute", between = ["a.A", "p.A"] }}
    qb = {{ type = "revolute", between = ["b.B", "q.B"] }}
    c = {{ type = "revolute", between = ["p.C", "q.C"] }}
    [drivers.x]
    joint = "x"
    {}
    [drivers.y]
    joint = "y"
    duration = 1
    time_step = 0.1
    {}
  )",
                     x, y);
}

// x = 100 (1 - t)^2 and y = 100 t^2: with t = 1/2 + u, x^2 + y^2 = 10^4 (1/8 + 3 u^2 + 2 u^4), which is 50^2
// where u^2 = (sqrt(10) - 3)/4.
TEST(DriversInTime, LimitsOfAcceleratedDrivers) {
  const std::string text =
      two_slides("start = 100\nvelocity = -200\nacceleration = 200", "velocity = 0\nacceleration = 200");
  const double u = std::sqrt((std::sqrt(10.0) - 3) / 4);
  const Motion fine = in_time(profile_of(text), 361);
  const auto angle = fine.column("p.angle");
  for (const int rows : kRows) {
    SCOPED_TRACE(rows);
    const Motion motion = in_time(profile_of(text), rows);
    EXPECT_FALSE(motion.good());
    expect_times(motion, EventType::kLimitPosition, {0.5 - u, 0.5 + u});
    for (int k = 0; k < rows; ++k) {
      const double t = k / (rows - 1.0);
      const bool within = std::abs(t - 0.5) < u;
      EXPECT_EQ(motion.statuses()[k], within ? RowStatus::kNotAssemblable : RowStatus::kOk) << t;
      if (!within && 360 % (rows - 1) == 0) {
        EXPECT_NEAR(motion.column("p.angle")[k], angle[k * 360 / (rows - 1)], 1e-9) << t;
      }
    }
  }
}

// The time at which f changes its sign.
template <class F>
double zero_of(const F& f, double low, double high) {
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (f(low) * f(middle) <= 0 ? high : low) = middle;
  }
  return low;
}

// The velocity of x jumps at t = 0.5, from -90 to -310 mm/s, before the links come into line.
TEST(DriversInTime, LimitsBeyondAJumpOfALaw) {
  const std::string text =
      two_slides("law = \"feed\"", "velocity = 0\nacceleration = 200") +
      "[laws.feed]\nstart = 100\nsegments = [{ over = 0.5, law = \"uniform\", rise = -45 }, "
      "{ over = 0.5, law = \"uniform\", rise = -155 }]\n";
  const auto beyond_reach = [](double t) { return std::hypot(55 - 310 * (t - 0.5), 100 * t * t) - 50; };
  const double closest = 0.62;
  ASSERT_LT(beyond_reach(closest), 0);
  const double lost = zero_of(beyond_reach, 0.5, closest), found = zero_of(beyond_reach, closest, 1);
  for (const int rows : kRows) {
    SCOPED_TRACE(rows);
    const Motion motion = in_time(profile_of(text), rows);
    expect_times(motion, EventType::kLimitPosition, {lost, found});
    expect_times(motion, EventType::kLawJump, {0.5});
  }
}

// A parallelogram whose crank turns faster from where its links lie on one line, while a block slides.
TEST(DriversInTime, AJumpOfALawAtAChangePoint) {
  const std::string text = R"(
    [bodies.ground]
    points.O = [0, 0]
    points.Q = [100, 0]
    [bodies.left]
    pose = { angle = 60 }
    points.O = [0, 0]
    points.A = [40, 0]
    [bodies.coupler]
    pose = { x = 20, y = 34.6 }
    points.A = [0, 0]
    points.B = [100, 0]
    [bodies.right]
    pose = { x = 100, angle = 60 }
    points.Q = [0, 0]
    points.B = [40, 0]
    [bodies.block]
    points.P = [0, 0]
    [joints]
    crank = { type = "revolute", between = ["ground.O", "left.O"] }
    a = { type = "revolute", between = ["left.A", "coupler.A"] }
    b = { type = "revolute", between = ["coupler.B", "right.B"] }
    rocker = { type = "revolute", between = ["ground.Q", "right.Q"] }
    guide = { type = "prismatic", between = ["ground.O", "block.P"], direction = 30 }
    [laws.turn]
    start = 60
    segments = [{ over = 1, law = "uniform", rise = 120 }, { over = 1, law = "uniform", rise = 220 }]
    [drivers.turn]
    joint = "crank"
    law = "turn"
    [drivers.block]
    joint = "guide"
    velocity = 10
    acceleration = -8
  )";
  for (const int rows : kRows) {
    SCOPED_TRACE(rows);
    const Motion motion = in_time(profile_of(text), rows);
    expect_times(motion, EventType::kDeadPoint, {1, 1 + 180.0 / 220});
    for (int k = 0; k < rows; ++k) {
      EXPECT_NEAR(motion.column("coupler.angle")[k], 0, 1e-6) << k;
    }
  }
}

// Type and item of the events, and their times; some are at the same time.
std::vector<std::pair<std::string, double>> by_item(const Motion& motion) {
  std::vector<std::pair<std::string, double>> events;
  for (const Event& event : motion.events()) {
    events.emplace_back(std::string(name_of(event.type)) + " " + event.item, *event.time);
  }
  std::sort(events.begin(), events.end());
  return events;
}

// A mechanism with one driver, which is followed by the coordinate of that, has the same events when a block
// on an accelerated slide is beside it and both are followed by the time.
TEST(DriversInTime, ABlockThatSlidesByItselfChangesNoEvent) {
  for (const char* name : {"cam_chain", "four_arc_cam", "geneva_six_slots", "groove_cam", "involute_pair",
                           "lock_up", "oval_in_ring", "parallelogram", "start_stop_crank", "toggle_press"}) {
    SCOPED_TRACE(name);
    Profile alone = shipped(name);
    DriverProgram& driver = alone.programs.front();
    driver.duration = driver.duration.value_or(1.3);
    driver.time_step = 0.1;
    driver.velocity = driver.velocity == 1 ? 200 : driver.velocity;
    Profile both = alone;
    Mechanism& mechanism = both.mechanism;
    const int block = add_body(mechanism, "block_beside", {0, 0.003});
    const PointRef rail = add_point(mechanism, kGround, "rail_of_block", {0, 0.003});
    const PointRef on_block = add_point(mechanism, block, "P", Vector2d::Zero());
    mechanism.drivers.front().name = "main";
    (void)add_driver(mechanism, add_prismatic(mechanism, "guide_of_block", rail, on_block, Vector2d::UnitX()),
                     "block");
    DriverProgram accelerated;
    accelerated.velocity = 3;
    accelerated.acceleration = -2;
    both.programs.push_back(accelerated);
    for (const int rows : {2, 61}) {
      const Motion one = in_time(alone, rows), two = in_time(both, rows);
      EXPECT_EQ(one.good(), two.good());
      const auto wanted = by_item(one), found = by_item(two);
      ASSERT_EQ(found.size(), wanted.size());
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_EQ(found[i].first, wanted[i].first);
        EXPECT_NEAR(found[i].second, wanted[i].second, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace higherpair
