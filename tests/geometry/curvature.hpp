#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>

namespace higherpair {

/// Normal and curvature of f(x, y) = A x² + B y² + C x y + D x + E y + F = 0 at one of its points; the body
/// is f < 0.
struct CurvePointShape {
  Vector2d n = Vector2d::Zero();  ///< unit outward normal ∇f/|∇f|
  double kappa = 0;               ///< signed curvature [1/m]: > 0 where the body is convex; 0 for a flat face
  Vector2d center = Vector2d::Zero();  ///< centre of curvature p - n/κ [m]; p itself where κ = 0
};

/// By y' and y'': y' = -(2Ax + Cy + D)/(2By + Cx + E), y'' = -((2B y' + 2C) y' + 2A)/(2By + Cx + E), |κ| =
/// |y''|/(1 + y'²)^{3/2}. Where the curve is steeper than 45°, x and y are exchanged, so that a vertical
/// tangent needs no special treatment. The sign of κ follows from whether the second derivative points into
/// the body or out of it.
/// \param coefficients A … F in this order; lengths in the unit of p
/// \param p a point of the curve with ∇f ≠ 0 there
[[nodiscard]] CurvePointShape shape_by_slope(const std::array<double, 6>& coefficients, const Vector2d& p);

/// By gradient and Hessian: κ = (f_xx f_y² - 2 f_xy f_x f_y + f_yy f_x²)/|∇f|³. Same parameters.
[[nodiscard]] CurvePointShape shape_by_gradient(const std::array<double, 6>& coefficients, const Vector2d& p);

}  // namespace higherpair
