#pragma once

#include "higherpair/geometry/curve.hpp"
#include "higherpair/geometry/pose.hpp"

#include <cmath>

// Motions that move a curve within itself, to rounding: how it lies to others does not change with them.

namespace higherpair {

/// A circle or a point turning about p_B. \param size  of the lengths that have gone into its place [m]
[[nodiscard]] inline bool is_centered_at(const Curve& curve, const Vector2d& p_B, double size) {
  const bool round = curve.kind == CurveKind::kCircle || curve.kind == CurveKind::kPoint;
  const Vector2d center_B = curve.vertex_B + curve.semi_latus * curve.axis_B;
  return round && (center_B - p_B).norm() <= 1e-14 * size;
}

/// A line sliding along itself.
[[nodiscard]] inline bool slides_along_itself(const Curve& curve, const Rotation<double>& R_WB,
                                              const Vector2d& direction_W) {
  return is_line(curve) && std::abs((R_WB * curve.axis_B).dot(direction_W)) <= 1e-14;
}

}  // namespace higherpair
