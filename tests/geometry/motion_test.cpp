#include "geometry/geometry_testing.hpp"
#include "higherpair/geometry/pose.hpp"

namespace higherpair {
namespace {

using namespace higherpair::testing;

// A body that rotates and translates at once, with its rates written out by hand.
struct Tumble {
  Vector2d amplitude;
  double swing;
  double frequency;

  [[nodiscard]] double theta(double t) const { return 0.4 + 1.3 * t + swing * std::sin(frequency * t); }
  [[nodiscard]] BodyMotion at(double t) const {
    BodyMotion body;
    body.theta = theta(t);
    body.omega = 1.3 + swing * frequency * std::cos(frequency * t);
    body.alpha = -swing * frequency * frequency * std::sin(frequency * t);
    body.X_WB.R_WB = Rotation<double>::from_angle(body.theta);
    body.X_WB.p_WB = {amplitude.x() * std::cos(2 * t), amplitude.y() * std::exp(-t)};
    body.v_WB = {-2 * amplitude.x() * std::sin(2 * t), -amplitude.y() * std::exp(-t)};
    body.a_WB = {-4 * amplitude.x() * std::cos(2 * t), amplitude.y() * std::exp(-t)};
    return body;
  }
  // Position of a body point, by complex numbers and without rates.
  [[nodiscard]] Vector2d place(double t, const Vector2d& p_B) const {
    const std::complex<double> z =
        std::complex<double>(amplitude.x() * std::cos(2 * t), amplitude.y() * std::exp(-t)) +
        std::polar(1.0, theta(t)) * std::complex<double>(p_B.x(), p_B.y());
    return {z.real(), z.imag()};
  }
};

Tumble random_tumble(Random& random) {
  return {random.vector(1), random.between(0.1, 1), random.between(0.5, 2)};
}

TEST(PointMotion, IsTheDerivativeOfThePlace) {
  Random random(11);
  Worst place, velocity, acceleration;
  for (int i = 0; i < 500; ++i) {
    const Tumble tumble = random_tumble(random);
    const Vector2d p_B = random.vector(1);
    const double t = random.between(0, 1);
    const PointMotion point = point_motion(tumble.at(t), p_B);
    const auto [v, a] = differentiate([&](double s) { return tumble.place(s, p_B); }, t, 0.005);
    place.see(point.p_W - tumble.place(t, p_B));
    velocity.see(point.v_W - v);
    acceleration.see(point.a_W - a);
  }
  EXPECT_AT_MOST(place.value(), 1e-15);
  EXPECT_AT_MOST(velocity.value(), 1e-11);      // h⁶ and rounding / h are both below
  EXPECT_AT_MOST(acceleration.value(), 5e-10);  // rounding / h² is 1e-11, h⁶ times the eighth derivative more
}

TEST(PointMotion, OfTheOriginIsThatOfTheFrame) {
  const BodyMotion body = Tumble{{0.3, 0.7}, 0.5, 1.1}.at(0.2);
  const PointMotion origin = point_motion(body, Vector2d::Zero());
  EXPECT_EQ(origin.p_W, body.X_WB.p_WB);
  EXPECT_EQ(origin.v_W, body.v_WB);
  EXPECT_EQ(origin.a_W, body.a_WB);
}

// Largest differences of the two motions, lengths in units of `size`.
double difference(const BodyMotion& a, const BodyMotion& b, double size) {
  Worst worst;
  worst.see(std::abs(std::remainder(a.theta - b.theta, 2 * kPi)));
  worst.see(std::hypot(a.X_WB.R_WB.cos - b.X_WB.R_WB.cos, a.X_WB.R_WB.sin - b.X_WB.R_WB.sin));
  worst.see((a.X_WB.p_WB - b.X_WB.p_WB) / size);
  worst.see((a.v_WB - b.v_WB) / size);
  worst.see((a.a_WB - b.a_WB) / size);
  worst.see(std::abs(a.omega - b.omega));
  worst.see(std::abs(a.alpha - b.alpha));
  return worst.value();
}

TEST(BodyMotionFromPoints, RecoversTheMotion) {
  Random random(12);
  for (const double size : {1e-6, 1.0, 1e6}) {
    Worst error;
    for (int i = 0; i < 1000; ++i) {
      Tumble tumble = random_tumble(random);
      tumble.amplitude *= size;
      const BodyMotion body = tumble.at(random.between(0, 1));
      const Vector2d p_A = random.vector(size);
      const Vector2d p_B = p_A + size * random.between(0.5, 1) * unit_vector(random.angle());
      const BodyMotion found =
          body_motion_from_points(p_A, point_motion(body, p_A), p_B, point_motion(body, p_B));
      error.see(difference(found, body, size));
      EXPECT_AT_MOST(std::abs(found.theta), kPi);
    }
    EXPECT_AT_MOST(error.value(), 5e-14);  // accelerations up to 30, points half a size apart
  }
}

TEST(BodyMotionFromPoints, LosesOnlyTheLeverWhereThePointsAreFarAway) {
  Random random(13);
  Worst near_rates, far_rates, far_origin;
  for (int i = 0; i < 1000; ++i) {
    const BodyMotion body = random_tumble(random).at(random.between(0, 1));
    const Vector2d p_A = random.vector(1);
    const Vector2d far = p_A + 1e6 * unit_vector(random.angle());
    const BodyMotion found =
        body_motion_from_points(p_A, point_motion(body, p_A), far, point_motion(body, far));
    near_rates.see(difference(found, body, 1));

    // Two far points close to each other: every position is rounded by 1e-10, and so are the rates; at the
    // origin the error is a million times larger.
    const Vector2d next = far + unit_vector(random.angle());
    const BodyMotion from_afar =
        body_motion_from_points(far, point_motion(body, far), next, point_motion(body, next));
    far_rates.see(std::abs(from_afar.omega - body.omega));
    far_rates.see(std::abs(from_afar.alpha - body.alpha));
    far_origin.see(difference(from_afar, body, 1e6));
  }
  EXPECT_AT_MOST(near_rates.value(), 4e-14);
  EXPECT_AT_MOST(far_rates.value(), 2e-8);
  EXPECT_AT_MOST(far_origin.value(), 2e-8);
}

TEST(BodyMotionFromPoints, TakesOnlyWhatARigidBodyCanHave) {
  const BodyMotion body = Tumble{{0.3, 0.7}, 0.5, 1.1}.at(0.2);
  const Vector2d p_A(0.1, 0.2);
  const Vector2d p_B(0.9, -0.4);
  const PointMotion a = point_motion(body, p_A);
  PointMotion b = point_motion(body, p_B);
  const Vector2d along = (b.p_W - a.p_W).normalized();
  b.p_W += 0.05 * along;
  b.v_W += 3 * along + 0.05 * body.omega * perp(along);
  b.a_W += 7 * along + 0.05 * body.alpha * perp(along);
  EXPECT_AT_MOST(difference(body_motion_from_points(p_A, a, p_B, b), body, 1), 1e-14);
}

TEST(BodyMotionFromPoints, HoldsTheFirstPointWhereItIs) {
  const BodyMotion body = Tumble{{0.3, 0.7}, 0.5, 1.1}.at(0.2);
  const Vector2d p_A(0.1, 0.2);
  const Vector2d p_B(0.9, -0.4);
  PointMotion b = point_motion(body, p_B);
  b.p_W += Vector2d(0.01, -0.02);
  const PointMotion a = point_motion(body, p_A);
  const PointMotion held = point_motion(body_motion_from_points(p_A, a, p_B, b), p_A);
  EXPECT_AT_MOST((held.p_W - a.p_W).norm(), 1e-15);
  EXPECT_AT_MOST((held.v_W - a.v_W).norm(), 1e-15);
  EXPECT_AT_MOST((held.a_W - a.a_W).norm(), 4e-15);
}

}  // namespace
}  // namespace higherpair
