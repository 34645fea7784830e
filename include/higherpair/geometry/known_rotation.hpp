#pragma once

#include "higherpair/geometry/pose.hpp"

namespace higherpair {

/// An angle whose cosine and sine are known: those of angles near it follow without trigonometric functions,
/// and without a drift, as the known one stays what it is.
class KnownRotation {
public:
  KnownRotation() = default;
  explicit KnownRotation(double angle) : angle_(angle), R_(Rotation<double>::from_angle(angle)) {}

  /// Whether `angle` [rad] is near enough for the series, which leave 2e-17 out.
  [[nodiscard]] bool is_near(double angle) const {
    const double turn = angle - angle_;
    return turn * turn <= kNear2;
  }

  /// The rotation by `angle` [rad], to rounding.
  [[nodiscard]] Rotation<double> at(double angle) const {
    if (!is_near(angle)) {
      return Rotation<double>::from_angle(angle);
    }
    const double x = angle - angle_;
    const double x2 = x * x;
    const double versine = x2 / 2 * (1 - x2 * (1 / 12.0) * (1 - x2 * (1 / 30.0)));
    const double sine = x * (1 - x2 * (1 / 6.0) * (1 - x2 * (1 / 20.0) * (1 - x2 * (1 / 42.0))));
    return {R_.cos - (versine * R_.cos + sine * R_.sin), R_.sin - (versine * R_.sin - sine * R_.cos)};
  }

private:
  static constexpr double kNear2 = 1e-3;  // [rad²]
  double angle_ = 0;
  Rotation<double> R_;
};

}  // namespace higherpair
