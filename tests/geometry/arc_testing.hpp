#pragma once

#include "geometry/span_testing.hpp"
#include "higherpair/geometry/arc_polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace higherpair::testing {

/// Distance of a point from an arc, whose centre and radius follow from its chord and bulge.
inline double distance_from_arc(const Vector2d& p, const ArcVertex& a, const Vector2d& to) {
  const Vector2d chord = to - a.p_B;
  const Vector2d middle = (a.p_B + to) / 2;
  if (a.bulge == 0) {
    const double along = std::clamp((p - a.p_B).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    return (p - a.p_B - along * chord).norm();
  }
  const double sweep = 4 * std::atan(a.bulge);
  const double radius = chord.norm() / 2 / std::sin(std::abs(sweep) / 2);
  const Vector2d center =
      middle + perp(chord).normalized() * (std::copysign(radius, sweep) * std::cos(sweep / 2));
  const Vector2d arm = p - center;
  const double half = std::acos(std::clamp(arm.normalized().dot((middle - center).normalized()), -1.0, 1.0));
  return half <= std::abs(sweep) / 2 ? std::abs(arm.norm() - radius)
                                     : std::min((p - a.p_B).norm(), (p - to).norm());
}

/// The largest distance of any of these points from a polyline of arcs.
inline double worst_distance(const std::vector<Vector2d>& points, const ArcPolyline& line) {
  Worst worst;
  for (const Vector2d& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.vertices.size(); ++i) {
      least = std::min(
          least, distance_from_arc(p, line.vertices[i], line.vertices[(i + 1) % line.vertices.size()].p_B));
    }
    worst.see(least);
  }
  return worst.value();
}

inline double worst_distance(const Boundary& curve, const ArcPolyline& line) {
  std::vector<Vector2d> points;
  for (const SpanPtr& span : curve.spans()) {
    const Bounds range = span->range();
    constexpr int kMany = 3001;
    for (int k = 0; k <= kMany; ++k) {
      points.push_back(span->at(range.low + range.width() * k / kMany).p_B);
    }
  }
  return worst_distance(points, line);
}

}  // namespace higherpair::testing
