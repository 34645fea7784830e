#include "higherpair/contact/tracker.hpp"

#include "higherpair/contact/finder.hpp"
#include "limit.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kMaxTurn = kPi / 18;  // of driver or normal in one inner step [rad]
constexpr double kAgreement = 0.25;    // of the change of a step: distance between prediction and solution
constexpr double kCrossingAgreement = 0.03;  // the same where the branch is to change
constexpr double kNearCrossing = 1e-3;  // of the driver's scale: how near a crossing is interpolated over
constexpr double kAtCrossing = 1e-6;    // of the follower's lever: ∂gap/∂q that may be that of a crossing
constexpr int kHalvingsToLimit = 4;     // halvings before a limit position is looked for
constexpr double kSmallestStep = 1e-14;  // of the driver's scale

// What counts as one unit of a coordinate: a radian, or the size of the mechanism.
double scale_of(const OneFreedom& freedom, const ContactPosition& at) {
  return freedom.turns ? 1 : 1e-300 + (at.p1_W - freedom.p_WO).norm() + std::abs(at.rho1) + std::abs(at.rho2);
}

struct Step {
  ContactPosition at;
  double change = 0;    // of q and φ, in units
  double mismatch = 0;  // between prediction and solution, in units
  bool solved = false;
};

Step try_step(const ContactTrack& track, double h, int branch) {
  const ContactPosition& from = track.at;
  const double q = from.q + h * (from.dq + h / 2 * from.d2q);
  const Vector2d n = Rotation<double>::from_angle(h * from.dphi) * from.n_W;
  const ContactResult result = solve_contact(track.pair, from.u + h, q, n, branch);
  Step step;
  if (result.status != ContactStatus::kOk) {
    return step;
  }
  const double scale = scale_of(track.pair.motion2, from);
  step.at = result.at;
  step.solved = true;
  step.change = std::abs(result.at.q - from.q) / scale + std::abs(cross(from.n_W, result.at.n_W));
  step.mismatch = std::abs(result.at.q - q) / scale;
  const bool turned_far = result.at.n_W.dot(from.n_W) < std::cos(2 * kMaxTurn);
  if (turned_far || std::abs(result.at.q - from.q) > 3 * kMaxTurn * scale) {
    step.solved = false;
  }
  return step;
}

bool agrees(const Step& step, double share) {
  return step.solved && step.mismatch <= share * step.change + 1e-9;
}

void accept(ContactTrack& track, const ContactPosition& at, int branch) {
  track.phi += std::atan2(cross(track.at.n_W, at.n_W), track.at.n_W.dot(at.n_W));
  track.at = at;
  track.branch = branch;
}

// ∂gap/∂q after a step of the driver, to first order.
double predicted_gap_q(const ContactTrack& track, double h) {
  const GapDerivatives d = gap_derivatives(track.pair, track.at);
  return track.at.gap_q + h * (d.g_qq * track.at.dq + d.g_phiq * track.at.dphi + d.g_qu);
}

// One inner step; where ∂gap/∂q is predicted to change sign while the motion stays smooth, branches cross.
bool step_by(ContactTrack& track, double h) {
  if (predicted_gap_q(track, h) * track.at.gap_q < 0) {
    const Step crossing = try_step(track, h, -track.branch);
    if (agrees(crossing, kCrossingAgreement)) {
      accept(track, crossing.at, -track.branch);
      return true;
    }
  }
  const Step step = try_step(track, h, track.branch);
  if (!agrees(step, kAgreement)) {
    return false;
  }
  accept(track, step.at, track.branch);
  return true;
}

// The driver stops (nearly) where branches cross, `rest` ahead: the closure has lost its rank there. The
// position is interpolated between here and a place just beyond; its gap_q is exactly 0 and its rates are
// those of the smooth motion.
bool stop_at_crossing(ContactTrack& track, double rest) {
  const double scale = scale_of(track.pair.motion1, track.at);
  if (std::abs(rest) > kNearCrossing * scale) {
    return false;
  }
  const double h = 2 * rest;
  const Step beyond = try_step(track, h, -track.branch);
  if (!agrees(beyond, kCrossingAgreement)) {
    return false;
  }
  const ContactPosition& a = track.at;
  const ContactPosition& b = beyond.at;
  ContactPosition at = b;
  at.u = a.u + rest;
  at.q = (a.q + b.q) / 2 + h * (a.dq - b.dq) / 8;
  at.dq = (a.dq + b.dq) / 2;
  at.d2q = (a.d2q + b.d2q) / 2;
  at.dphi = (a.dphi + b.dphi) / 2;
  at.n_W = Rotation<double>::from_angle(h * (a.dphi - b.dphi) / 8) * Vector2d(a.n_W + b.n_W).normalized();
  at.gap_q = 0;
  if (!place_points(track.pair, at)) {
    return false;
  }
  accept(track, at, -track.branch);
  return true;
}

// The limit lies ahead, not further than the step that failed and the few before it.
bool is_ahead(const LimitPosition& limit, const ContactPosition& at, double h) {
  const double distance = (limit.u - at.u) * (h > 0 ? 1 : -1);
  return distance >= -1e-12 * (1 + std::abs(at.u)) && distance <= 64 * std::abs(h);
}

// Follows the contact towards u; false if it is lost on the way (then `limit` says where, if that could be
// located).
bool follow(ContactTrack& track, double u, std::optional<LimitPosition>& limit) {
  const double scale = scale_of(track.pair.motion1, track.at);
  const double largest = kMaxTurn * scale;
  double h = largest;
  int halvings = 0;
  while (track.at.u != u) {
    const double rest = u - track.at.u;
    bool last = std::abs(rest) <= h;
    const double lever = velocity_per_q(track.pair.motion2, track.at.p2_W).norm();
    if (last && std::abs(predicted_gap_q(track, rest)) <= kAtCrossing * lever) {
      if (stop_at_crossing(track, rest)) {
        track.at.u = u;
        return true;
      }
      // Come nearer first, if it is not near yet.
      if (std::abs(rest) > kNearCrossing * scale) {
        h = std::abs(rest) - kNearCrossing * scale / 2;
        last = false;
      }
    }
    if (step_by(track, last ? rest : std::copysign(h, rest))) {
      if (last) {
        track.at.u = u;
      }
      h = std::min(2 * h, largest);
      continue;
    }
    if (last && stop_at_crossing(track, rest)) {
      return true;
    }
    h = std::min(h, std::abs(rest)) / 2;
    if (++halvings >= kHalvingsToLimit) {
      const auto found = limit_near(track.pair, track.at);
      const bool beyond = found && (u - found->u) * rest < 0;
      if (found && !beyond && is_ahead(*found, track.at, std::copysign(h, rest))) {
        limit = found;
        return false;
      }
    }
    if (h < kSmallestStep * scale * (1 + std::abs(track.at.u) / scale)) {
      limit = LimitPosition{track.at.u, track.at.q};
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
  return {pair, branch, at, angle_of(at.n_W), true};
}

TrackResult follow_to(ContactTrack& track, double u) {
  TrackResult result;
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
