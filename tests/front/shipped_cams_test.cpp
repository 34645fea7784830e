#include "cam_profile.hpp"
#include "geometry/geometry_testing.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

// Shipped cams compared with their laws and tables.

namespace higherpair {
namespace {

using testing::shipped_model;

Motion cam_motion(const Model& model, bool forces = false) {
  RunSettings settings;
  settings.forces = forces;
  auto motion = model.run(settings);
  if (!motion) {
    throw std::runtime_error(to_string(motion.error()));
  }
  return *std::move(motion);
}

TEST(GrooveCam, SwingsItsLeverAsTheModifiedSineSays) {
  const Motion motion = cam_motion(shipped_model("groove_cam"));
  ASSERT_TRUE(motion.good());
  const auto angle = motion.column("lever_pivot.position");
  const auto speed = motion.column("lever_pivot.velocity");
  const auto acceleration = motion.column("lever_pivot.acceleration");
  const double omega = 300 * 360 / 60.0;  // of the cam [deg/s]
  EXPECT_NEAR(angle[50], angle[0] + 11, 1e-9);
  EXPECT_NEAR(angle[130], angle[0] + 22, 1e-9);
  EXPECT_NEAR(angle[360], angle[0], 1e-9);
  const auto most = [](const ColumnValues& column) {
    return std::max(-*std::min_element(column.begin(), column.end()),
                    *std::max_element(column.begin(), column.end()));
  };
  // Cv h/T, Ca h/T².
  EXPECT_NEAR(most(speed), 1.759603 * 22 / 100 * omega, 1e-6 * omega);
  EXPECT_NEAR(most(acceleration), 5.527957 * 22 / (100. * 100) * omega * omega, 1e-4 * omega * omega);
}

TEST(GrooveCam, HoldsItsRollerByTheOuterWallToo) {
  const Motion motion = cam_motion(shipped_model("groove_cam"), true);
  EXPECT_TRUE(motion.good());
  const auto force = motion.column("groove.force");
  EXPECT_LT(*std::min_element(force.begin(), force.end()), 0);
  // With the inner wall only, the contact opens.
  const Motion one_wall = cam_motion(shipped_model("groove_cam", {"contacts.groove.both_sides=false"}), true);
  EXPECT_FALSE(one_wall.good());
}

TEST(CamshaftFromALiftTable, LiftsAsTheLawThatTheTableWasRoundedFrom) {
  const Motion motion = cam_motion(shipped_model("camshaft_lift_table"));
  ASSERT_TRUE(motion.good());
  const auto lift = motion.column("guide.position");
  const auto acceleration = motion.column("guide.acceleration");
  const double omega = 1500 * 2 * M_PI / 60;
  double worst_lift = 0, worst_acceleration = 0;
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double x = 1 - std::abs(static_cast<double>(k) - 180) / 75;
    const double s = x <= 0 ? 0 : 9 * std::pow(x, 4) * (35 - 84 * x + 70 * x * x - 20 * x * x * x);
    const double a = x <= 0 ? 0
                            : 9 * x * x * (420 - 1680 * x + 2100 * x * x - 840 * x * x * x) /
                                  std::pow(75 * testing::kDegree, 2);
    worst_lift = std::max(worst_lift, std::abs(lift[k] - 32 - s));
    worst_acceleration = std::max(worst_acceleration, std::abs(acceleration[k] / (omega * omega) - a));
  }
  EXPECT_LT(worst_lift, 0.0015);       // mm: the rounding of the table, and the same amount from smoothing
  EXPECT_LT(worst_acceleration, 2.5);  // mm/rad², for a peak of 39
}

// The disc's centre is 10 mm from the cam's pivot and 40 mm from that of the roller, which is guided
// radially.
TEST(EccentricDisc, LiftsARadialRollerAsTheTriangleOfCentresSays) {
  const Motion motion = cam_motion(testing::model_of(
      testing::kCam, {"bodies.cam.curves.disc.radius=28", "bodies.follower.pose={x = 50, y = 0}",
                      "bodies.follower.curves.face={type = \"circle\", center = [0, 0], radius = 12}",
                      "joints.guide.direction=[1, 0]", "driver.positions=[0, 30]"}));
  EXPECT_NEAR(motion.column("guide.position")[1], 48.3465237038, 5e-11);
}

// A face through its pivot, which is 80 mm away, on a disc of 25 mm whose centre is 10 mm from the cam's
// pivot.
TEST(EccentricDisc, SwingsAFlatFaceAsTheTangentFromItsPivotSays) {
  const Motion motion = cam_motion(
      shipped_model("flat_faced_oscillating",
                    {"bodies.ground.points.O2=[80, 0]", "bodies.cam.curves.disc.center=[10, 0]",
                     "bodies.cam.curves.disc.radius=25", "bodies.follower.pose={x = 80, y = 0, angle = -25}",
                     "bodies.follower.curves.face.point=[0, 0]", "driver.positions=[0, 90]"}));
  EXPECT_NEAR(motion.column("follower.angle")[1] * testing::kDegree + kPi, 2.7019532892, 5e-11);
}

}  // namespace
}  // namespace higherpair
