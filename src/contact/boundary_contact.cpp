#include "higherpair/contact/boundary_contact.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr int kMaxBoundaryPasses = 40;
constexpr double kFlat = 1e12;  // [m per rad] z of two flat curves: a turn takes a contact as far as allowed

struct End {
  SpanPoint point;
  bool corner = false;
  Vector2d p_W, n_W;
};

End end_at(const Boundary& boundary, const BoundaryPlace& place, const Pose<double>& X_WB) {
  const SpanPoint point = boundary.at(place);
  return {point, boundary.is_corner(place), X_WB * point.p_B, X_WB.R_WB * point.n_B};
}

bool are_flat(const End& end1, const End& end2) {
  return !end1.corner && !end2.corner && end1.point.kappa == 0 && end2.point.kappa == 0;
}

// Position of two ends relative to each other, with t = n1 turned +90°.
struct Offset {
  Vector2d n_W, t_W;
  double g = 0, s = 0;  // [m]
  double epsilon = 0;   // angle from n1 to -n2 [rad]
};

Offset offset_of(const End& end1, const End& end2) {
  const Vector2d t = perp(end1.n_W);
  const Vector2d distance = end2.p_W - end1.p_W;
  return {end1.n_W, t, distance.dot(end1.n_W), distance.dot(t),
          std::atan2(-cross(end1.n_W, end2.n_W), -end1.n_W.dot(end2.n_W))};
}

double limited(double x, double most) {
  return std::clamp(x, -most, most);
}

// Stops an iteration where the error is rounding, or is small and no longer decreases.
class Closure {
public:
  explicit Closure(double extent) : extent_(extent) {}

  // \param stopped  by an end: the remaining error may then be the distance beyond it
  [[nodiscard]] bool is_reached(double error, bool stopped = false) {
    const bool reached =
        error <= 4 * kEps * extent_ || (!stopped && error <= kNoiseOfClosure * extent_ && error >= last_ / 2);
    last_ = error;
    return reached;
  }

private:
  double extent_;
  double last_ = kInf;
};

BoundaryContact contact_of(const End& end1, const End& end2, const Offset& offset, double q,
                           const BoundaryPlace& place1, const BoundaryPlace& place2) {
  return {{offset.n_W, end1.p_W, end2.p_W, radius_of(end1.point, end1.corner),
           radius_of(end2.point, end2.corner)},
          q,
          place1,
          place2,
          0};
}

// The nearer end of a flat span that leads on to a span that is not flat, as a place on that one; none if
// neither end does.
std::optional<BoundaryPlace> end_of_flat(const Boundary& boundary, const BoundaryPlace& place) {
  std::optional<SpanEnd> best;
  for (const bool forward : {false, true}) {
    const auto end = end_ahead(boundary, place, forward);
    if (end && !is_flat(boundary, end->behind) && (!best || end->way < best->way)) {
      best = end;
    }
  }
  return best ? std::optional(best->behind) : std::nullopt;
}

// Two flat parts that are not parallel touch beyond an end of one of them. Goes there: past the end that
// comes first in that direction, and on the other boundary to the opposite place. A step of any other length
// might jump across a small fillet to the next flat part, and from there back again. False where the curves
// end.
bool leave_flats(const Boundary& boundary1, BoundaryPlace& place1, const Boundary& boundary2,
                 BoundaryPlace& place2, double turn, double slip) {
  const bool forward = turn > 0;  // along t
  const double sense = forward ? 1 : -1;
  const auto end1 = end_ahead(boundary1, place1, forward);
  const auto end2 = end_ahead(boundary2, place2, !forward);
  if (end1 && !(end2 && end2->way < end1->way)) {
    place1 = end1->behind;
    place2 = boundary2.advance(place2, slip - sense * end1->way, 0).place;
    return true;
  }
  if (end2) {
    place2 = end2->behind;
    place1 = boundary1.advance(place1, slip + sense * end2->way, 0).place;
    return true;
  }
  return false;
}

// One pass along both boundaries; `turn` is E, `slip` is Σ. Returns which one was stopped by an end: 0
// (neither), 1 or 2.
int step_along(const Boundary& boundary1, const End& end1, BoundaryPlace& place1, const Boundary& boundary2,
               const End& end2, BoundaryPlace& place2, double turn, double slip, double longest) {
  if (are_flat(end1, end2) && leave_flats(boundary1, place1, boundary2, place2, turn, slip)) {
    return 0;
  }
  const EquivalentLink link = link_between(end1.point, end1.corner, end2.point, end2.corner);
  const double ds1 = link.z * turn + link.w2 * slip;
  const double ds2 = link.z * turn - link.w1 * slip;
  const auto next1 = boundary1.advance(place1, limited(ds1, longest),
                                       limited(link.w1 * turn + link.w * slip, kMostTurnOfPass));
  const auto next2 = boundary2.advance(place2, limited(-ds2, longest),
                                       limited(-(link.w2 * turn - link.w * slip), kMostTurnOfPass));
  place1 = next1.place;
  place2 = next2.place;
  return next1.stopped ? 1 : next2.stopped ? 2 : 0;
}

// Two flat curves that lie on each other touch along a stretch: the contact is held at the end of one of
// them, where all of its quantities are defined.
void hold_at_end_of_flat(const Boundary& boundary1, BoundaryPlace& place1, const Pose<double>& X_W1,
                         const Boundary& boundary2, BoundaryPlace& place2, const Pose<double>& X_W2) {
  const auto along = [&] {
    return offset_of(end_at(boundary1, place1, X_W1), end_at(boundary2, place2, X_W2)).s;
  };
  if (const auto end1 = end_of_flat(boundary1, place1)) {
    place1 = *end1;
    place2 = boundary2.advance(place2, along(), 0).place;
  } else if (const auto end2 = end_of_flat(boundary2, place2)) {
    place2 = *end2;
    place1 = boundary1.advance(place1, along(), 0).place;
  }
}

double length_scale(const Boundary& boundary1, const Boundary& boundary2) {
  const double least = std::min(boundary1.size(), boundary2.size());
  return least > 0 ? least : std::max(boundary1.size(), boundary2.size());
}

}  // namespace

EquivalentLink link_between(const SpanPoint& point1, bool corner1, const SpanPoint& point2, bool corner2) {
  if (corner1) {
    return {1, 0, point2.kappa, 0};
  }
  if (corner2) {
    return {0, 1, point1.kappa, 0};
  }
  if (point1.kappa == 0 && point2.kappa == 0) {
    return {0.5, 0.5, 0, kFlat};
  }
  const double z = 1 / (point1.kappa + point2.kappa);
  return {point1.kappa * z, point2.kappa * z, point1.kappa * point2.kappa * z, z};
}

BoundaryResult solve_boundary_contact(const BoundaryPair& pair, double u, double q,
                                      const BoundaryPlace& place1, const BoundaryPlace& place2, int branch) {
  const Boundary& boundary1 = *pair.boundary1;
  const Boundary& boundary2 = *pair.boundary2;
  const Pose<double> X_W1 = pose_at(pair.motion1, u);
  const double scale = length_scale(boundary1, boundary2);
  const double longest = kLongestPass * scale;
  BoundaryResult result;
  BoundaryPlace p1 = place1;
  BoundaryPlace p2 = place2;
  const double arm = (pair.motion1.p_WO - pair.motion2.p_WO).norm() + boundary1.size() + scale;
  Closure closure(arm);
  int ended_before = 0;
  bool held = false;
  for (int pass = 0; pass < kMaxBoundaryPasses; ++pass) {
    const Pose<double> X_W2 = pose_at(pair.motion2, q);
    const End end1 = end_at(boundary1, p1, X_W1);
    const End end2 = end_at(boundary2, p2, X_W2);
    const Offset offset = offset_of(end1, end2);
    const Vector2d per_q = velocity_per_q(pair.motion2, end2.p_W);
    const double gap_q = per_q.dot(offset.n_W);
    const double error = std::abs(offset.g) + std::abs(offset.s) + std::abs(offset.epsilon) * scale;
    if (!std::isfinite(error) || (end1.corner && end2.corner)) {
      result.status = ContactStatus::kNoContact;
      return result;
    }
    if (closure.is_reached(error, ended_before != 0)) {
      if (!held && are_flat(end1, end2)) {
        hold_at_end_of_flat(boundary1, p1, X_W1, boundary2, p2, X_W2);
        held = true;
        continue;
      }
      result.contact = contact_of(end1, end2, offset, q, p1, p2);
      result.contact.gap_q = gap_q;
      result.status = branch * gap_q >= 0 ? ContactStatus::kOk : ContactStatus::kOtherBranch;
      return result;
    }
    const double most = pair.motion2.turns ? kMostTurnOfPass : longest;
    const double dq = limited(-offset.g / gap_q, most);
    if (!std::isfinite(dq)) {
      result.status = ContactStatus::kNoContact;
      return result;
    }
    const double turn = offset.epsilon + (pair.motion2.turns ? dq : 0);
    const int ended = step_along(boundary1, end1, p1, boundary2, end2, p2, turn,
                                 offset.s + per_q.dot(offset.t_W) * dq, longest);
    q += dq;
    if (ended != 0 && ended == ended_before && std::abs(dq) <= kNoStepAtEnd * most) {
      result.status = ContactStatus::kNoContact;
      result.ended = ended;
      return result;
    }
    ended_before = ended;
  }
  result.ended = ended_before;
  result.status = ended_before != 0 ? ContactStatus::kNoContact : ContactStatus::kNotConverged;
  return result;
}

std::optional<BoundaryContact> find_boundary_normal(const Boundary& boundary1, const Pose<double>& X_W1,
                                                    const Boundary& boundary2, const Pose<double>& X_W2,
                                                    const BoundaryPlace& place1,
                                                    const BoundaryPlace& place2) {
  const double scale = length_scale(boundary1, boundary2);
  BoundaryPlace p1 = place1;
  BoundaryPlace p2 = place2;
  Closure closure(boundary1.size() + scale);
  for (int pass = 0; pass < kMaxBoundaryPasses; ++pass) {
    const End end1 = end_at(boundary1, p1, X_W1);
    const End end2 = end_at(boundary2, p2, X_W2);
    const Offset offset = offset_of(end1, end2);
    const double error = std::abs(offset.s) + std::abs(offset.epsilon) * scale;
    if (!std::isfinite(error) || (end1.corner && end2.corner)) {
      return std::nullopt;
    }
    if (closure.is_reached(error)) {
      return contact_of(end1, end2, offset, 0, p1, p2);
    }
    // Across a gap g a turn of the normal by δφ1 = w1 ε + w Σ shifts the points by g δφ1: Σ = σ - g δφ1.
    const EquivalentLink link = link_between(end1.point, end1.corner, end2.point, end2.corner);
    const double slip = (offset.s - offset.g * link.w1 * offset.epsilon) / (1 + offset.g * link.w);
    if (step_along(boundary1, end1, p1, boundary2, end2, p2, offset.epsilon, slip, kLongestPass * scale) !=
            0 &&
        pass > 3) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<BoundaryPlace> place_with_normal(const Boundary& boundary, const BoundaryPlace& from,
                                               const Vector2d& n_B) {
  BoundaryPlace place = from;
  for (int pass = 0; pass < kMaxBoundaryPasses; ++pass) {
    const SpanPoint point = boundary.at(place);
    const double turn = std::atan2(cross(point.n_B, n_B), point.n_B.dot(n_B));
    if (std::abs(turn) <= kAtNormal) {
      return place;
    }
    const bool corner = boundary.is_corner(place);
    if (!corner && point.kappa == 0) {
      return std::nullopt;
    }
    const double step = corner ? 0 : limited(turn / point.kappa, kLongestPass * boundary.size());
    const auto next = boundary.advance(place, step, limited(turn, kMostTurnOfPass));
    if (next.stopped) {
      return std::nullopt;
    }
    place = next.place;
  }
  return std::nullopt;
}

}  // namespace higherpair
