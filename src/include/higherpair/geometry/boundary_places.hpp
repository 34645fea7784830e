#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace higherpair {

/// The parameters of a span, from its begin to its end.
[[nodiscard]] inline Bounds range_of(const Boundary& boundary, int span) {
  return boundary.spans()[static_cast<std::size_t>(span)]->range();
}

/// The begin or the end of a span.
[[nodiscard]] inline BoundaryPlace end_of(const Boundary& boundary, int span, bool high) {
  const Bounds range = range_of(boundary, span);
  return {span, high ? range.high : range.low};
}

/// An end of a span as seen from a place on it.
struct SpanEnd {
  BoundaryPlace behind;  ///< the same point on the span that goes on from there
  double way = 0;        ///< along the boundary, by the speed at the place [m]
};

/// The end of its span ahead of a place, in the sense of the parameter or against it; none where the curve
/// itself ends or has a concave corner.
[[nodiscard]] inline std::optional<SpanEnd> end_ahead(const Boundary& boundary, const BoundaryPlace& from,
                                                      bool forward) {
  const int next = boundary.next_span(from.span, forward);
  const SpanJoint joint = boundary.joint_after(forward ? from.span : next);
  if (joint == SpanJoint::kEnd || joint == SpanJoint::kNotch) {
    return std::nullopt;
  }
  const double left = std::abs(end_of(boundary, from.span, forward).t - from.t);
  return SpanEnd{end_of(boundary, next, !forward), left * boundary.at(from).speed};
}

/// Whether a boundary is straight at a place.
[[nodiscard]] inline bool is_flat(const Boundary& boundary, const BoundaryPlace& place) {
  return !boundary.is_corner(place) && boundary.at(place).kappa == 0;
}

/// The signed radius of curvature at a point of a boundary: > 0 where the body is convex, 0 at a corner,
/// infinite where it is straight [m].
[[nodiscard]] inline double radius_of(const SpanPoint& point, bool corner) {
  return corner ? 0 : point.kappa == 0 ? std::numeric_limits<double>::infinity() : 1 / point.kappa;
}

}  // namespace higherpair
