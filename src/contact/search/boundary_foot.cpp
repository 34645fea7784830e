#include "boundary_foot.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {

std::optional<BoundaryPlace> foot_near(const Boundary& boundary, const Vector2d& p_B, BoundaryPlace place,
                                       double near) {
  constexpr int kMostPasses = 20;
  bool stopped = false;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const SpanPoint point = boundary.at(place);
    const Vector2d to = p_B - point.p_B;
    const double along = to.dot(perp(point.n_B));
    const double out = to.dot(point.n_B);
    const bool corner = boundary.is_corner(place);
    const double turn = corner ? std::atan2(along, std::max(out, 0.0)) : 0;
    if (std::abs(corner ? turn * out : along) <= near * boundary.size()) {
      return place;
    }
    const double stretch = 1 + point.kappa * out;
    const auto next = boundary.advance(place, stretch > kLeastFootStretch ? along / stretch : along, turn);
    stopped = next.at_end;
    if (next.place.span == place.span && next.place.t == place.t) {
      break;  // it cannot move on
    }
    // Not farther than to the next span: with its curvature the step may be a small part of this one.
    const bool forward = corner ? turn > 0 : along > 0;
    place = next.place.span == place.span
                ? next.place
                : end_of(boundary, boundary.next_span(place.span, forward), !forward);
  }
  return stopped ? std::nullopt : std::optional(place);
}

}  // namespace higherpair
