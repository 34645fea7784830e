#pragma once

#include "higherpair/geometry/curve_queries.hpp"

#include <optional>

// The gap of two bodies as a function of the normal, g(n) = (p2 - p1)·n with the points p1, p2 of outward
// normals n and -n, and bounds of it on an arc of normals.

namespace higherpair {

/// F is g for two convex bodies, -g for a body in a ring: wanted are its maxima.
struct GapProblem {
  PlacedCurve<double> first;
  PlacedCurve<double> second;
  double sign = 1;  ///< F = sign g
};

/// F and dF/dφ [m], and ρ1 + ρ2, at one normal; F″ = -sign (ρ1 + ρ2) - F.
struct GapValue {
  double f = 0;
  double slope = 0;
  double rho_sum = 0;
};

[[nodiscard]] GapValue gap_value(const GapProblem& problem, const Vector2d& n);

/// Bounds of -sign (ρ1 + ρ2) = F″ + F for all normals within `half` (at most 45°) of n.
[[nodiscard]] Bounds curvature_bounds(const GapProblem& problem, const Vector2d& n,
                                      const Rotation<double>& half);

/// The largest value that F can take within `half` of the normal of `value`, if F″ + F <= R there: F is at
/// most R + (F_m - R) cos δ + F′_m sin δ.
[[nodiscard]] double largest_gap(const GapValue& value, const Rotation<double>& half, double R);

/// The normals n for which both bodies have points.
struct CommonNormals {
  std::optional<NormalArc> arc;  ///< none: all normals
  bool empty = false;
  bool cover_ring = true;  ///< whether these are all normals of the ring, if one of the bodies is a ring
};

[[nodiscard]] CommonNormals common_normals(const GapProblem& problem, bool ring1, bool ring2);

}  // namespace higherpair
