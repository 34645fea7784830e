#include "boundary_trace.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {

std::optional<SheetPoint> BoundaryTrace::at(const TracePath& path, const TraceLeg& leg, double share) const {
  const TangencySheet& sheet = this->sheet(path.opposed);
  const auto found = place_on(sheet, leg.step, share);
  if (!found) {
    return std::nullopt;
  }
  SheetPoint point = found->at;
  const double part = leg.share_a == leg.share_b ? 0 : (share - leg.share_a) / (leg.share_b - leg.share_a);
  if (sheet.pair().motion1.turns) {
    point.u = nearest_turn(point.u, leg.u_a + part * (leg.u_b - leg.u_a)) + path.shift_u;
  }
  if (sheet.pair().motion2.turns) {
    point.q = nearest_turn(point.q, leg.q_a + part * (leg.q_b - leg.q_a)) + path.shift_q;
  }
  return point;
}

std::optional<SheetPoint> BoundaryTrace::at(const TracePath& path, double u) const {
  const double round = path.turn_u > 0 ? std::floor((u - path.begin_u()) / path.turn_u) : 0;
  const double wanted = u - round * path.turn_u - path.shift_u;
  auto leg = std::partition_point(path.legs.begin(), path.legs.end(),
                                  [&](const TraceLeg& one) { return one.u_b < wanted; });
  // u may be past the last leg by rounding.
  leg = leg == path.legs.end() ? leg - 1 : leg;
  const double from = leg->share_a;
  const double length = leg->share_b - from;
  const auto error = [&](double x) {
    const auto there = at(path, *leg, from + x);
    return there ? there->u - path.shift_u - wanted : kNoValue;
  };
  double share = from;
  if (leg->u_b - wanted <= 0) {
    share = leg->share_b;
  } else if (leg->u_a < wanted) {
    const auto x = root_between(error, error(0), length, error(length));
    if (!x) {
      return std::nullopt;
    }
    share += *x;
  }
  auto point = at(path, *leg, share);
  if (point) {
    point->u = u;
    point->q += round * path.turn_q;
  }
  return point;
}

bool BoundaryTrace::is_free(bool opposed, const SheetPoint& at) const {
  const BoundaryPair& pair = opposed_.pair();
  const double size = pair.boundary1->size() + pair.boundary2->size();
  if (!opposed || at.curvature_sum < -kNotConcave / size) {
    return false;
  }
  return !bodies_overlap(*pair.boundary1, pose_at(pair.motion1, at.u), *pair.boundary2,
                         pose_at(pair.motion2, at.q), kTouchingDepth * size);
}

}  // namespace higherpair
