#pragma once

#include "higherpair/geometry/support.hpp"

#include <optional>
#include <string_view>

namespace higherpair {

/// Properties of a curve as a whole, whatever its kind; see support.hpp for those at one normal.

/// A point fixed to the curve from which distances are measured, in the body's frame [m]: the vertex of a
/// conic, a point of a line, the point itself, the origin of a support function.
[[nodiscard]] inline const Vector2d& anchor(const Curve& curve) {
  return curve.vertex_B;
}

/// A typical length of the curve itself [m]: the radius of curvature at the vertex of a conic, 0 for a line
/// or point; for other kinds the least sum of |p| and |ρ| over a few of its points.
[[nodiscard]] double size_of(const Curve& curve);

/// Bounds of the signed radius of curvature over the whole curve [m]: +∞ for a line, 0 for a point.
[[nodiscard]] Bounds radius_bounds(const Curve& curve);

/// Why two curves cannot touch anywhere without overlapping; empty if they can. Near a contact point the
/// bodies are apart only if the sum of the curvatures is not negative.
[[nodiscard]] std::string_view why_no_contact(const Curve& a, const Curve& b);

/// Bounds of the signed radius of curvature over the outward normals within `half` (at most 45°) of n_W [m].
/// Not for lines.
[[nodiscard]] Bounds radius_bounds(const PlacedCurve<double>& curve, const Vector2d& n_W,
                                   const Rotation<double>& half);

/// An arc of normals, as angles in ground [rad].
struct NormalArc {
  double middle = 0;
  double half = kPi;
};

/// The outward normals that an open curve has; none where it has all directions. Not for lines.
[[nodiscard]] std::optional<NormalArc> normals_of(const PlacedCurve<double>& curve);

/// Largest distance of the curve from a point of its body's frame [m]; none where it is not bounded.
[[nodiscard]] std::optional<double> reach_from(const Curve& curve, const Vector2d& p_B);

/// Centre of a circle, or a point itself: turning about it moves the curve within itself [m].
[[nodiscard]] std::optional<Vector2d> round_center(const Curve& curve);

/// Centre of a circle or ellipse [m].
[[nodiscard]] std::optional<Vector2d> middle_of(const Curve& curve);

/// Whether turning about p_B moves the curve within itself.
/// \param size  typical of the lengths that its position was computed from [m]
[[nodiscard]] bool is_centered_at(const Curve& curve, const Vector2d& p_B, double size);

/// Whether the curve is a line that sliding along `direction_W` moves within itself.
[[nodiscard]] bool slides_along_itself(const Curve& curve, const Rotation<double>& R_WB,
                                       const Vector2d& direction_W);

/// Arc coordinate of the boundary point with the outward normal at the angle `phi_B` in the body's frame,
/// growing along that normal turned +90° [m]; 0 at the vertex of a conic (arc_length.hpp), and at the
/// direction of x for other kinds. Lines and points: 0.
/// \param phi_B  continuous over turns [rad]
[[nodiscard]] double arc_to_normal(const Curve& curve, double phi_B);

/// The same for a parabola or hyperbola from the point itself, which keeps its digits far out.
[[nodiscard]] double arc_to_point(const Curve& curve, const Vector2d& p_B);

}  // namespace higherpair
