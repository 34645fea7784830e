#pragma once

#include "higherpair/geometry/boundary.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <cmath>
#include <optional>

namespace higherpair {

/// The parameter range of a span.
[[nodiscard]] inline Bounds range_of(const Boundary& boundary, int span) {
  return boundary.spans()[span]->range();
}

/// The beginning or the end of a span.
[[nodiscard]] inline BoundaryPlace end_of(const Boundary& boundary, int span, bool high) {
  const Bounds range = range_of(boundary, span);
  return {span, high ? range.high : range.low};
}

/// Signed distance along the span from a place to the parameter t, estimated by the speed at the place:
/// negative against the sense of the parameter [m, on corners rad].
[[nodiscard]] inline double distance_along(const Boundary& boundary, const BoundaryPlace& from, double t) {
  return (t - from.t) * boundary.at(from).speed;
}

/// Whether a place is at the end (`high`) or the beginning of its span.
/// \param near  largest distance that counts as there, relative to the boundary's size; on corners [rad]
[[nodiscard]] inline bool is_at_end(const Boundary& boundary, const BoundaryPlace& place, bool high,
                                    double near) {
  return std::abs(distance_along(boundary, place, end_of(boundary, place.span, high).t)) <=
         near * (boundary.is_corner(place) ? 1 : boundary.size());
}

/// Whether it is at either of them.
[[nodiscard]] inline bool is_at_an_end(const Boundary& boundary, const BoundaryPlace& place, double near) {
  return is_at_end(boundary, place, false, near) || is_at_end(boundary, place, true, near);
}

/// An end of a span as seen from a place on it.
struct SpanEnd {
  BoundaryPlace behind;  ///< the same point on the adjacent span
  double distance = 0;   ///< absolute value of distance_along() to it
};

/// The end of the span ahead of a place, in the sense of the parameter or against it; none where the curve
/// itself ends or has a concave corner.
[[nodiscard]] inline std::optional<SpanEnd> end_ahead(const Boundary& boundary, const BoundaryPlace& from,
                                                      bool forward) {
  const int next = boundary.next_span(from.span, forward);
  const SpanJoint joint = boundary.joint_after(forward ? from.span : next);
  if (joint == SpanJoint::kEnd || joint == SpanJoint::kNotch) {
    return std::nullopt;
  }
  const double distance = distance_along(boundary, from, end_of(boundary, from.span, forward).t);
  return SpanEnd{end_of(boundary, next, !forward), std::abs(distance)};
}

/// Whether a boundary is straight at a place.
[[nodiscard]] inline bool is_flat(const Boundary& boundary, const BoundaryPlace& place) {
  return !boundary.is_corner(place) && boundary.at(place).kappa == 0;
}

/// The signed radius of curvature at a point of a boundary: > 0 where the body is convex, 0 at a corner,
/// infinite where it is straight [m].
[[nodiscard]] inline double radius_of(const SpanPoint& point, bool corner) {
  return corner ? 0 : point.kappa == 0 ? kInf : 1 / point.kappa;
}

}  // namespace higherpair
