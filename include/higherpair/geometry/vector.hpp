#pragma once

#include <cmath>

#include <Eigen/Core>

namespace higherpair {

/// Planar vectors. `T` is the scalar: double, or a type that holds several configurations at once.
template <class T>
using Vector2 = Eigen::Matrix<T, 2, 1>;
using Eigen::Vector2d;

inline constexpr double kPi = 3.14159265358979323846;

/// The vector (x, y).
template <class T>
[[nodiscard]] inline Vector2<T> vector_of(const T& x, const T& y) {
  return {x, y};
}
#ifdef EIGEN_VECTORIZE_SSE2
/// The same by one store: Eigen loads both components at once, and a load that spans two stores waits for
/// them.
[[nodiscard]] inline Vector2d vector_of(double x, double y) {
  Vector2d v;
  _mm_store_pd(v.data(), _mm_set_pd(y, x));
  return v;
}
#endif

/// `v` turned by +90° (counter-clockwise): (x, y) -> (-y, x).
template <class T>
[[nodiscard]] inline Vector2<T> perp(const Vector2<T>& v) {
  return vector_of(T(-v.y()), T(v.x()));
}

/// The out-of-plane component of a × b: a_x b_y - a_y b_x; positive where b lies counter-clockwise of a.
template <class T>
[[nodiscard]] inline T cross(const Vector2<T>& a, const Vector2<T>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The foot of p on the line through `at` with the unit normal n.
[[nodiscard]] inline Vector2d foot_on(const Vector2d& at, const Vector2d& n, const Vector2d& p) {
  return p - (p - at).dot(n) * n;
}

/// The unit vector at `angle` [rad] from the x axis.
[[nodiscard]] inline Vector2d unit_vector(double angle) {
  return vector_of(std::cos(angle), std::sin(angle));
}

/// The angle of `v` from the x axis [rad], in (-π, π]; 0 for the zero vector.
[[nodiscard]] inline double angle_of(const Vector2d& v) {
  return std::atan2(v.y(), v.x());
}

/// The angle that equals `angle` up to whole turns and lies nearest to `reference` [rad].
[[nodiscard]] inline double nearest_turn(double angle, double reference) {
  const double turns = (reference - angle) * (0.5 / kPi);
  return std::abs(turns) < 0.5 ? angle : angle + 2 * kPi * std::round(turns);
}

}  // namespace higherpair
