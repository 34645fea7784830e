#pragma once

#include "higherpair/geometry/curve.hpp"
#include "higherpair/geometry/pose.hpp"

#include <cmath>

namespace higherpair {

/// `a` where the condition holds, else `b`; overloaded for scalars that hold several configurations.
template <class T>
[[nodiscard]] inline T select(bool condition, T a, T b) {
  return condition ? a : b;
}

/// A curve where its body stands now, expressed in ground W; same vertex form as Curve.
template <class T>
struct PlacedCurve {
  Vector2<T> vertex_W;
  Vector2<T> axis_W;
  double semi_latus = 0;
  double q = 1;
  double side = 1;  ///< +1 where the body is the convex side, -1 where it is the other
};

template <class T>
[[nodiscard]] inline PlacedCurve<T> place(const Curve& curve, const Pose<T>& X_WB) {
  return {X_WB * Vector2<T>(curve.vertex_B), X_WB.R_WB * Vector2<T>(curve.axis_B), curve.semi_latus, curve.q,
          curve.side == Side::kInside ? 1.0 : -1.0};
}

/// The boundary point whose outward normal is given.
template <class T>
struct SupportPoint {
  Vector2<T> p_W;  ///< the point [m]
  T rho;           ///< signed radius of curvature there [m]: > 0 convex, < 0 concave, 0 for a point
  T w2;  ///< n_x² + q n_y² > 0 where the point exists (see has_point for the sheet of a hyperbola)
};

/// The point of a conic (or the knife edge) at which the body's outward unit normal is n_W, in closed form.
/// With N = ±n (the sign of the side) in the frame of the axis and w = √(N_x² + q N_y²):
///     y = ℓ N_y / w,   x = ℓ N_y² / (w (w - N_x)) = ℓ (w + N_x) / (q w),   |ρ| = ℓ / w³.
/// The first form of x is used on the near half (N_x <= 0), the second on the far half that only ellipses
/// have, so nothing cancels. Derivation: ∇f ∥ N on y² = 2ℓx - qx². Where no point has this normal (has_point
/// is false) the result is meaningless and may be NaN. Not for lines.
template <class T>
[[nodiscard]] inline SupportPoint<T> support_point(const PlacedCurve<T>& curve, const Vector2<T>& n_W) {
  using std::sqrt;
  const Vector2<T> across_W = perp(curve.axis_W);
  const T N_x = curve.side * n_W.dot(curve.axis_W);
  const T N_y = curve.side * n_W.dot(across_W);
  if (curve.q == 1) {  // a circle: w = 1, and x = ℓ (1 + N_x) = ℓ |axis + N|²/2 does not cancel
    const Vector2<T> chord = curve.axis_W + T(curve.side) * n_W;
    const T x = curve.semi_latus / 2 * (chord.x() * chord.x() + chord.y() * chord.y());
    return {curve.vertex_W + x * curve.axis_W + curve.semi_latus * N_y * across_W,
            T(curve.side * curve.semi_latus), T(1)};
  }
  const auto near_half = N_x <= T(0);
  const T w2 = N_x * N_x + curve.q * N_y * N_y;
  const T w = sqrt(w2);
  const T scale = curve.semi_latus / w;
  const T x = scale * select(near_half, N_y * N_y, w + N_x) / select(near_half, w - N_x, T(curve.q));
  const T y = scale * N_y;
  return {curve.vertex_W + x * curve.axis_W + y * across_W, curve.side * scale / w2, w2};
}

/// Whether some point of the conic has the outward unit normal n_W: always for ellipses and points; for a
/// parabola or a branch of a hyperbola only the normals within a cone about the normal at the vertex.
[[nodiscard]] inline bool has_point(const PlacedCurve<double>& curve, const Vector2d& n_W) {
  if (curve.q > 0) {
    return true;
  }
  const double N_x = curve.side * n_W.dot(curve.axis_W);
  const double N_y = cross(curve.axis_W, n_W);
  return N_x < 0 && N_x * N_x + curve.q * N_y * N_y > 0;
}

}  // namespace higherpair
