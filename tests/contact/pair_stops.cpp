#include "contact/pair_stops.hpp"

#include "contact/touch/last_step.hpp"
#include "higherpair/contact/common_normal.hpp"
#include "higherpair/contact/gap_scale.hpp"
#include "higherpair/contact/step_agreement.hpp"
#include "higherpair/geometry/curve_queries.hpp"

#include <cmath>

namespace higherpair {
namespace {

constexpr double kIsCrossing = 1e-12;       // relative to its scale: ∂gap/∂q counts as 0
constexpr double kBackFromCrossing = 4e-3;  // relative to the driver's unit: distance of a regular position
constexpr double kSmooth = 1e-7;            // relative to dq/du: largest difference of its two interpolations
constexpr double kRounding = 1e-14;         // relative to q
constexpr double kNearLimit = 1e-7;         // relative to its scale: ∂gap/∂q near a limit
constexpr double kAtLimit = 1e-14;          // relative to the driver's scale: the limit is at its position
constexpr double kClosed = 1e-13;           // relative to the lengths: gap left by an interpolated crossing

// For bodies next to a crossing of branches: sets the contact points, the normal (close to n_W) and ∂gap/∂q.
// False where the bodies do not touch.
bool close_at(const FollowedContact& track, const Vector2d& n_W, ContactPosition& at) {
  const auto& [curve1, motion1, curve2, motion2] = track.pair;
  const auto touch = find_common_normal(curve1, pose_at(motion1, at.u), curve2, pose_at(motion2, at.q), n_W);
  if (!touch || !((touch->p2_W - touch->p1_W).norm() <= kClosed * (track.size + manhattan(touch->p1_W)))) {
    return false;
  }
  static_cast<CommonNormal&>(at) = *touch;
  at.sliding =
      (at.dq * velocity_per_q(motion2, at.p1_W) - velocity_per_q(motion1, at.p1_W)).dot(perp(at.n_W));
  at.gap_q = at.n_W.dot(velocity_per_q(motion2, at.p2_W));
  at.gap_q = at.gap_q * at.gap_q <= kIsCrossing * kIsCrossing * gap_q_scale2(track.pair, at) ? 0 : at.gap_q;
  return true;
}

// Takes over a position at, or next to, a crossing that is interpolated from the smooth motion instead of
// solved for. A position exactly at the crossing counts as beyond it.
void accept_interpolated(FollowedContact& track, const ContactPosition& at) {
  accept(track, at, at.gap_q * track.branch > 0 ? track.branch : -track.branch);
  track.interpolated = true;
}

// Moves along the smooth motion to a regular position at some distance from u, which is next to a crossing.
void step_back(FollowedContact& track, double u) {
  const double distance = kBackFromCrossing * unit_of(track.pair.motion1, track);
  const double rest = u - track.at.u;
  if (std::abs(rest) >= distance) {
    return;
  }
  const double h = rest - std::copysign(distance, rest);
  const bool same = (track.at.gap_q + h * track.at.dgap_q) * track.branch > 0;
  const int branch = same ? track.branch : -track.branch;
  const Step back = try_step(track, h, branch);
  if (agrees(back, kCrossingAgreement)) {
    accept(track, back.result.at, branch);
  }
}

// Hermite interpolation halfway between two positions h apart, with the rates of a smooth motion. Its error
// is of order h⁴ in d²q and dφ, and of order h⁶ in q. Nothing where the motion is not that smooth.
std::optional<ContactPosition> halfway(const FollowedContact& track, const ContactPosition& b, double h) {
  const ContactPosition& a = track.at;
  const double fast = std::abs(a.dq) + std::abs(b.dq);
  const double dq = (a.dq + b.dq) / 2 + h * (a.d2q - b.d2q) / 8;
  const double rise = 15 * (b.q - a.q) / (8 * h) - 7 * (a.dq + b.dq) / 16 + h * (b.d2q - a.d2q) / 32;
  const double rounding = kRounding * (std::abs(a.q) + unit_of(track.pair.motion2, track)) / std::abs(h);
  if (!(std::abs(dq - rise) <= kSmooth * fast + rounding)) {
    return std::nullopt;
  }
  ContactPosition at = b;
  at.u = a.u + h / 2;
  at.q = (a.q + b.q) / 2 + h * (10 * (a.dq - b.dq) + h * (a.d2q + b.d2q)) / 64;
  at.dq = dq;
  at.d2q = 1.5 * (b.dq - a.dq) / h - (a.d2q + b.d2q) / 4;
  at.dphi = 1.5 * angle_between(a.n_W, b.n_W) / h - (a.dphi + b.dphi) / 4;
  at.dgap_q = (a.dgap_q + b.dgap_q) / 2;
  at.n_W = Rotation<double>::from_angle(h * (a.dphi - b.dphi) / 8) * Vector2d(a.n_W + b.n_W).normalized();
  return at;
}

}  // namespace

bool stop_at_crossing(FollowedContact& track, double u) {
  if (std::abs(u - track.at.u) > kNearCrossing * unit_of(track.pair.motion1, track)) {
    return false;
  }
  FollowedContact before = track;
  step_back(before, u);
  const double h = 2 * (u - before.at.u);
  const Step beyond = try_step(before, h, -before.branch);
  if (!agrees(beyond, kCrossingAgreement)) {
    return false;
  }
  auto at = halfway(before, beyond.result.at, h);
  // Between two contacts on different branches there may also be two limits with no contact in between.
  if (!at || !close_at(before, at->n_W, *at)) {
    return false;
  }
  at->u = u;
  track = before;
  accept_interpolated(track, *at);
  return true;
}

bool pass_crossing(FollowedContact& track, const LimitPosition& limit) {
  const Step beyond = try_step(track, 2 * (limit.u - track.at.u), -track.branch);
  if (limit.u == track.at.u || !agrees(beyond, kCrossingAgreement)) {
    return false;
  }
  accept(track, beyond.result.at, -track.branch);
  return true;
}

bool stop_at_limit(FollowedContact& track, double u, const LimitPosition& limit) {
  const auto& [curve1, motion1, curve2, motion2] = track.pair;
  const Vector2d vertex1_W = pose_at(motion1, u) * anchor(curve1);
  const double length = (pose_at(motion2, limit.q) * anchor(curve2) - vertex1_W).norm();
  if (!(std::abs(limit.u - u) <= kAtLimit * ((motion1.turns ? 1 : length) + std::abs(u)))) {
    return false;
  }
  ContactPosition at = track.at;
  at.u = u;
  at.q = limit.q;
  at.dq = at.d2q = at.dphi = at.dgap_q = 0;
  // A contact that runs off along an open curve has no last position.
  if (!close_at(track, at.n_W, at) ||
      !((at.p2_W - at.p1_W).norm() <= kClosed * (length + manhattan(vertex1_W)))) {
    return false;
  }
  at.gap_q = 0;
  accept(track, at, track.branch);
  track.d3q = track.d2phi = track.d3phi = 0;
  return true;
}

bool has_come_to_limit(FollowedContact& track, std::optional<LimitPosition>& limit) {
  const double gap_q = track.at.gap_q;
  const bool near = gap_q * gap_q <= kNearLimit * kNearLimit * gap_q_scale2(track.pair, track.at);
  if (!near || track.interpolated) {
    return false;
  }
  const auto found = limit_near(track.pair, track.at, track.size);
  if (!found || !stop_at_limit(track, track.at.u, *found)) {
    return false;
  }
  limit = found;
  return true;
}

}  // namespace higherpair
