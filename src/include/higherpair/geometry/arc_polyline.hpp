#pragma once

#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/tolerances.hpp"

#include <vector>

#include <Eigen/Geometry>

namespace higherpair {

/// A vertex of an arc polyline and the bulge of the piece to the next vertex, as drawings define it: the
/// tangent of a quarter of the arc's angle, > 0 counter-clockwise; 0: a straight line.
struct ArcVertex {
  Vector2d p_B = Vector2d::Zero();
  double bulge = 0;
};

/// Arcs and straight lines from vertex to vertex; a closed one returns to its first vertex. The last bulge of
/// an open one is ignored.
struct ArcPolyline {
  std::vector<ArcVertex> vertices;
  bool closed = false;
};

/// The finest tolerance to which a boundary can be approximated [m]: 1e-9 of its size, or the rounding of its
/// coordinates where that is more.
[[nodiscard]] double finest_tolerance(const Boundary& boundary);

/// Approximates a boundary by arcs and lines that deviate from it by at most `tolerance` [m] and share its
/// tangents at their joints. Lines and arcs are kept, in parts of at most a quarter turn; any other span is
/// halved until a pair of arcs with the tangents of its ends (a biarc whose arcs have tangents of equal
/// length, as in Bolton, Biarc curves, Computer-Aided Design 7, 1975) is close enough at 16 places, or more
/// where several pieces of a spline or stretches of a law are on the way: each has places of its own. The
/// error of a biarc falls with the cube of its length, so the number of biarcs grows with tolerance^(-1/3).
/// \param tolerance  at least finest_tolerance(boundary)
/// \pre the boundary keeps its shape: finest_tolerance(boundary) <= kCoarsestShape of its size
[[nodiscard]] ArcPolyline arc_polyline(const Boundary& boundary, double tolerance);

/// The least upright box that contains it [m].
[[nodiscard]] Eigen::AlignedBox2d box_of(const ArcPolyline& line);

}  // namespace higherpair
