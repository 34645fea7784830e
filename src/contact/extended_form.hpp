#pragma once

#include "contact_pencil.hpp"
#include "extended.hpp"
#include "higherpair/geometry/support.hpp"

#include <optional>
#include <vector>

namespace higherpair {

[[nodiscard]] Complex<Extended> complex_of(const Vector2d& v);

/// Value, gradient (as a complex number), change of the gradient along dw, signed curvature for a gradient.
/// \pre not a point
[[nodiscard]] Extended value_at(const Form<Extended>& form, const Complex<Extended>& w);
[[nodiscard]] Complex<Extended> gradient_at(const Form<Extended>& form, const Complex<Extended>& w);
[[nodiscard]] Complex<Extended> hessian_times(const Form<Extended>& form, const Complex<Extended>& dw);
[[nodiscard]] double curvature(const Form<Extended>& form, const Complex<Extended>& G);

/// The point with the homogeneous coordinates v (any complex factor); none at infinity.
[[nodiscard]] std::optional<Complex<Extended>> finite_point(const Vector3c<Extended>& v);

/// M is nearly ± m mᵀ for a real line m: where it meets the conic; if it misses it by rounding, the middle.
[[nodiscard]] std::vector<Complex<Extended>> points_on_double_line(const Matrix3c<Extended>& M,
                                                                   const Form<Extended>& conic);

/// Hyperbolas have a second branch that is no part of the body: beyond the centre at x = ℓ/q.
[[nodiscard]] inline bool on_branch(const PlacedCurve<double>& curve, const Vector2d& p) {
  return curve.q >= 0 || curve.q * (p - curve.vertex_W).dot(curve.axis_W) < curve.semi_latus;
}

}  // namespace higherpair
