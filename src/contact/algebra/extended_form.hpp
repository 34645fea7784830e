#pragma once

#include "contact_pencil.hpp"
#include "extended.hpp"
#include "higherpair/geometry/support.hpp"

#include <optional>
#include <vector>

namespace higherpair {

[[nodiscard]] Complex<Extended> complex_of(const Vector2d& v);

/// One of the two square roots.
[[nodiscard]] Complex<Extended> square_root(const Complex<Extended>& a);

/// Value of the form, its gradient (as a complex number), the change of the gradient along dw, and the signed
/// curvature where the gradient is G.
/// \pre not a point
[[nodiscard]] Extended value_at(const Form<Extended>& form, const Complex<Extended>& w);
[[nodiscard]] Complex<Extended> gradient_at(const Form<Extended>& form, const Complex<Extended>& w);
[[nodiscard]] Complex<Extended> hessian_times(const Form<Extended>& form, const Complex<Extended>& dw);
[[nodiscard]] double curvature(const Form<Extended>& form, const Complex<Extended>& G);

/// The point with the homogeneous coordinates v (up to a complex factor); none if it is at infinity.
[[nodiscard]] std::optional<Complex<Extended>> finite_point(const Vector3c<Extended>& v);

/// For M that is nearly ± m mᵀ with a real line m: where m meets the conic; if it misses it by rounding, the
/// midpoint.
[[nodiscard]] std::vector<Complex<Extended>> points_on_double_line(const Matrix3c<Extended>& M,
                                                                   const Form<Extended>& conic);

/// Whether a point is on the branch of a hyperbola that bounds the body: the other one is beyond the centre,
/// x = ℓ/q.
[[nodiscard]] inline bool on_branch(const PlacedCurve<double>& curve, const Vector2d& p) {
  return curve.q >= 0 || curve.q * (p - curve.vertex_W).dot(curve.axis_W) < curve.semi_latus;
}

}  // namespace higherpair
