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

}  // namespace
}  // namespace higherpair
