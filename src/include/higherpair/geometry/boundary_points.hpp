#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <vector>

namespace higherpair {

/// A point of a boundary and how far along it that is.
struct BoundaryStation {
  double arc = 0;  ///< from the begin of the first span [m]
  SpanPoint point;
  bool corner = false;  ///< one of the two normals of a convex corner, where the curvature has no value
};

/// Length of a boundary [m], by Gauss-Legendre quadrature of 8 points in each of the parts of its spans
/// (Span::parts), to about 1e-12 of it.
[[nodiscard]] double length_of(const Boundary& boundary);

/// Points in the order of the boundary between which a straight line leaves it by no more than `tolerance`
/// [m]; the ends of all spans are among them. Corners and notches have two rows, with the normals on both of
/// their sides; elsewhere a joint has one, with the curvature of the span behind it. The last point of a
/// closed boundary is the one before the first.
[[nodiscard]] std::vector<BoundaryStation> points_within(const Boundary& boundary, double tolerance);

/// `count` points at equal distances along the boundary, of an open one both ends included.
/// \pre count >= 2; the boundary has a length
[[nodiscard]] std::vector<BoundaryStation> points_at_equal_arcs(const Boundary& boundary, int count);

}  // namespace higherpair
