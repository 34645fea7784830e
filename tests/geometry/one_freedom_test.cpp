#include "higherpair/geometry/one_freedom.hpp"

#include "geometry/geometry_testing.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

OneFreedom turning(Random& random, double size = 1) {
  OneFreedom freedom;
  freedom.p_WO = random.vector(size);
  freedom.p_BO = random.vector(size);
  return freedom;
}

OneFreedom sliding(Random& random, double size = 1) {
  OneFreedom freedom = turning(random, size);
  freedom.turns = false;
  freedom.direction_W = unit_vector(random.angle());
  freedom.theta = random.angle();
  freedom.R_WB = Rotation<double>::from_angle(freedom.theta);
  return freedom;
}

// A non-uniform motion of the coordinate, and its rates.
double coordinate(double t) {
  return 0.3 + 1.1 * t + 0.4 * std::sin(1.7 * t);
}
double coordinate_dot(double t) {
  return 1.1 + 0.4 * 1.7 * std::cos(1.7 * t);
}
double coordinate_ddot(double t) {
  return -0.4 * 1.7 * 1.7 * std::sin(1.7 * t);
}

TEST(OneFreedom, ATurningBodyKeepsItsPointOnThePivotAtEveryScale) {
  Random random(21);
  for (const double size : {1e-6, 1.0, 1e6}) {
    Worst error;
    for (int i = 0; i < 500; ++i) {
      const OneFreedom freedom = turning(random, size);
      const double q = random.between(-20, 20);
      const Pose<double> X_WB = pose_at(freedom, q);
      error.see((X_WB * freedom.p_BO - freedom.p_WO) / size);
      error.see(std::abs(X_WB.R_WB.cos - std::cos(q)));
      error.see(std::abs(X_WB.R_WB.sin - std::sin(q)));
    }
    EXPECT_AT_MOST(error.value(), 1e-15);
  }
}

TEST(OneFreedom, ASlidingBodyMovesItsPointAlongTheLineAndKeepsItsAngle) {
  Random random(22);
  Worst error;
  for (int i = 0; i < 500; ++i) {
    const OneFreedom freedom = sliding(random);
    const double q = random.between(-2, 2);
    const Pose<double> X_WB = pose_at(freedom, q);
    error.see(X_WB * freedom.p_BO - (freedom.p_WO + q * freedom.direction_W));
    error.see(std::abs(std::atan2(X_WB.R_WB.sin, X_WB.R_WB.cos) - freedom.theta));
    const BodyMotion body = motion_at(freedom, q, 1, 1);
    error.see(std::abs(body.theta - freedom.theta));
    error.see(std::abs(body.omega) + std::abs(body.alpha));
  }
  EXPECT_AT_MOST(error.value(), 2e-15);
}

TEST(OneFreedom, RatesAreTheDerivativesOfThePose) {
  Random random(23);
  Worst velocity, acceleration, angle;
  for (int i = 0; i < 500; ++i) {
    const OneFreedom freedom = i % 2 == 0 ? turning(random) : sliding(random);
    const double t = random.between(-1, 1);
    const Vector2d p_B = random.vector(1);
    const BodyMotion body = motion_at(freedom, coordinate(t), coordinate_dot(t), coordinate_ddot(t));
    const auto place = [&](double s) -> Vector2d { return pose_at(freedom, coordinate(s)) * p_B; };
    const auto theta = [&](double s) { return motion_at(freedom, coordinate(s), 0, 0).theta; };
    const auto [v, a] = differentiate(place, t, 0.005);
    const auto [omega, alpha] = differentiate(theta, t, 0.005);
    const PointMotion point = point_motion(body, p_B);
    velocity.see(point.v_W - v);
    acceleration.see(point.a_W - a);
    angle.see(std::abs(body.omega - omega));
    angle.see(1e-2 * std::abs(body.alpha - alpha));
  }
  // Differences with h = 0.005: rounding / h = 1e-13, rounding / h² = 3e-11, and truncation errors of the
  // same size.
  EXPECT_AT_MOST(velocity.value(), 3e-12);
  EXPECT_AT_MOST(acceleration.value(), 5e-10);
  EXPECT_AT_MOST(angle.value(), 3e-12);
}

TEST(OneFreedom, RatesPerCoordinateAreThoseOfTheMaterialPoint) {
  Random random(24);
  Worst error;
  for (int i = 0; i < 500; ++i) {
    const OneFreedom freedom = i % 2 == 0 ? turning(random) : sliding(random);
    const double q = random.angle();
    const Vector2d p_B = random.vector(1);
    const auto place = [&](double s) -> Vector2d { return pose_at(freedom, s) * p_B; };
    const auto [v, a] = differentiate(place, q, 0.01);
    error.see(velocity_per_q(freedom, place(q)) - v);
    error.see(1e-2 * (acceleration_per_q(freedom, place(q)) - a));
  }
  EXPECT_AT_MOST(error.value(), 2e-12);
}

TEST(OneFreedom, CountsTurnsInTheAngleOfItsFrame) {
  Random random(25);
  const OneFreedom freedom = turning(random);
  EXPECT_EQ(motion_at(freedom, 17.5, 0, 0).theta, 17.5);
  EXPECT_EQ(motion_at(freedom, 17.5, 2, 3).omega, 2);
  EXPECT_EQ(motion_at(freedom, 17.5, 2, 3).alpha, 3);
}

}  // namespace
}  // namespace higherpair
