#pragma once

#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/tolerances.hpp"

#include <vector>

namespace higherpair {

/// A corner of an arc polyline, and how it goes on from there: the tangent of a quarter of the angle of the
/// arc to the next vertex, > 0 counter-clockwise; 0: a straight line. A drawing calls that a bulge.
struct ArcVertex {
  Vector2d p_B = Vector2d::Zero();
  double bulge = 0;
};

/// Arcs and straight lines from vertex to vertex; a closed one goes back to its first. The bulge of the last
/// vertex of an open one means nothing.
struct ArcPolyline {
  std::vector<ArcVertex> vertices;
  bool closed = false;
};

/// A boundary by arcs and lines that leave it by no more than `tolerance` [m] and have its tangents at their
/// joints: lines and arcs are themselves, in parts of at most a quarter turn; any other span is halved until
/// a pair of arcs with the tangents of its ends (a biarc whose arcs have tangents of equal length, as in
/// Bolton, Biarc curves, Computer-Aided Design 7, 1975) is near enough at 16 places. The error of a biarc
/// falls with the cube of its length, so their number grows with tolerance^(-1/3).
/// \param tolerance  at least kFinestTolerance of the boundary's size
[[nodiscard]] ArcPolyline arc_polyline(const Boundary& boundary, double tolerance);

}  // namespace higherpair
