// The size of a mechanism has no influence: scaled by 1e-6 and 1e6 it has the same events at the same
// positions.

#include "analysis/mechanism_builder.hpp"
#include "analysis/run_testing.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <gtest/gtest.h>

namespace higherpair {
namespace {

Mechanism scaled(Mechanism mechanism, double scale) {
  for (Body& body : mechanism.bodies) {
    body.guess_p_WB *= scale;
    for (NamedPoint& point : body.points) point.p_B *= scale;
    for (NamedCurve& named : body.curves) {
      named.curve.vertex_B *= scale;
      named.curve.semi_latus *= scale;
    }
  }
  return mechanism;
}

std::vector<RunEvent> events_over(const Mechanism& mechanism, const std::vector<double>& positions) {
  auto run = start_run(mechanism, {positions.front()});
  EXPECT_TRUE(run) << (run ? "" : run.error().reason);
  std::vector<RunEvent> events;
  for (const double position : positions) {
    if (run) {
      move_to(*run, {{position, 1, 0}});
      events.insert(events.end(), run->events.begin(), run->events.end());
    }
  }
  return events;
}

// Positions from `from` to `to` in `count` equal steps.
std::vector<double> steps(double from, double to, int count) {
  std::vector<double> positions;
  for (int i = 0; i <= count; ++i) positions.push_back(from + (to - from) * i / count);
  return positions;
}

// A block slides along y = d and turns a crank about the origin by a slot; the crank drives a parallelogram,
// whose branches cross where the crank lies along its frame: with the slot at 1.2 rad.
struct SlottedParallelogram {
  explicit SlottedParallelogram(double scale) {
    const double x = -0.5 * d * scale;
    const Vector2d O = Vector2d::Zero();
    const Vector2d P(x, d * scale);
    const Vector2d D(0.1 * scale, 0);
    const double slot = angle_of(P);
    const Vector2d A = 0.04 * scale * unit_vector(slot - 1.2);
    const int block = builder.body("block", P, 0);
    const int crank = builder.body("crank", O, slot);
    const int coupler = builder.body("coupler", A, 0);
    const int rocker = builder.body("rocker", D, slot - 1.2);
    builder.drive(builder.prismatic(0, block, P, Vector2d::UnitX(), x + 2 * d * scale));
    (void)builder.revolute(0, crank, O);
    (void)builder.slot(crank, block, P, P.normalized(), P.norm());
    (void)builder.revolute(crank, coupler, A);
    (void)builder.revolute(coupler, rocker, A + D);
    (void)builder.revolute(0, rocker, D);
  }

  static constexpr double d = 0.07;
  testing::Builder builder;
};

TEST(Scale, MovesNoDeadPointOfADriverThatSlides) {
  const double d = SlottedParallelogram::d;
  const double wanted = 2 * d + d / std::tan(1.2);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (const int count : {5, 12}) {
      const SlottedParallelogram mechanism(scale);
      const auto events =
          events_over(mechanism.builder.mechanism, steps(1.5 * d * scale, 3.1 * d * scale, count));
      ASSERT_EQ(events.size(), 1U) << scale;
      EXPECT_EQ(events[0].type, EventType::kDeadPoint);
      EXPECT_LE(std::abs(events[0].driver / scale - wanted), 1e-12 * wanted) << scale << " " << count;
    }
  }
}

TEST(ScaledProfiles, HaveTheSameEvents) {
  for (const char* name : {"parallelogram", "four_bar", "slider_crank", "double_rocker", "lock_up",
                           "quick_return", "flat_faced_translating", "eccentric_disc_oscillating_roller",
                           "ellipse_cam_roller", "knife_edge", "oval_in_ring", "disc_in_ring", "parabola_cam",
                           "hyperbola_cam", "toggle_press", "rolling_ellipses"}) {
    SCOPED_TRACE(name);
    const Profile profile = testing::shipped(name);
    const DriverSchedule schedule = DriverSchedule::analyze(profile).value();
    std::vector<double> positions;
    for (std::int64_t k = 0; k < schedule.size(); ++k) positions.push_back(schedule.state(k, 0).si.position);
    const bool slides = !has_angle(profile.mechanism.joints[profile.mechanism.drivers.front().joint].type);
    const auto wanted = events_over(profile.mechanism, positions);
    for (const double scale : {1e-6, 1e6}) {
      std::vector<double> moved = positions;
      for (double& position : moved) position *= slides ? scale : 1;
      const auto events = events_over(scaled(profile.mechanism, scale), moved);
      ASSERT_EQ(events.size(), wanted.size()) << scale;
      for (std::size_t i = 0; i < events.size(); ++i) {
        EXPECT_EQ(events[i].type, wanted[i].type);
        EXPECT_EQ(events[i].joint, wanted[i].joint);
        EXPECT_EQ(events[i].contact, wanted[i].contact);
        const double driver = events[i].driver / (slides ? scale : 1);
        EXPECT_LE(std::abs(driver - wanted[i].driver), 1e-12 * (1 + std::abs(wanted[i].driver)))
            << scale << ": " << events[i].cause;
      }
    }
  }
}

}  // namespace
}  // namespace higherpair
