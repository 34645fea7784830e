#include "outlines.hpp"

#include "analysis/tolerances.hpp"
#include "higherpair/contact/least_gaps.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <cmath>

namespace higherpair {
namespace {

bool is_beside(const Boundary& boundary, int corner, int span) {
  return span == corner || span == boundary.next_span(corner, true) ||
         span == boundary.next_span(corner, false);
}

// The corner at a place, which may be its span or the next one.
std::optional<int> corner_at(const Boundary& boundary, const BoundaryPlace& at) {
  if (boundary.is_corner(at)) {
    return at.span;
  }
  for (const bool high : {false, true}) {
    const int next = boundary.next_span(at.span, high);
    if (is_at_end(boundary, at, high, kAtSpanEnd) &&
        boundary.joint_after(high ? at.span : next) != SpanJoint::kEnd &&
        boundary.spans()[next]->is_corner()) {
      return next;
    }
  }
  return std::nullopt;
}

// The corners of both boundaries, if the contact is where they meet.
std::optional<std::array<int, 2>> meeting_corners(const Boundary& boundary1, const Boundary& boundary2,
                                                  const ContactMotion& at) {
  if (!at.touches || (!boundary1.is_corner(at.place[0]) && !boundary2.is_corner(at.place[1]))) {
    return std::nullopt;
  }
  const auto corner1 = corner_at(boundary1, at.place[0]), corner2 = corner_at(boundary2, at.place[1]);
  return corner1 && corner2 ? std::optional(std::array{*corner1, *corner2}) : std::nullopt;
}

SmallerBody smaller_of(const Boundary& boundary1, const Boundary& boundary2) {
  const bool is_first = boundary1.size() < boundary2.size();
  const Boundary& smaller = is_first ? boundary1 : boundary2;
  return {is_first, smaller.middle_B(), smaller.size()};
}

// The body in the ring.
SmallerBody smaller_of(const Curve& curve1, const Curve& curve2) {
  const bool is_first = curve2.side == Side::kOutside;
  const Curve& smaller = is_first ? curve1 : curve2;
  const Vector2d middle_B = middle_of(smaller).value_or(anchor(smaller));
  return {is_first, middle_B, reach_from(smaller, middle_B).value_or(kInf)};
}

}  // namespace

double SmallerBody::speed(const Pairing& at) const {
  const BodyMotion& own = is_first ? at.body1 : at.body2;
  const BodyMotion& other = is_first ? at.body2 : at.body1;
  const PointMotion middle = point_motion(own, middle_B);
  const PointMotion there = motion_at_place(other, middle.p_W);
  const double omega = std::abs(own.omega - other.omega);
  return (middle.v_W - there.v_W).norm() + (omega == 0 ? 0 : omega * reach);
}

BoundaryOutlines::BoundaryOutlines(const Mechanism& mechanism, const Contact& contact,
                                   const ContactMotion& at)
    : boundary1_(boundary_of(mechanism, contact.first)),
      boundary2_(boundary_of(mechanism, contact.second)),
      smaller_(smaller_of(boundary1_, boundary2_)),
      corners_(meeting_corners(boundary1_, boundary2_, at)) {}

std::vector<NearPlace> BoundaryOutlines::near(const Pairing& at, double reach) const {
  return near_places(boundary1_, at.body1.X_WB, boundary2_, at.body2.X_WB, reach);
}

std::optional<NearPlace> BoundaryOutlines::moved(const Pairing& to, const NearPlace& before) const {
  return moved_place(boundary1_, to.body1.X_WB, boundary2_, to.body2.X_WB, before);
}

bool BoundaryOutlines::leaves_corners(const NearPlace& place) const {
  if (!corners_ || place.end != 0) {
    return false;
  }
  const auto [corner1, corner2] = *corners_;
  return (place.place1.span == corner1 && is_beside(boundary2_, corner2, place.place2.span)) ||
         (place.place2.span == corner2 && is_beside(boundary1_, corner1, place.place1.span));
}

CurveOutlines::CurveOutlines(const Mechanism& mechanism, const Contact& contact, double size)
    : curve1_(curve_of(mechanism, contact.first)),
      curve2_(curve_of(mechanism, contact.second)),
      smaller_(smaller_of(curve1_, curve2_)),
      size_(size) {}

std::vector<NearPlace> CurveOutlines::near(const Pairing& at, double reach) const {
  std::vector<NearPlace> places;
  const Vector2d* own = at.own ? &at.own->n_W : nullptr;
  for (const CommonNormal& least : least_gaps(curve1_, at.body1.X_WB, curve2_, at.body2.X_WB, reach, own)) {
    places.push_back({least, {}, {}});
  }
  return places;
}

std::optional<NearPlace> CurveOutlines::moved(const Pairing& to, const NearPlace& before) const {
  if (before.end != 0) {
    return std::nullopt;
  }
  const auto at = moved_least_gap(curve1_, to.body1.X_WB, curve2_, to.body2.X_WB, before.at);
  return at ? std::optional(NearPlace{*at, {}, {}}) : std::nullopt;
}

bool CurveOutlines::overlap_far_out(const Pairing& at) const {
  return higherpair::overlap_far_out(curve1_, at.body1.X_WB, curve2_, at.body2.X_WB);
}

}  // namespace higherpair
