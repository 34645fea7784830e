#include "geometry/geometry_testing.hpp"
#include "higherpair/analysis/jerk.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/cam/flank.hpp"
#include "higherpair/mechanism/boundaries.hpp"
#include "higherpair/mechanism/description.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::kDegree;

constexpr double kMm = 1e-3;
MotionLaw rise_and_return(LawType type, double rise) {
  LawDescription description;
  description.segments = {{type, 120 * kDegree, rise},
                          {LawType::kDwell, 40 * kDegree, 0},
                          {type, 130 * kDegree, -rise},
                          {LawType::kDwell, 70 * kDegree, 0}};
  description.repeats = true;
  return *MotionLaw::make(description);
}

// A follower on a slide along y at x = `offset`, or on an arm about (80, 0) mm.
struct CamAndFollower {
  Mechanism mechanism;
  CamMotion motion;
};

CamAndFollower cam_with(const MotionLaw& law, const Curve& follower_curve, bool turns, double offset,
                        bool outer) {
  Mechanism m;
  const int cam = add_body(m, "cam");
  const int follower = turns ? add_body(m, "follower", Vector2d(80 * kMm, 0), 150 * kDegree)
                             : add_body(m, "follower", Vector2d(offset, 45 * kMm));
  const PointRef O = add_point(m, kGround, "O", Vector2d::Zero());
  const int pivot = add_revolute(m, "pivot", O, add_point(m, cam, "O", Vector2d::Zero()));
  const PointRef P = add_point(m, follower, "P", Vector2d::Zero());
  const int joint = turns ? add_revolute(m, "arm", add_point(m, kGround, "Q", Vector2d(80 * kMm, 0)), P)
                          : add_prismatic(m, "guide", add_point(m, kGround, "Q", Vector2d(offset, 0)), P,
                                          Vector2d::UnitY());
  const auto at = [&](int index) { return static_cast<std::size_t>(index); };
  const CarriedBody carried_cam = carried_body(m, m.joints[at(pivot)], cam);
  const CarriedBody carried = carried_body(m, m.joints[at(joint)], follower);
  CamMotion motion{carried_cam.freedom,
                   carried_cam.sign,
                   carried.freedom,
                   carried.sign,
                   joint_motion(m, m.joints[at(joint)], posed_bodies(m)).position,
                   law};
  auto spans = cam_flank(motion, follower_curve, outer);
  EXPECT_TRUE(spans) << static_cast<int>(spans.error().kind) << " at " << spans.error().coordinate;
  auto boundary = Boundary::make(*spans, closes(motion), 1e-9);
  EXPECT_TRUE(boundary) << static_cast<int>(boundary.error().kind) << " " << boundary.error().distance;
  add_contact(m, "touch", add_curve(m, cam, "flank", *boundary),
              add_curve(m, follower, "face", follower_curve));
  add_driver(m, pivot);
  use_boundaries(m);
  return {m, motion};
}

struct RoundTripError {
  double s = 0, v = 0, a = 0, j = 0;
};

RoundTripError round_trip(const CamAndFollower& made, double scale) {
  RoundTripError worst;
  auto run = start_run(made.mechanism, {0.1});
  EXPECT_TRUE(run) << run.error().reason;
  if (!run) {
    return {1, 1, 1, 1};
  }
  for (int i = 0; i <= 367; ++i) {
    const double u = 0.1 + i * 2 * kPi / 360;
    move_to(*run, {{u, 1, 0}});
    EXPECT_EQ(run->row.status, RowStatus::kOk) << u;
    const auto here = joint_motion(run->mechanism(), run->mechanism().joints[1], run->row.bodies);
    const auto& law = made.motion.law;
    worst.s = std::max(worst.s, std::abs(here.position - made.motion.follower_rest - law(u)) / scale);
    worst.v = std::max(worst.v, std::abs(here.velocity - law.derivative(1, u)) / scale);
    worst.a = std::max(worst.a, std::abs(here.acceleration - law.derivative(2, u)) / scale);
    if (i % 12 == 0) {
      const auto jerk = joint_jerk(*run, 1, jerks_of(*run).bodies);
      EXPECT_TRUE(jerk);
      worst.j = std::max(worst.j, std::abs(jerk.value_or(1e9) - law.derivative(3, u)) / scale);
    }
  }
  return worst;
}

void expect_round_trip(const CamAndFollower& made, double scale, const std::string& what) {
  const RoundTripError worst = round_trip(made, scale);
  EXPECT_LT(worst.s, 1e-13) << what;
  EXPECT_LT(worst.v, 1e-12) << what;
  EXPECT_LT(worst.a, 1e-10) << what;
  EXPECT_LT(worst.j, 1e-6) << what;
}

TEST(FlankRoundTrip, EveryFollowerMovesByTheLaw) {
  const double rise = 12 * kMm;
  for (const LawType type : {LawType::kCycloidal, LawType::kPolynomial345, LawType::kModifiedSine}) {
    const MotionLaw law = rise_and_return(type, rise);
    const Curve roller = *make_circle(Vector2d::Zero(), 8 * kMm);
    for (const double offset : {0.0, 6 * kMm}) {
      expect_round_trip(cam_with(law, roller, false, offset, false), rise, "roller");
      expect_round_trip(cam_with(law, *make_point(Vector2d(0, -5 * kMm)), false, offset, false), rise,
                        "edge");
    }
    expect_round_trip(cam_with(rise_and_return(type, 5 * kMm), *make_line(Vector2d::Zero(), Vector2d(0, -1)),
                               false, 3 * kMm, false),
                      5 * kMm, "flat face");
    expect_round_trip(
        cam_with(law, *make_ellipse(Vector2d(1 * kMm, 0), {14 * kMm, 8 * kMm}, 0.2), false, 2 * kMm, false),
        rise, "elliptical");
    expect_round_trip(cam_with(law, roller, false, 0, true), rise, "outer wall");
    const MotionLaw swing = rise_and_return(type, -12 * kDegree);
    expect_round_trip(cam_with(swing, *make_circle(Vector2d(60 * kMm, 0), 8 * kMm), true, 0, false),
                      12 * kDegree, "roller on an arm");
  }
}

}  // namespace
}  // namespace higherpair
