#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <vector>

namespace higherpair {

/// A point of a boundary and its distance along it.
struct BoundaryStation {
  double arc = 0;  ///< from the beginning of the first span [m]
  SpanPoint point;
  bool corner = false;  ///< one of the two normals of a convex corner, where curvature is not defined
};

/// Length of a boundary [m], by Gauss-Legendre quadrature of 8 points in each of the parts of its spans
/// (Span::parts), to about 1e-12 of it.
[[nodiscard]] double length_of(const Boundary& boundary);

/// Points in the order of the boundary such that the straight lines between them deviate from it by at most
/// `tolerance` [m]; the ends of all spans are among them. Corners and notches give two points, with the
/// normals of both sides; any other joint gives one, with the curvature of the span behind it. The first
/// point of a closed boundary is not repeated.
[[nodiscard]] std::vector<BoundaryStation> points_within(const Boundary& boundary, double tolerance);

/// `count` points at equal distances along the boundary; for an open one both ends are included.
/// \pre count >= 2; the boundary has a length
[[nodiscard]] std::vector<BoundaryStation> points_at_equal_arcs(const Boundary& boundary, int count);

}  // namespace higherpair
