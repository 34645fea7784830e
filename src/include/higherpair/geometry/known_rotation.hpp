#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/geometry/tolerances.hpp"

#include <cmath>

namespace higherpair {

/// sin x of a small angle x [rad].
[[nodiscard]] inline double small_sine(double x) {
  const double x2 = x * x;
  return x - x * x2 * (1 / 6.0 - x2 * (1 / 120.0 - x2 * (1 / 5040.0)));
}

/// 1 - cos x of a small angle x [rad].
[[nodiscard]] inline double small_versine(double x) {
  const double x2 = x * x;
  return x2 * (1 / 2.0 - x2 * (1 / 24.0 - x2 * (1 / 720.0)));
}

/// The angle [rad] whose sine is given and small.
[[nodiscard]] inline double small_angle(double sine) {
  const double s2 = sine * sine;
  return sine + sine * s2 * (1 / 6.0 + s2 * (3 / 40.0 + s2 * (15 / 336.0 + s2 * (105 / 3456.0))));
}

/// The angle from one unit vector to the next [rad], in (-π, π], as angle_from_to(); without trigonometric
/// functions where it is small.
[[nodiscard]] inline double angle_between(const Vector2d& from, const Vector2d& to) {
  const double sine = cross(from, to);
  const double cosine = from.dot(to);
  return sine * sine <= kSmallTurn2 && cosine > 0 ? small_angle(sine) : std::atan2(sine, cosine);
}

/// An angle whose cosine and sine are known: those of nearby angles follow without trigonometric functions,
/// and vice versa. Nothing drifts, because the known angle is kept until the current one is too far from it.
class KnownRotation {
public:
  KnownRotation() = default;
  explicit KnownRotation(double angle) : angle_(angle), R_(Rotation<double>::from_angle(angle)) {}

  [[nodiscard]] bool is_near(double angle) const {
    return (angle - angle_) * (angle - angle_) <= kSmallTurn2;
  }

  /// The rotation by `angle` [rad], to within rounding.
  [[nodiscard]] Rotation<double> at(double angle) const {
    if (!is_near(angle)) {
      return Rotation<double>::from_angle(angle);
    }
    const double sine = small_sine(angle - angle_);
    const double versine = small_versine(angle - angle_);
    return {R_.cos - (versine * R_.cos + sine * R_.sin), R_.sin - (versine * R_.sin - sine * R_.cos)};
  }

  /// The angle [rad] of a rotation, to within rounding; of all values that differ by whole turns the one
  /// nearest to `reference`.
  [[nodiscard]] double angle_of(const Rotation<double>& R, double reference) const {
    const double sine = R_.cos * R.sin - R_.sin * R.cos;
    const double cosine = R_.cos * R.cos + R_.sin * R.sin;
    const bool near = sine * sine <= kSmallTurn2 && cosine > 0;
    return nearest_turn(near ? angle_ + small_angle(sine) : std::atan2(R.sin, R.cos), reference);
  }

  /// A known rotation near `angle`: this one while `angle` stays near it.
  [[nodiscard]] KnownRotation renewed_at(double angle) const {
    return is_near(angle) ? *this : KnownRotation(angle);
  }

private:
  double angle_ = 0;
  Rotation<double> R_;
};

}  // namespace higherpair
