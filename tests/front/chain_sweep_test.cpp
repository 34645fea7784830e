// Sweeps of linkages: variants whose rows are proven in closed form give the same results as variants that
// are read and followed. The reference is the same sweep with counts of events, which only a run can give.
#include "front/cam_profile.hpp"
#include "higherpair/higherpair.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::model_of;

std::string shipped_text(const std::string& name) {
  std::ifstream file(HIGHERPAIR_SOURCE_DIR "/profiles/" + name + ".toml");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

SweepBlock all_of(const Sweep& sweep) {
  SweepBlock all;
  for (std::int64_t number = 0; number < sweep.blocks(); ++number) {
    const SweepBlock block = sweep.block(number);
    all.good += block.good;
    all.variants += block.variants;
    all.values.insert(all.values.end(), block.values.begin(), block.values.end());
    all.causes.insert(all.causes.end(), block.causes.begin(), block.causes.end());
  }
  return all;
}

struct Sweeps {
  SweepBlock plain, followed;
  std::vector<Column> columns;           // of the plain sweep
  std::vector<Column> followed_columns;  // with the counts of events
};

Sweeps sweeps_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> counted = overrides;
  counted.emplace_back("sweep.counts=true");
  const auto plain = Sweep::of(model_of(text, overrides));
  const auto followed = Sweep::of(model_of(text, counted));
  if (!plain || !followed) {
    ADD_FAILURE() << to_string(plain ? followed.error() : plain.error());
    return {};
  }
  return {all_of(*plain), all_of(*followed), plain->columns(), followed->columns()};
}

std::size_t slot_of(const std::vector<Column>& columns, const std::string& name) {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.name == name; });
  return static_cast<std::size_t>(found - columns.begin());
}

// Numbers agree to 1e-12 of the largest in their column; statuses, causes and undefined values are the same.
void expect_same(const Sweeps& sweeps) {
  ASSERT_EQ(sweeps.plain.variants, sweeps.followed.variants);
  EXPECT_EQ(sweeps.plain.good, sweeps.followed.good);
  EXPECT_EQ(sweeps.plain.causes, sweeps.followed.causes);
  for (std::size_t i = 0; i < sweeps.columns.size(); ++i) {
    const std::string& name = sweeps.columns[i].name;
    const std::size_t other = slot_of(sweeps.followed_columns, name);
    ASSERT_LT(other, sweeps.followed_columns.size()) << name;
    double largest = 0;
    double error = 0;
    for (std::size_t k = 0; k < sweeps.plain.causes.size(); ++k) {
      const double a = sweeps.plain.values[k * sweeps.columns.size() + i];
      const double b = sweeps.followed.values[k * sweeps.followed_columns.size() + other];
      ASSERT_EQ(std::isnan(a), std::isnan(b)) << name << " of variant " << k;
      if (!std::isnan(a)) {
        largest = std::max(largest, std::abs(b));
        error = std::max(error, std::abs(a - b));
      }
    }
    EXPECT_LE(error, 1e-12 * largest) << name;
  }
}

constexpr const char* kFourBar = R"(
[sweep]
method = "random"
count  = 400
seed   = 3
[sweep.variables]
crank   = { path = "bodies.crank.points.A.0", min = 1.5, max = 2.5 }
coupler = { path = "bodies.coupler.points.B.0", min = 3, max = 4 }
rocker  = { path = ["bodies.rocker.points.B.0", "bodies.rocker.points.B.1"], min = 1.5, max = 3.2 }
frame   = { path = "bodies.ground.points.O4.0", min = 0.5, max = 1.5 }
trace   = { path = "bodies.coupler.points.E.1", normal = [1, 0.1] }
[sweep.results]
most    = { column = "rocker.angle", of = "max", where = true }
least   = { column = "rocker.angle", of = "min", where = true }
swing   = { column = "rocker.angle", of = "range" }
fastest = { column = "rocker.omega", of = "maxabs", where = true }
high    = { column = "coupler.E.y", of = "max", where = true }
mean    = { column = "coupler.E.x", of = "mean" }
rms     = { column = "coupler.E.vy", of = "rms" }
first   = { column = "coupler.x", of = "first", where = true }
last    = { column = "rocker.alpha", of = "last" }
at      = { column = "coupler.E.ax", of = "at", at = 90 }
none    = { column = "crank.angle", of = "max" }
pin     = { column = "rocker_pivot.acceleration", of = "min" }
)";

TEST(ChainSweep, FourBarsComeOutAsFollowedOnesAlsoWhereTheyDoNotTurnFully) {
  const Sweeps sweeps = sweeps_of(shipped_text("four_bar") + kFourBar);
  expect_same(sweeps);
  EXPECT_GT(sweeps.plain.good, 100);
  EXPECT_LT(sweeps.plain.good, 390);
}

TEST(ChainSweep, UnitsAreThoseOfTheProfile) {
  expect_same(sweeps_of(shipped_text("four_bar") + kFourBar,
                        {"units.length=\"in\"", "units.angle=\"rad\"", "driver.start=0.1", "driver.end=6.3",
                         "sweep.count=60", "sweep.results.at.at=0.1"}));
}

TEST(ChainSweep, RunsInTimeAreThoseOfTheDriversLaw) {
  expect_same(
      sweeps_of(shipped_text("four_bar") + kFourBar,
                {"sweep.time=true", "sweep.count=40", "driver.acceleration=15", "sweep.results.at.at=0.3"}));
  // The driver turns back between two rows.
  expect_same(sweeps_of(shipped_text("four_bar") + kFourBar,
                        {"sweep.time=true", "sweep.count=20", "driver.velocity=100",
                         "driver.acceleration=-190", "sweep.results.at.at=0.3"}));
}

TEST(ChainSweep, SixBarsSlidersAndSlottedLeversComeOutAsFollowedOnes) {
  expect_same(sweeps_of(shipped_text("watt_sixbar") + R"(
[sweep]
method = "sobol"
count  = 60
[sweep.variables]
b = { path = "bodies.link2.points.B.0", min = 37, max = 43 }
c = { path = "bodies.link3.points.C.0", min = 95, max = 105 }
h = { path = "bodies.link4.points.H.1", min = 50, max = 70 }
f = { path = "bodies.ground.points.F.0", min = 260, max = 300 }
[sweep.results]
swing = { column = "link6.angle", of = "range" }
peak  = { column = "link6.alpha", of = "maxabs", where = true }
place = { column = "link5.D.x", of = "min", where = true }
)",
                        {"driver.samples=361"}));
  expect_same(sweeps_of(shipped_text("slider_crank") + R"(
[sweep]
method = "random"
count  = 60
[sweep.variables]
r = { path = "bodies.crank.points.A.0", min = 1, max = 4.5 }
l = { path = "bodies.rod.points.B.0", min = 4, max = 6 }
o = { path = "bodies.ground.points.rail.1", min = 0, max = 2 }
[sweep.results]
stroke = { column = "piston.x", of = "range" }
peak   = { column = "piston.ax", of = "maxabs", where = true }
tilt   = { column = "piston.angle", of = "max" }
)",
                        {"driver.samples=181"}));
  expect_same(sweeps_of(shipped_text("quick_return") + R"(
[sweep]
method = "grid"
[sweep.variables]
p = { path = "bodies.crank.points.P.0", values = [30, 40, 50, 88, 90, 95] }
h = { path = "bodies.ground.points.O2.1", values = [85, 90, 100] }
[sweep.results]
swing = { column = "lever.angle", of = "range" }
tip   = { column = "lever.T.vx", of = "min", where = true }
)"));
}

TEST(ChainSweep, ForcesOfLinkagesComeOutAsFollowedOnes) {
  const Sweeps watt = sweeps_of(shipped_text("watt_sixbar_forces") + R"(
[sweep]
method = "sobol"
count  = 40
[sweep.variables]
b = { path = "bodies.crank.points.B.0", min = 37, max = 46 }
c = { path = "bodies.coupler.points.C.0", min = 95, max = 105 }
f = { path = "bodies.ground.points.F.0", min = 260, max = 300 }
[sweep.results]
torque = { column = "driver.effort", of = "maxabs", where = true }
check  = { column = "driver.effort_check", of = "rms" }
pin    = { column = "D.fx", of = "min", where = true }
foot   = { column = "F.fy", of = "at", at = 181 }
swing  = { column = "rocker.angle", of = "range" }
)",
                                {"driver.samples=181"});
  expect_same(watt);
  EXPECT_GT(watt.plain.good, 5);
  const std::string press = R"(
[loads]
gas = { body = "piston", force = [-300, 0], point = "B" }
[springs]
back = { between = ["ground.O2", "piston.B"], stiffness = 40, free_length = 10, damping = 3 }
[sweep]
method = "random"
count  = 40
[sweep.variables]
r = { path = "bodies.crank.points.A.0", min = 1.5, max = 2.5 }
g = { path = "loads.gas.force.0", min = -400, max = -100 }
k = { path = "springs.back.stiffness", min = 10, max = 80 }
[sweep.results]
torque = { column = "driver.effort", of = "max", where = true }
side   = { column = "slide.fy", of = "range" }
none   = { column = "slide.fx", of = "max" }
tilt   = { column = "slide.m", of = "maxabs" }
)";
  expect_same(sweeps_of(shipped_text("slider_crank") + press, {"driver.samples=91"}));
}

// A load acts at a point whose coordinates vary: more than this coordinate is set then.
TEST(ChainSweep, LoadsGoWithTheirPoints) {
  expect_same(sweeps_of(shipped_text("watt_sixbar_forces") + R"(
[sweep]
method = "random"
count  = 20
[sweep.variables]
g = { path = "bodies.coupler.points.G.0", min = 40, max = 60 }
m = { path = "bodies.rocker.mass", min = 0.1, max = 0.2 }
[sweep.results]
torque = { column = "driver.effort", of = "max" }
)",
                        {"driver.samples=61"}));
}

TEST(ChainSweep, WhatAPathSetsBesidesAPlaceIsNotLost) {
  // The start is the slide's coordinate in the poses, which depends on its points.
  expect_same(sweeps_of(R"(
bodies.ground.points = { O = [0, 0], Q = [40, 0] }
[bodies.slider]
points.P = [0, 0]
points.A = [10, 5]
[bodies.link]
pose = { x = 12, y = 6, angle = 10 }
points.A = [0, 0]
points.B = [30, 0]
[bodies.rocker]
pose = { x = 40, y = 0, angle = 90 }
points.O = [0, 0]
points.B = [25, 0]
[joints]
slide = { type = "prismatic", between = ["ground.O", "slider.P"], direction = 0 }
a     = { type = "revolute", between = ["slider.A", "link.A"] }
b     = { type = "revolute", between = ["link.B", "rocker.B"] }
o     = { type = "revolute", between = ["ground.Q", "rocker.O"] }
[driver]
joint = "slide"
end   = 6
samples = 50
[sweep]
method = "grid"
[sweep.variables]
p = { path = "bodies.slider.points.P.0", min = -2, max = 2, count = 5 }
[sweep.results]
swing = { column = "rocker.angle", of = "range" }
last  = { column = "slider.x", of = "last" }
)"));
}

TEST(ChainSweep, DiscsAndOvalsThatTouchComeOutAsFollowedOnes) {
  const Sweeps discs = sweeps_of(shipped_text("eccentric_disc_oscillating_roller") + R"(
[sweep]
method = "sobol"
count  = 16
[sweep.variables]
e = { path = "bodies.cam.curves.disc.center.0", min = 12, max = 17 }
r = { path = "bodies.follower.curves.roller.radius", min = 13, max = 17 }
a = { path = "bodies.follower.curves.roller.center.0", min = -62, max = -58 }
[sweep.results]
swing = { column = "follower.angle", of = "range" }
peak  = { column = "follower.alpha", of = "maxabs", where = true }
pin   = { column = "follower_pivot.velocity", of = "min" }
most  = { column = "touch.pressure", of = "max", where = true }
)",
                                 {"driver.samples=91"});
  expect_same(discs);
  EXPECT_GT(discs.plain.good, 4);
  EXPECT_LT(discs.plain.good, 16);
  const Sweeps ovals = sweeps_of(shipped_text("ellipse_cam_roller") + R"(
[sweep]
method = "sobol"
count  = 40
[sweep.variables]
a = { path = "bodies.cam.curves.oval.semi_axes.0", min = 15, max = 60 }
t = { path = "bodies.cam.curves.oval.rotation", min = -20, max = 20 }
x = { path = "bodies.follower.curves.roller.center.0", min = -67, max = -60 }
[sweep.results]
swing = { column = "follower.angle", of = "range" }
peak  = { column = "follower.alpha", of = "maxabs", where = true }
mean  = { column = "touch.pressure", of = "mean" }
)",
                                 {"driver.samples=361"});
  expect_same(ovals);
  EXPECT_GT(ovals.plain.good, 30);
}

// In some variants the contact opens: the spring is too weak for the inertia of the arm.
TEST(ChainSweep, ForcesOfContactsComeOutAsFollowedOnes) {
  const std::string arm = R"(
[springs]
back = { joint = "follower_pivot", stiffness = 900, free_angle = 0, damping = 2 }
[sweep]
method = "sobol"
count  = 24
[sweep.variables]
m = { path = "bodies.follower.mass", min = 0.1, max = 0.3 }
k = { path = "springs.back.stiffness", min = 20, max = 500 }
[sweep.results]
press  = { column = "touch.force", of = "max", where = true }
least  = { column = "touch.force", of = "min" }
torque = { column = "driver.effort", of = "maxabs" }
check  = { column = "driver.effort_check", of = "rms" }
pin    = { column = "follower_pivot.fx", of = "min", where = true }
crank  = { column = "cam_pivot.fy", of = "at", at = 36 }
)";
  const std::vector<std::string> settings{
      "driver.samples=91", "driver.velocity=\"1000 rpm\"", "bodies.follower.mass=0.2",
      "bodies.follower.center_of_mass=[-40, 3]", "bodies.follower.inertia=50"};
  for (const std::string profile : {"eccentric_disc_oscillating_roller", "ellipse_cam_roller"}) {
    SCOPED_TRACE(profile);
    const Sweeps sweeps = sweeps_of(shipped_text(profile) + arm, settings);
    expect_same(sweeps);
    EXPECT_GT(sweeps.plain.good, 4);
    EXPECT_LT(sweeps.plain.good, 24);
  }
}

// Loads, angles and lengths other than points' coordinates: such variants are read, but need not be followed.
TEST(ChainSweep, AnyNumberOfABodyMayVary) {
  expect_same(sweeps_of(shipped_text("slider_crank") + R"(
[sweep]
method = "random"
count  = 30
[sweep.variables]
r = { path = "bodies.crank.points.A.0", min = 1.8, max = 2.2 }
p = { path = "bodies.rod.pose.angle", min = 14, max = 54 }
[sweep.results]
stroke = { column = "piston.x", of = "range" }
tilt   = { column = "piston.angle", of = "max" }
)"));
}

TEST(ChainSweep, TighterTolerancesAreRunAsBefore) {
  SweepSettings settings;
  settings.tolerance = 1e-15;
  const Model model = model_of(shipped_text("four_bar") + kFourBar, {"sweep.count=30"});
  const auto sweep = Sweep::of(model, settings);
  ASSERT_TRUE(sweep);
  EXPECT_LT(all_of(*sweep).good, 30);
}

}  // namespace
}  // namespace higherpair
