#pragma once

#include "higherpair/geometry/vector.hpp"

namespace higherpair {

/// A planar rotation as a unit vector (cos, sin): the hot paths compose rotations without trigonometric
/// functions.
template <class T>
struct Rotation {
  T cos{1};
  T sin{0};

  /// The rotation by `angle` [rad].
  [[nodiscard]] static Rotation from_angle(T angle) {
    using std::cos;
    using std::sin;
    return {cos(angle), sin(angle)};
  }

  /// The same rotation backwards.
  [[nodiscard]] Rotation inverse() const { return {cos, -sin}; }

  [[nodiscard]] Vector2<T> operator*(const Vector2<T>& v) const {
    return vector_of(T(cos * v.x() - sin * v.y()), T(sin * v.x() + cos * v.y()));
  }

  [[nodiscard]] Rotation operator*(const Rotation& other) const {
    return {cos * other.cos - sin * other.sin, sin * other.cos + cos * other.sin};
  }

  /// Removes the rounding that products have gathered: cos² + sin² = 1 again (first order, for small errors).
  [[nodiscard]] Rotation normalised() const {
    const T scale = T(1.5) - T(0.5) * (cos * cos + sin * sin);
    return {cos * scale, sin * scale};
  }
};

/// The pose of the frame of body B in ground W: a point p_B of the body is at `R_WB * p_B + p_WB`.
template <class T>
struct Pose {
  Rotation<T> R_WB;
  Vector2<T> p_WB = Vector2<T>::Zero();  ///< origin of B in W [m]

  /// The position in W of the point p_B of the body [m].
  [[nodiscard]] Vector2<T> operator*(const Vector2<T>& p_B) const { return R_WB * p_B + p_WB; }

  /// The point of the body that is at p_W: inverse of the product [m].
  [[nodiscard]] Vector2<T> inverse_times(const Vector2<T>& p_W) const {
    return R_WB.inverse() * Vector2<T>(p_W - p_WB);
  }
};

}  // namespace higherpair
