#pragma once

#include "higherpair/geometry/curve.hpp"
#include "higherpair/geometry/pose.hpp"
#include "higherpair/numeric/scalar.hpp"

#include <cmath>
#include <type_traits>

namespace higherpair {

/// A curve at a pose of its body, expressed in ground W; same vertex form as Curve.
/// \tparam D  scalar of the dimensions: double, or an expansion by one of them
template <class T, class D = double>
struct PlacedCurve {
  Vector2<T> vertex_W;
  Vector2<T> axis_W;
  D semi_latus{0};
  D q{1};
  double side = 1;  ///< +1 where the body is on the convex side, -1 where it is on the other
  const SupportCurve* support = nullptr;
  std::size_t piece = 0;
};

/// \param vertex_W  position of the curve's vertex_B \param R_WB  rotation of its body
template <class T>
[[nodiscard]] inline PlacedCurve<T> place(const Curve& curve, const Vector2<T>& vertex_W,
                                          const Rotation<T>& R_WB) {
  return {vertex_W,   R_WB * Vector2<T>(curve.axis_B.template cast<T>()), curve.semi_latus,
          curve.q,    curve.side == Side::kInside ? 1.0 : -1.0,           curve.support,
          curve.piece};
}

/// With the pose of its body.
template <class T>
[[nodiscard]] inline PlacedCurve<T> place(const Curve& curve, const Pose<T>& X_WB) {
  return place(curve, X_WB * Vector2<T>(curve.vertex_B.template cast<T>()), X_WB.R_WB);
}

/// The curve after its body has turned about a point of ground.
[[nodiscard]] inline PlacedCurve<double> turned(PlacedCurve<double> curve, const Vector2d& pivot_W,
                                                const Rotation<double>& turn) {
  curve.vertex_W = pivot_W + turn * Vector2d(curve.vertex_W - pivot_W);
  curve.axis_W = turn * curve.axis_W;
  return curve;
}

/// Outward unit normal of a line.
template <class T>
[[nodiscard]] inline Vector2<T> face_normal(const PlacedCurve<T>& line) {
  return -line.axis_W;
}

/// The boundary point whose outward normal is given.
template <class T>
struct SupportPoint {
  Vector2<T> p_W;  ///< the point [m]
  T rho;           ///< signed radius of curvature there [m]: > 0 convex, < 0 concave, 0 for a point
  T w2;  ///< n_x² + q n_y² > 0 where the point exists (see has_point for the sheet of a hyperbola)
};

/// The same for a curve given by its support function, for a normal within its piece.
[[nodiscard]] SupportPoint<double> point_by_support(const PlacedCurve<double>& curve, const Vector2d& n_W);
/// Whether the piece has the normal, and dρ/dφ at it.
[[nodiscard]] bool has_normal(const PlacedCurve<double>& curve, const Vector2d& n_W);
[[nodiscard]] double slope_by_support(const PlacedCurve<double>& curve, const Vector2d& n_W);

/// The point of a conic (or the knife edge) at which the body's outward unit normal is n_W, in closed form.
/// With N = ±n (the sign of the side) in the frame of the axis and w = √(N_x² + q N_y²):
///     y = ℓ N_y / w,   x = ℓ N_y² / (w (w - N_x)) = ℓ (w + N_x) / (q w),   |ρ| = ℓ / w³.
/// The first form of x is used on the near half (N_x <= 0), the second on the far half that only ellipses
/// have, so nothing cancels. Derivation: ∇f ∥ N on y² = 2ℓx - qx². Where no point has this normal (has_point
/// is false) the result is meaningless and may be NaN. Not for lines. Other kinds of curves are evaluated by
/// their support function, in doubles only.
template <class T, class D>
[[nodiscard]] inline SupportPoint<T> support_point(const PlacedCurve<T, D>& curve, const Vector2<T>& n_W) {
  using std::sqrt;
  const Vector2<T> across_W = perp(curve.axis_W);
  const T N_x = curve.side * n_W.dot(curve.axis_W);
  const T N_y = curve.side * n_W.dot(across_W);
  if (curve.q == D(1)) {  // a circle: w = 1, and x = ℓ (1 + N_x) = ℓ |axis + N|²/2 does not cancel
    const Vector2<T> chord = curve.axis_W + T(curve.side) * n_W;
    const T x = curve.semi_latus / 2 * (chord.x() * chord.x() + chord.y() * chord.y());
    return {curve.vertex_W + x * curve.axis_W + curve.semi_latus * N_y * across_W,
            T(curve.side * curve.semi_latus), T(1)};
  }
  if constexpr (std::is_same_v<T, double> && std::is_same_v<D, double>) {
    if (curve.support != nullptr) {
      return point_by_support(curve, n_W);
    }
  }
  const auto near_half = N_x <= T(0);
  const T w2 = N_x * N_x + curve.q * N_y * N_y;
  const T w = sqrt(w2);
  const T scale = curve.semi_latus / w;
  const T x = scale * select(near_half, N_y * N_y, w + N_x) / select(near_half, w - N_x, T(curve.q));
  const T y = scale * N_y;
  return {curve.vertex_W + x * curve.axis_W + y * across_W, curve.side * scale / w2, w2};
}

/// Whether some point of the curve has the outward unit normal n_W: always for ellipses and points; for a
/// parabola or a branch of a hyperbola only the normals within a cone about the normal at the vertex.
[[nodiscard]] inline bool has_point(const PlacedCurve<double>& curve, const Vector2d& n_W) {
  if (curve.q > 0) {
    return true;
  }
  if (curve.support != nullptr) {
    return has_normal(curve, n_W);
  }
  const double N_x = curve.side * n_W.dot(curve.axis_W);
  const double N_y = cross(curve.axis_W, n_W);
  return N_x < 0 && N_x * N_x + curve.q * N_y * N_y > 0;
}

/// Derivative of the radius of curvature ρ with respect to the angle of the outward normal n_W; for a conic 3
/// ρ (1 - q) N_x N_y / w².
[[nodiscard]] inline double radius_slope(const PlacedCurve<double>& curve, double rho, const Vector2d& n_W) {
  if (curve.q == 1) {
    return 0;
  }
  if (curve.support != nullptr) {
    return slope_by_support(curve, n_W);
  }
  const double N_x = n_W.dot(curve.axis_W);
  const double N_y = cross(curve.axis_W, n_W);
  return 3 * rho * (1 - curve.q) * N_x * N_y / (N_x * N_x + curve.q * N_y * N_y);
}

/// Radius of curvature at a point. Far out on a hyperbola the point (known to within `extent` times rounding)
/// can determine it better than the normal does: ρ = ℓ (1 + (1 - q) y²/ℓ²)^{3/2}. Otherwise ρ as given.
/// \param w2  of the point, see SupportPoint
[[nodiscard]] inline double radius_at(const PlacedCurve<double>& curve, double rho, double w2,
                                      const Vector2d& p_W, double extent) {
  if (curve.q >= 0) {
    return rho;
  }
  const double y = cross(curve.axis_W, Vector2d(p_W - curve.vertex_W));
  if (std::abs(y) * std::sqrt(-curve.q) <= extent * w2) {
    return rho;
  }
  const double slope = y / curve.semi_latus;
  const double ratio2 = 1 + (1 - curve.q) * slope * slope;
  return curve.side * curve.semi_latus * ratio2 * std::sqrt(ratio2);
}

}  // namespace higherpair
