#include "higherpair/analysis/jerk.hpp"

#include "analysis/run_testing.hpp"
#include "contact/pair_jerk.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "io/cam_lever_tappet.hpp"
#include "io/profile_testing.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::shipped;

// A four-bar whose coupler drives a slider through a rod, and a lever whose slot takes the crank's pin.
constexpr const char* kLinkages = R"(
[bodies.ground]
points = { A = [0, 0], D = [90, 0], S = [0, 0], G = [-60, -80] }
[bodies.crank]
points = { A = [0, 0], B = [30, 0] }
[bodies.coupler]
pose   = { x = 26, y = 14, angle = 40 }
points = { B = [0, 0], C = [80, 0], E = [40, 35] }
[bodies.rocker]
pose   = { x = 90, y = 0, angle = 92 }
points = { D = [0, 0], C = [60, 0] }
[bodies.rod]
pose   = { x = 34, y = 67, angle = -42 }
points = { E = [0, 0], F = [100, 0] }
[bodies.slider]
pose   = { x = 108, y = 0 }
points.F = [0, 0]
[bodies.lever]
pose   = { x = -60, y = -80, angle = 48 }
points = { G = [0, 0] }
[joints]
a = { type = "revolute", between = ["ground.A", "crank.A"] }
b = { type = "revolute", between = ["crank.B", "coupler.B"] }
c = { type = "revolute", between = ["coupler.C", "rocker.C"] }
d = { type = "revolute", between = ["ground.D", "rocker.D"] }
e = { type = "revolute", between = ["coupler.E", "rod.E"] }
f = { type = "revolute", between = ["rod.F", "slider.F"] }
s = { type = "prismatic", between = ["ground.S", "slider.F"], direction = [1, 0] }
g = { type = "revolute", between = ["ground.G", "lever.G"] }
h = { type = "slot", between = ["lever.G", "crank.B"], direction = [1, 0] }
[driver]
joint = "a"
)";

// A driven slide turns a crank through a rod.
constexpr const char* kDrivenSlide = R"(
units = { length = "m", angle = "rad" }
[bodies.ground]
points = { S = [0, 0], D = [1, 1.5] }
[bodies.slider]
points.P = [0, 0]
[bodies.rod]
pose   = { x = 0, y = 0, angle = 1.6 }
points = { P = [0, 0], C = [2, 0] }
[bodies.crank]
pose   = { x = 1, y = 1.5, angle = 2.8 }
points = { D = [0, 0], C = [1.5, 0] }
[joints]
s = { type = "prismatic", between = ["ground.S", "slider.P"], direction = [0.8, -0.6] }
p = { type = "revolute", between = ["slider.P", "rod.P"] }
c = { type = "revolute", between = ["rod.C", "crank.C"] }
d = { type = "revolute", between = ["ground.D", "crank.D"] }
[driver]
joint = "s"
start = 0
end = 1
)";

std::vector<Profile> profiles() {
  std::vector<Profile> all = {testing::read(kLinkages), testing::read(testing::kCamLeverTappet),
                              testing::read(kDrivenSlide)};
  for (const char* name : {"ellipse_cam_roller", "eccentric_disc_oscillating_roller",
                           "flat_faced_oscillating", "flat_faced_translating", "knife_edge",
                           "offset_translating_roller", "conic_by_coefficients", "rolling_ellipses"}) {
    all.push_back(shipped(name));
  }
  return all;
}

Run run_at(const Profile& profile, double u) {
  Run run = start_run(profile.mechanism, {0}).value();
  move_to(run, {{u, 1, 0.5}});
  EXPECT_EQ(run.row.status, RowStatus::kOk) << profile.mechanism.title;
  return run;
}

// Central differences of a_x, a_y, α over time for the driver's motion u + t + t²/4.
Eigen::Vector3d slope(const Run& at, double u, std::size_t body, double h) {
  const auto acceleration = [&](double t) {
    Run run = at;
    move_to(run, {{u + t + t * t / 4, 1 + t / 2, 0.5}});
    const BodyMotion& motion = run.row.bodies[body];
    return Eigen::Vector3d(motion.a_WB.x(), motion.a_WB.y(), motion.alpha);
  };
  return (8 * (acceleration(h) - acceleration(-h)) - (acceleration(2 * h) - acceleration(-2 * h))) / (12 * h);
}

TEST(JerksOfARun, AreTheDifferencesOfItsAccelerations) {
  for (const Profile& profile : profiles()) {
    for (const double u : {0.4, 1.1}) {
      const higherpair::Run run = run_at(profile, u);
      const JerkRow jerks = jerks_of(run);
      for (std::size_t i = 1; i < jerks.bodies.size(); ++i) {
        ASSERT_TRUE(jerks.bodies[i]) << profile.mechanism.title << profile.mechanism.bodies[i].name;
        const Eigen::Vector3d jerk(jerks.bodies[i]->j_WB.x(), jerks.bodies[i]->j_WB.y(),
                                   jerks.bodies[i]->angular);
        const Eigen::Vector3d wide = slope(run, u, i, 4e-3);
        const Eigen::Vector3d narrow = slope(run, u, i, 2e-3);
        const Eigen::Vector3d value = (16 * narrow - wide) / 15;
        // The rounding of accelerations divided by the step.
        const double tolerance = (narrow - wide).norm() + 1e-9 * (1 + value.norm());
        EXPECT_LE((jerk - value).norm(), tolerance)
            << profile.mechanism.title << ' ' << profile.mechanism.bodies[i].name << " at " << u;
      }
    }
  }
}

// The mechanism in its present position with its conics replaced by their circles of curvature.
Mechanism with_circles(const Run& run) {
  Mechanism mechanism = run.mechanism();
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    mechanism.bodies[i].guess_p_WB = run.row.bodies[i].X_WB.p_WB;
    mechanism.bodies[i].guess_theta = run.row.bodies[i].theta;
  }
  const auto replace = [&](const CurveRef& ref, const Vector2d& p_W, const Vector2d& n_W, double rho) {
    const auto body = static_cast<std::size_t>(ref.body);
    Curve& curve = mechanism.bodies[body].curves[ref.curve].curve;
    if (is_conic(curve)) {
      const Vector2d center_B = run.row.bodies[body].X_WB.inverse_times(p_W - rho * n_W);
      curve = make_circle(center_B, std::abs(rho), rho > 0 ? Side::kInside : Side::kOutside).value();
    }
  };
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    const CommonNormal& at = run.row.contacts[i].at;
    replace(mechanism.contacts[i].first, at.p1_W, at.n_W, at.rho1);
    replace(mechanism.contacts[i].second, at.p2_W, -at.n_W, at.rho2);
  }
  return mechanism;
}

TEST(JerksOfARun, OfTheFrozenLinkageAreThoseOfCirclesOfCurvature) {
  for (const Profile& profile : {testing::read(testing::kCamLeverTappet), shipped("ellipse_cam_roller")}) {
    const double u = 0.9;
    const higherpair::Run run = run_at(profile, u);
    const JerkRow jerks = jerks_of(run);
    higherpair::Run circles = start_run(with_circles(run), {u}).value();
    move_to(circles, {{u, 1, 0.5}});
    const JerkRow expected = jerks_of(circles);
    const std::size_t last = jerks.bodies.size() - 1;
    ASSERT_TRUE(jerks.linkage[last] && expected.bodies[last]);
    const double scale = 1e-9 * (1 + jerks.linkage[last]->j_WB.norm());
    EXPECT_LE((jerks.linkage[last]->j_WB - expected.bodies[last]->j_WB).norm(), scale);
    EXPECT_LE(std::abs(jerks.linkage[last]->angular - expected.bodies[last]->angular), 1e-9);
    // A body whose origin is on a pivot has no jerk of the origin.
    EXPECT_GT((jerks.linkage[last]->j_WB - jerks.bodies[last]->j_WB).norm() +
                  std::abs(jerks.linkage[last]->angular - jerks.bodies[last]->angular),
              1e-4);
  }
}

TEST(JerksOfARun, OfARollingPairAreThoseOfThePair) {
  higherpair::Run run = start_run(shipped("rolling_ellipses").mechanism, {0}).value();
  move_to(run, {{0.8, 3, 0}});
  const JerkRow jerks = jerks_of(run);
  const auto* track = std::get_if<RollingTrack>(&run.at.state.tracks.back());
  ASSERT_NE(track, nullptr);
  const PairJerk pair = rolling_jerk(track->pair, track->at);
  ASSERT_TRUE(jerks.bodies.back() && jerks.linkage.back() && pair.linkage_d3q);
  EXPECT_LE(std::abs(jerks.bodies.back()->angular - 27 * pair.d3q), 1e-10);
  EXPECT_LE(std::abs(jerks.linkage.back()->angular - 27 * *pair.linkage_d3q), 1e-10);
}

// The jerk of bodies on ground joints has a closed form; it is compared with the general method, power series
// of all conditions.
TEST(JerksOfARun, OfCamsInClosedFormAreThoseOfPowerSeries) {
  std::vector<Profile> all = profiles();
  for (const char* name : {"spline_cam", "law_cam_flat", "law_cam_roller", "four_arc_cam", "tangent_cam",
                           "geneva_four_slots", "groove_cam", "disc_in_ring", "valve_train"}) {
    all.push_back(shipped(name));
  }
  const std::vector<HigherRates> higher{{0.7, 0, 0, 0}};
  for (const Profile& profile : all) {
    higherpair::Run run = start_run(profile.mechanism, {0}).value();
    for (const double u : {0.4, 1.1, 2.3}) {
      move_to(run, {{u, 1.3, 0.5}});
      if (run.row.status != RowStatus::kOk) {
        continue;
      }
      const auto bodies = true_jerks_of(run, higher);
      const auto expected = jerks_of(run, higher).bodies;
      for (std::size_t i = 1; i < bodies.size(); ++i) {
        const std::string where = profile.mechanism.title + ' ' + profile.mechanism.bodies[i].name;
        ASSERT_EQ(bodies[i].has_value(), expected[i].has_value()) << where;
        if (bodies[i]) {
          EXPECT_LE((bodies[i]->j_WB - expected[i]->j_WB).norm(), 1e-9 * (1 + expected[i]->j_WB.norm()))
              << where;
          EXPECT_NEAR(bodies[i]->angular, expected[i]->angular, 1e-9 * (1 + std::abs(expected[i]->angular)))
              << where << " at " << u;
        }
      }
    }
  }
}

TEST(JerksOfARun, AreMissingWhereTheRowIs) {
  higherpair::Run run = start_run(shipped("lock_up").mechanism, {0}).value();
  move_to(run, {{kPi, 1, 0}});
  ASSERT_EQ(run.row.status, RowStatus::kNotAssemblable);
  for (const auto& jerk : jerks_of(run).bodies) {
    EXPECT_FALSE(jerk);
  }
}

}  // namespace
}  // namespace higherpair
