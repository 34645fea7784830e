#include "higherpair/contact/boundary_contact.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kMaxBoundaryPasses = 40;

// A joint of two spans whose directions differ by too little for a corner, as rounded numbers of a drawing
// have them. Normals between the two are on neither span.
struct Kink {
  Bounds normals;  // angles of the normals on both sides, in the body's frame [rad]
  BoundaryPlace before, after;
  double normal = 0;  // angle of the present normal
};

// The kink at the joint of a span and the one after it; none if they have the same direction there.
std::optional<Kink> kink_between(const Boundary& boundary, int before, int after) {
  if (boundary.next_span(before, true) != after) {
    return std::nullopt;
  }
  const BoundaryPlace end = end_of(boundary, before, true), begin = end_of(boundary, after, false);
  const Vector2d n0 = boundary.at(end).n_B, n1 = boundary.at(begin).n_B;
  const double turn = angle_from_to(n0, n1);
  if (boundary.is_corner(end) || boundary.is_corner(begin) ||
      !(turn > 4 * kEps && turn <= kSameJointDirection)) {
    return std::nullopt;
  }
  return Kink{{angle_of(n0), angle_of(n0) + turn}, end, begin, angle_of(n0) + turn / 2};
}

// A place on a body's boundary, and what update() has found there.
class PairSide {
public:
  const Boundary& boundary;
  Pose<double> X_WB;
  BoundaryPlace place;
  SpanPoint point;
  bool corner = false;  // also at a kink, which is one for the iteration
  Vector2d p_W, n_W;

  PairSide(const Boundary& of, const Pose<double>& X, const BoundaryPlace& at)
      : boundary(of), X_WB(X), place(at) {}

  void update() {
    point = boundary.at(place);
    corner = kink_ || boundary.is_corner(place);
    p_W = X_WB * point.p_B;
    n_W = X_WB.R_WB * (kink_ ? unit_vector(kink_->normal) : point.n_B);
  }

  // Moves by ds along the tangent, or turns by dphi on a corner. Whether an end stops it.
  // \param opposite  the other side: if it is a corner, kinks are ignored
  bool advance(double ds, double dphi, const PairSide& opposite) {
    if (kink_) {
      turn_at_kink(dphi);
      return false;
    }
    const auto next = boundary.advance(place, ds, dphi);
    if (next.place.span != place.span) {
      if (next.place.span == came_from_ && !was_at_kink_ && !opposite.corner && !opposite.kink_) {
        kink_ = ds > 0 ? kink_between(boundary, place.span, came_from_)
                       : kink_between(boundary, came_from_, place.span);
      }
      came_from_ = place.span;
    }
    place = kink_ ? kink_->before : next.place;
    return next.stopped;
  }

  // Of the span, at a kink that of the one before it.
  [[nodiscard]] double radius() const { return radius_of(point, boundary.is_corner(place)); }

private:
  void turn_at_kink(double dphi) {
    kink_->normal += dphi;
    if (!kink_->normals.contains(kink_->normal)) {
      place = kink_->normal < kink_->normals.low ? kink_->before : kink_->after;
      kink_.reset();
      was_at_kink_ = true;
    }
  }

  std::optional<Kink> kink_;
  bool was_at_kink_ = false;
  int came_from_ = -1;  // the span before the last joint that was crossed
};

// On flat curves κ is 0; a turn takes a contact of two of them as far as allowed. \pre not both corners
EquivalentLink link_between(const PairSide& one, const PairSide& two, double scale) {
  const double kappa1 = one.point.kappa;
  const double kappa2 = two.point.kappa;
  if (one.corner) {
    return {1, 0, kappa2, 0};
  }
  if (two.corner) {
    return {0, 1, kappa1, 0};
  }
  if (kappa1 == 0 && kappa2 == 0) {
    return {0.5, 0.5, 0, kSlideOfFlats * scale};
  }
  const double z = 1 / (kappa1 + kappa2);
  return {kappa1 * z, kappa2 * z, kappa1 * kappa2 * z, z};
}

bool are_flat(const PairSide& one, const PairSide& two) {
  return !one.corner && !two.corner && one.point.kappa == 0 && two.point.kappa == 0;
}

// Position of two sides relative to each other, with t = n1 turned +90°.
struct Offset {
  Vector2d n_W, t_W;
  double g = 0, s = 0;  // [m]
  double epsilon = 0;   // angle from n1 to -n2 [rad]
};

Offset offset_of(const PairSide& one, const PairSide& two) {
  const Vector2d t = perp(one.n_W);
  const Vector2d distance = two.p_W - one.p_W;
  return {one.n_W, t, distance.dot(one.n_W), distance.dot(t),
          std::atan2(-cross(one.n_W, two.n_W), -one.n_W.dot(two.n_W))};
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

BoundaryContact contact_of(const PairSide& one, const PairSide& two, double q) {
  return {{one.n_W, one.p_W, two.p_W, one.radius(), two.radius()}, q, one.place, two.place, 0};
}

// An end of the part along which two flats face each other.
struct EndOfFlats {
  bool of_one = true;  // the flat that ends there
  SpanEnd end;
};

// The one that comes first along t or against it; none where the curves end.
std::optional<EndOfFlats> first_end(const PairSide& one, const PairSide& two, bool forward) {
  const auto end1 = end_ahead(one.boundary, one.place, forward);
  const auto end2 = end_ahead(two.boundary, two.place, !forward);
  if (end1 && !(end2 && end2->distance < end1->distance)) {
    return EndOfFlats{true, *end1};
  }
  return end2 ? std::optional(EndOfFlats{false, *end2}) : std::nullopt;
}

// Two flat parts that are not parallel touch beyond an end of one of them. Goes there: past the end that
// comes first in that direction, and on the other boundary to the opposite place. A step of any other length
// might jump across a small fillet to the next flat part, and from there back again. False where the curves
// end.
bool leave_flats(PairSide& one, PairSide& two, double turn, double slip) {
  const bool forward = turn > 0;  // along t
  const auto first = first_end(one, two, forward);
  if (!first) {
    return false;
  }
  const double distance = (forward ? 1 : -1) * first->end.distance;
  if (first->of_one) {
    one.place = first->end.behind;
    two.advance(slip - distance, 0, one);
  } else {
    two.place = first->end.behind;
    one.advance(slip + distance, 0, two);
  }
  return true;
}

// One pass along both boundaries; `turn` is E, `slip` is Σ. Returns which one was stopped by an end: 0
// (neither), 1 or 2.
int step_along(PairSide& one, PairSide& two, double turn, double slip, double scale) {
  if (are_flat(one, two) && leave_flats(one, two, turn, slip)) {
    return 0;
  }
  const EquivalentLink link = link_between(one, two, scale);
  const double longest = kLongestPass * scale;
  const double ds1 = link.z * turn + link.w2 * slip;
  const double ds2 = link.z * turn - link.w1 * slip;
  const bool stopped1 =
      one.advance(limited(ds1, longest), limited(link.w1 * turn + link.w * slip, kMostTurnOfPass), two);
  const bool stopped2 =
      two.advance(limited(-ds2, longest), limited(-(link.w2 * turn - link.w * slip), kMostTurnOfPass), one);
  return stopped1 ? 1 : stopped2 ? 2 : 0;
}

// Two flat curves that lie on each other touch along a stretch: the contact is held at the nearer end of it
// that leads on to a span that is not flat, where all of its quantities are defined.
void hold_at_end_of_flats(PairSide& one, PairSide& two) {
  std::optional<EndOfFlats> nearest;
  for (const bool forward : {false, true}) {
    const auto first = first_end(one, two, forward);
    if (first && !is_flat((first->of_one ? one : two).boundary, first->end.behind) &&
        (!nearest || first->end.distance < nearest->end.distance)) {
      nearest = first;
    }
  }
  if (!nearest) {
    return;
  }
  PairSide& ending = nearest->of_one ? one : two;
  PairSide& other = nearest->of_one ? two : one;
  ending.place = nearest->end.behind;
  one.update();
  two.update();
  other.advance(offset_of(one, two).s, 0, ending);
}

double length_scale(const Boundary& boundary1, const Boundary& boundary2) {
  const double least = std::min(boundary1.size(), boundary2.size());
  return least > 0 ? least : std::max(boundary1.size(), boundary2.size());
}

}  // namespace

BoundaryResult solve_boundary_contact(const BoundaryPair& pair, double u, double q,
                                      const BoundaryPlace& place1, const BoundaryPlace& place2, int branch) {
  PairSide one(*pair.boundary1, pose_at(pair.motion1, u), place1);
  PairSide two(*pair.boundary2, {}, place2);
  const double scale = length_scale(one.boundary, two.boundary);
  const double most = pair.motion2.turns ? kMostTurnOfPass : kLongestPass * scale;
  Closure closure((pair.motion1.p_WO - pair.motion2.p_WO).norm() + one.boundary.size() + scale);
  int ended_before = 0;
  bool held = false;
  for (int pass = 0; pass < kMaxBoundaryPasses; ++pass) {
    two.X_WB = pose_at(pair.motion2, q);
    one.update();
    two.update();
    const Offset offset = offset_of(one, two);
    const Vector2d per_q = velocity_per_q(pair.motion2, two.p_W);
    const double gap_q = per_q.dot(offset.n_W);
    const double error = std::abs(offset.g) + std::abs(offset.s) + std::abs(offset.epsilon) * scale;
    if (!std::isfinite(error) || (one.corner && two.corner)) {
      return {ContactStatus::kNoContact, {}};
    }
    if (closure.is_reached(error, ended_before != 0)) {
      if (!held && are_flat(one, two)) {
        hold_at_end_of_flats(one, two);
        held = true;
        continue;
      }
      BoundaryContact contact = contact_of(one, two, q);
      contact.gap_q = gap_q;
      return {branch * gap_q >= 0 ? ContactStatus::kOk : ContactStatus::kOtherBranch, contact};
    }
    const double dq = limited(-offset.g / gap_q, most);
    if (!std::isfinite(dq)) {
      return {ContactStatus::kNoContact, {}};
    }
    const double turn = offset.epsilon + (pair.motion2.turns ? dq : 0);
    const int ended = step_along(one, two, turn, offset.s + per_q.dot(offset.t_W) * dq, scale);
    q += dq;
    if (ended != 0 && ended == ended_before && std::abs(dq) <= kNoStepAtEnd * most) {
      return {ContactStatus::kNoContact, {}};
    }
    ended_before = ended;
  }
  return {ended_before != 0 ? ContactStatus::kNoContact : ContactStatus::kNotConverged, {}};
}

std::optional<BoundaryContact> find_boundary_normal(const Boundary& boundary1, const Pose<double>& X_W1,
                                                    const Boundary& boundary2, const Pose<double>& X_W2,
                                                    const BoundaryPlace& place1,
                                                    const BoundaryPlace& place2) {
  PairSide one(boundary1, X_W1, place1);
  PairSide two(boundary2, X_W2, place2);
  const double scale = length_scale(boundary1, boundary2);
  Closure closure(boundary1.size() + scale);
  bool held = false;
  for (int pass = 0; pass < kMaxBoundaryPasses; ++pass) {
    one.update();
    two.update();
    const Offset offset = offset_of(one, two);
    const double error = std::abs(offset.s) + std::abs(offset.epsilon) * scale;
    if (!std::isfinite(error) || (one.corner && two.corner)) {
      return std::nullopt;
    }
    // Two flats that are not parallel touch beyond their ends, however little they are inclined.
    const bool leaves = are_flat(one, two) && std::abs(offset.epsilon) > kParallelFlats &&
                        first_end(one, two, offset.epsilon > 0);
    if (closure.is_reached(error) && !leaves) {
      if (!held && are_flat(one, two)) {
        hold_at_end_of_flats(one, two);
        held = true;
        continue;
      }
      return contact_of(one, two, 0);
    }
    // Across a gap g a turn of the normal by δφ1 = w1 ε + w Σ shifts the points by g δφ1: Σ = σ - g δφ1.
    const EquivalentLink link = link_between(one, two, scale);
    const double slip = (offset.s - offset.g * link.w1 * offset.epsilon) / (1 + offset.g * link.w);
    if (step_along(one, two, offset.epsilon, slip, scale) != 0 && pass > 3) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<BoundaryPlace> place_with_normal(const Boundary& boundary, const BoundaryPlace& from,
                                               const Vector2d& n_B) {
  BoundaryPlace place = from;
  int came_from = -1;
  for (int pass = 0; pass < kMaxBoundaryPasses; ++pass) {
    const SpanPoint point = boundary.at(place);
    const double turn = angle_from_to(point.n_B, n_B);
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
    if (next.place.span != place.span) {
      if (next.place.span == came_from && std::abs(turn) <= kSameJointDirection) {
        return place;  // at a kink, see above
      }
      came_from = place.span;
    }
    place = next.place;
  }
  return std::nullopt;
}

}  // namespace higherpair
