#pragma once

#include <algorithm>
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
/// The same with a single store: Eigen loads both components at once, and a load that spans two stores has to
/// wait for them.
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

/// The angle from a to b [rad], in (-π, π]; of any lengths.
[[nodiscard]] inline double angle_from_to(const Vector2d& a, const Vector2d& b) {
  return std::atan2(cross(a, b), a.dot(b));
}

/// `angle` brought into (-π, π] by whole turns [rad].
[[nodiscard]] inline double principal_angle(double angle) {
  const double turned = std::remainder(angle, 2 * kPi);
  return turned > -kPi ? turned : kPi;
}

/// The angle that equals `angle` up to whole turns and lies nearest to `reference` [rad]; half a turn from
/// it, `angle` itself.
[[nodiscard]] inline double nearest_turn(double angle, double reference) {
  const double turns = (reference - angle) * (0.5 / kPi);
  return std::abs(turns) <= 0.5 ? angle : angle + 2 * kPi * std::round(turns);
}

/// The closed interval from low to high.
struct Bounds {
  double low = 0;
  double high = 0;

  [[nodiscard]] bool contains(double x) const { return low <= x && x <= high; }
  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] Bounds operator-() const { return {-high, -low}; }
};

/// The smallest interval that contains both.
[[nodiscard]] inline Bounds hull(const Bounds& a, const Bounds& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// The bounds of an enclosure with lower() and upper().
template <class Enclosure>
[[nodiscard]] Bounds to_bounds(const Enclosure& x) {
  return {x.lower(), x.upper()};
}

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

  /// The rotation by the opposite angle.
  [[nodiscard]] Rotation inverse() const { return {cos, -sin}; }

  [[nodiscard]] Vector2<T> operator*(const Vector2<T>& v) const {
    return vector_of(T(cos * v.x() - sin * v.y()), T(sin * v.x() + cos * v.y()));
  }

  [[nodiscard]] Rotation operator*(const Rotation& other) const {
    return {cos * other.cos - sin * other.sin, sin * other.cos + cos * other.sin};
  }

  /// Removes the rounding errors that products have accumulated: cos² + sin² = 1 again (first order, for
  /// small errors).
  [[nodiscard]] Rotation normalised() const {
    const T scale = T(1.5) - T(0.5) * (cos * cos + sin * sin);
    return {cos * scale, sin * scale};
  }
};

/// The direction of a vector that is not zero, as the rotation that turns the x axis into it.
[[nodiscard]] inline Rotation<double> direction_of(const Vector2d& v) {
  const double length = v.norm();
  return {v.x() / length, v.y() / length};
}

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
  /// The pose of another body relative to this one.
  [[nodiscard]] Pose inverse_times(const Pose& X_WC) const {
    return {R_WB.inverse() * X_WC.R_WB, inverse_times(X_WC.p_WB)};
  }
};

/// Motion of a point, expressed in ground W.
struct PointMotion {
  Vector2d p_W = Vector2d::Zero();  ///< position [m]
  Vector2d v_W = Vector2d::Zero();  ///< velocity [m/s]
  Vector2d a_W = Vector2d::Zero();  ///< acceleration [m/s²]
};

/// Motion of a rigid body B, expressed in ground W.
struct BodyMotion {
  Pose<double> X_WB;                 ///< pose of the body's frame
  double theta = 0;                  ///< angle of the frame [rad], continuous over turns
  Vector2d v_WB = Vector2d::Zero();  ///< velocity of the frame's origin [m/s]
  double omega = 0;                  ///< angular velocity [rad/s]
  Vector2d a_WB = Vector2d::Zero();  ///< acceleration of the frame's origin [m/s²]
  double alpha = 0;                  ///< angular acceleration [rad/s²]
};

/// Motion of the point p_B (body frame, [m]) that is fixed in a moving body.
/// v = v_o + ω ẑ×r, a = a_o + α ẑ×r - ω² r with r from the origin to the point.
[[nodiscard]] inline PointMotion point_motion(const BodyMotion& body, const Vector2d& p_B) {
  const Vector2d r_W = body.X_WB.R_WB * p_B;
  return {body.X_WB.p_WB + r_W, body.v_WB + body.omega * perp(r_W),
          body.a_WB + body.alpha * perp(r_W) - body.omega * body.omega * r_W};
}

/// The same for the body-fixed point that is currently at p_W [m].
[[nodiscard]] inline PointMotion motion_at_place(const BodyMotion& body, const Vector2d& p_W) {
  return point_motion(body, body.X_WB.inverse_times(p_W));
}

/// Velocity of the body-fixed point that is currently at p_W [m/s].
[[nodiscard]] inline Vector2d velocity_at(const BodyMotion& body, const Vector2d& p_W) {
  return body.v_WB + body.omega * perp(Vector2d(p_W - body.X_WB.p_WB));
}

/// Motion in W of a body B that moves relative to a carrier C: X_WB = X_WC X_CB, with v = v_C + ω_C ẑ×r +
/// R v_CB and a = a_C + α_C ẑ×r - ω_C² r + 2 ω_C ẑ×(R v_CB) + R a_CB, r = R p_CB.
/// \param motion_CB  relative to C, expressed in its frame
[[nodiscard]] BodyMotion compose(const BodyMotion& motion_WC, const BodyMotion& motion_CB);

}  // namespace higherpair
