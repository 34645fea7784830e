#include "higherpair/contact/tracker.hpp"

#include "contact_points.hpp"
#include "higherpair/contact/common_normal.hpp"
#include "higherpair/contact/finder.hpp"
#include "inner_step.hpp"
#include "last_step.hpp"
#include "limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr double kAgreement = 0.25;  // of the change of a step: distance between prediction and solution
constexpr double kCrossingAgreement = 0.03;  // the same where the branch is to change
constexpr double kNearCrossing = 5e-3;   // of the driver's scale: how near a crossing is interpolated over
constexpr double kClosed = 1e-13;        // of the lengths: gap that an interpolated crossing may leave
constexpr int kHalvingsToLimit = 4;      // halvings before a limit position is looked for
constexpr int kAttempts = 2000;          // inner steps that may fail
constexpr double kMostSteps = 2e5;       // of kMaxTurn that a way may be long; so many more inner steps
constexpr double kSmallestStep = 1e-14;  // of the driver's scale

// One inner step; where ∂gap/∂q is predicted to change sign while the motion stays smooth, branches cross.
bool step_by(ContactTrack& track, double h, double predicted_gap_q) {
  if (predicted_gap_q * track.at.gap_q < 0) {
    const Step crossing = try_step(track, h, -track.branch);
    if (agrees(crossing, kCrossingAgreement)) {
      accept(track, crossing.result.at, -track.branch);
      return true;
    }
    // A limit may lie within the step, with the branch there again beyond it: shorter steps will tell.
    return false;
  }
  const Step step = try_step(track, h, track.branch);
  if (!agrees(step, kAgreement)) {
    return false;
  }
  accept(track, step.result.at, track.branch);
  return true;
}

// The driver stops (nearly) where branches cross, `rest` ahead: the closure has lost its rank there. The
// position is interpolated between here and a place just beyond; its gap_q is exactly 0 and its rates are
// those of the smooth motion.
bool stop_at_crossing(ContactTrack& track, double rest) {
  if (std::abs(rest) > kNearCrossing * unit_of(track.pair.motion1, track)) {
    return false;
  }
  const double h = 2 * rest;
  const Step beyond = try_step(track, h, -track.branch);
  if (!agrees(beyond, kCrossingAgreement)) {
    return false;
  }
  const ContactPosition& a = track.at;
  const ContactPosition& b = beyond.result.at;
  // Hermite interpolation: h⁴ is left out of the rates, h⁶ of q; the normal is found. Rounding counts as its
  // share of the squared distance from the crossing there, which is why the distance is not made smaller.
  const auto middle = [h](double from, double to, double rate_from, double rate_to) {
    return (from + to) / 2 + h * (rate_from - rate_to) / 8;
  };
  const auto rate_in_middle = [h](double change, double rate_from, double rate_to) {
    return 1.5 * change / h - (rate_from + rate_to) / 4;
  };
  ContactPosition at = b;
  at.u = a.u + rest;
  at.q = (a.q + b.q) / 2 + h * (10 * (a.dq - b.dq) + h * (a.d2q + b.d2q)) / 64;
  at.dq = middle(a.dq, b.dq, a.d2q, b.d2q);
  at.d2q = rate_in_middle(b.dq - a.dq, a.d2q, b.d2q);
  at.dphi = rate_in_middle(angle_between(a.n_W, b.n_W), a.dphi, b.dphi);
  at.gap_q = 0;
  const Vector2d n_W =
      Rotation<double>::from_angle(h * (a.dphi - b.dphi) / 8) * Vector2d(a.n_W + b.n_W).normalized();
  const auto touch = find_common_normal(track.pair.curve1, pose_at(track.pair.motion1, at.u),
                                        track.pair.curve2, pose_at(track.pair.motion2, at.q), n_W);
  // Between two contacts of different branches there may also be a limit of each, and no contact at all.
  if (!touch || !((touch->p2_W - touch->p1_W).norm() <= kClosed * (track.size + manhattan(touch->p1_W)))) {
    return false;
  }
  at.n_W = touch->n_W;
  at.p1_W = touch->p1_W;
  at.p2_W = touch->p2_W;
  at.rho1 = touch->rho1;
  at.rho2 = touch->rho2;
  at.sliding =
      (at.dq * velocity_per_q(track.pair.motion2, at.p1_W) - velocity_per_q(track.pair.motion1, at.p1_W))
          .dot(perp(at.n_W));
  accept(track, at, -track.branch);
  return true;
}

// The limit lies ahead, not further than the step that failed and the few before it, and the motion leads to
// it: near a limit q changes with the root of the distance, so that twice the present rate leads there.
bool is_ahead(const ContactTrack& track, const LimitPosition& limit, double h) {
  const ContactPosition& at = track.at;
  const double unit1 = unit_of(track.pair.motion1, track);
  const double unit2 = unit_of(track.pair.motion2, track);
  const double distance = (limit.u - at.u) * (h > 0 ? 1 : -1);
  const double way = 2 * (limit.u - at.u) * at.dq;
  return distance >= -1e-12 * (unit1 + std::abs(at.u)) && distance <= 64 * std::abs(h) &&
         std::abs(limit.q - at.q - way) <= std::abs(way) / 2 + 1e-6 * unit2;
}

// What stands in the way of a step towards u that failed: the limit if it can be located, the present place
// if the steps have become too small.
std::optional<LimitPosition> obstacle(const ContactTrack& track, double u, double h, bool look_for_limit) {
  const ContactPosition& at = track.at;
  if (look_for_limit) {
    const auto found = limit_near(track.pair, at, track.size);
    const bool beyond = found && (u - found->u) * (u - at.u) < 0;
    if (found && !beyond && is_ahead(track, *found, std::copysign(h, u - at.u))) {
      return found;
    }
  }
  if (h < kSmallestStep * (unit_of(track.pair.motion1, track) + std::abs(at.u))) {
    return LimitPosition{at.u, at.q};
  }
  return std::nullopt;
}

// Follows the contact towards u; false if it is lost on the way (then `limit` says where).
bool follow(ContactTrack& track, double u, std::optional<LimitPosition>& limit) {
  const double unit = unit_of(track.pair.motion1, track);
  const double largest = kMaxTurn * unit;
  double h = largest;
  int halvings = 0;
  const double way = std::abs(u - track.at.u);
  const int length = way > largest ? static_cast<int>(std::min(kMostSteps, way / largest)) : 0;
  int attempts = kAttempts + 4 * length;
  int steps = static_cast<int>(kMostSteps) + 4 * length;  // some may be lost in the rounding of u
  while (track.at.u != u) {
    if (--steps < 0) {
      limit = LimitPosition{track.at.u, track.at.q};
      return false;
    }
    const double rest = u - track.at.u;
    bool last = std::abs(rest) <= h;
    double step = last ? rest : std::copysign(h, rest);
    const double rate = gap_q_rate(track);
    if (last && vanishes(track, track.at.gap_q + rate * rest)) {
      if (stop_at_crossing(track, rest)) {
        track.at.u = u;
        return true;
      }
      // Come nearer first, if it is not near yet.
      if (std::abs(rest) > kNearCrossing * unit) {
        step = std::copysign(std::abs(rest) - kNearCrossing * unit / 2, rest);
        last = false;
      }
    }
    if (step_by(track, step, track.at.gap_q + rate * step)) {
      if (last) {
        track.at.u = u;
      }
      h = std::min(2 * h, largest);
      continue;
    }
    if (last && stop_at_crossing(track, rest)) {
      return true;
    }
    h = std::abs(step) / 2;
    limit = --attempts < 0 ? LimitPosition{track.at.u, track.at.q}
                           : obstacle(track, u, h, ++halvings >= kHalvingsToLimit);
    if (limit) {
      return false;
    }
  }
  return true;
}

bool resume(ContactTrack& track, double u, std::optional<LimitPosition>& limit) {
  const FindResult found = find_nearest_contact(track.pair, u, track.at.q, track.branch);
  if (found.status != FindStatus::kFound) {
    return false;
  }
  const double from = track.at.u;
  const double phi = nearest_turn(angle_of(found.at.n_W), track.phi);
  track = start_track(track.pair, found.at, track.branch);
  track.phi = phi;
  // Where this stretch begins: the limit on the way back.
  ContactTrack back = track;
  if (follow(back, from, limit)) {
    limit.reset();
  }
  return true;
}

}  // namespace

ContactTrack start_track(const ContactPair& pair, const ContactPosition& at, int branch) {
  ContactTrack track;
  track.pair = pair;
  track.branch = branch;
  track.at = at;
  track.phi = angle_of(at.n_W);
  const Vector2d& p = at.p1_W;
  const double radius1 = std::abs(at.rho1);
  const double radius2 = std::abs(at.rho2);
  const double radii = is_line(pair.curve1) || is_line(pair.curve2) ? radius1 + radius2
                                                                    : radius1 * radius2 / (radius1 + radius2);
  track.size = (p - pair.motion1.p_WO).norm() + (p - pair.motion2.p_WO).norm() + radii +
               std::numeric_limits<double>::min();
  return track;
}

TrackResult follow_to(ContactTrack& track, double u) {
  TrackResult result;
  if (!std::isfinite(u)) {
    return result;
  }
  const bool held = track.assembled ? follow(track, u, result.limit) : resume(track, u, result.limit);
  if (!held && track.assembled) {
    // The branch may be there again at u, past a stretch in which it is not.
    track.assembled = false;
  }
  if (held) {
    track.assembled = true;
  }
  result.status = held ? TrackStatus::kOk : TrackStatus::kNotAssemblable;
  return result;
}

}  // namespace higherpair
