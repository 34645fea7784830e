#include "contact/pair_follower.hpp"

#include "contact/pair_stops.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/contact/step_agreement.hpp"
#include "higherpair/contact/step_length.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kStepAgreement = 0.25;   // as kCrossingAgreement, for a step without a crossing
constexpr double kMayBeCrossing = 0.1;    // fraction of ∂gap/∂q left where a step may end at a crossing
constexpr double kShortOfCrossing = 0.6;  // fraction taken of a step that would end at a crossing
constexpr double kSameContact = 1e-2;     // relative to the follower's unit: nearer contacts are the same
constexpr int kHalvingsToLimit = 4;       // failed inner steps before a limit is looked for
constexpr int kAttempts = 2000;           // failed inner steps allowed
constexpr double kMostSteps = 2e5;        // inner steps allowed, besides 4 per kLargestTurn of the path

enum class Outcome { kTaken, kArrived, kRefused, kOntoCrossing };

// One inner step. Where ∂gap/∂q is predicted to change sign while the motion stays smooth, branches cross.
// \param may_stop_at_crossing  if false, a step that ends (nearly) at a crossing is not taken: the conditions
//                              lose rank there, and the rates are noise
Outcome step_by(FollowedContact& track, double h, double predicted_gap_q, bool may_stop_at_crossing) {
  // A change of sign may also mean that a limit lies within the step and that the branch exists again beyond
  // it; shorter steps will decide.
  const bool crosses = predicted_gap_q * track.at.gap_q < 0;
  const int branch = crosses ? -track.branch : track.branch;
  const Step step = try_step(track, h, branch);
  if (step.solved && !may_stop_at_crossing && vanishes(track, step.result.at.gap_q)) {
    return Outcome::kOntoCrossing;
  }
  if (!agrees(step, crosses ? kCrossingAgreement : kStepAgreement) ||
      turns_back(track.at, step.result.at, h)) {
    return Outcome::kRefused;
  }
  accept(track, step.result.at, branch);
  return Outcome::kTaken;
}

// Whether the motion leads to the limit: it has to lie ahead, within reach of the last few failed steps. Near
// a limit q changes with the square root of the distance, so that twice the present rate leads there.
bool is_ahead(const FollowedContact& track, const LimitPosition& limit, double h) {
  const ContactPosition& at = track.at;
  const double unit1 = unit_of(track.pair.motion1, track);
  const double unit2 = unit_of(track.pair.motion2, track);
  const double distance = (limit.u - at.u) * (h > 0 ? 1 : -1);
  const double way = 2 * (limit.u - at.u) * at.dq;
  return distance >= -1e-12 * (unit1 + std::abs(at.u)) && distance <= 64 * std::abs(h) &&
         std::abs(limit.q - at.q - way) <= std::abs(way) / 2 + 1e-6 * unit2;
}

// What prevents a step towards u that failed: the limit if it can be located, or the present position if the
// steps have become too small.
std::optional<LimitPosition> obstacle(const FollowedContact& track, double u, double h, bool look_for_limit) {
  const ContactPosition& at = track.at;
  if (look_for_limit) {
    const auto found = limit_near(track.pair, at, track.size);
    const bool beyond = found && (u - found->u) * (u - at.u) < 0;
    if (found && !beyond && is_ahead(track, *found, std::copysign(h, u - at.u))) {
      return found;
    }
  }
  if (h < shortest_step(unit_of(track.pair.motion1, track), at.u)) {
    return LimitPosition{at.u, at.q};
  }
  return std::nullopt;
}

// A step towards u. If u may be a crossing, the step stops short of it: at a crossing itself a position is
// noise, or is not found at all.
Stride aim_at(const FollowedContact& track, double u, const StepLength& length, double near) {
  const double rest = u - track.at.u;
  const Stride aim = length.next(rest);
  const double ahead = track.at.gap_q + track.at.dgap_q * rest;
  if (aim.last && std::abs(rest) > near && std::abs(ahead) <= kMayBeCrossing * std::abs(track.at.gap_q)) {
    return {std::copysign(std::abs(rest) - near / 2, rest), false};
  }
  return aim;
}

// Takes the step as aimed, or a shorter one (then `aim` is changed); a last step may end at a crossing.
Outcome step_towards(FollowedContact& track, double u, Stride& aim, double near) {
  const double gap_q = track.at.gap_q;
  const double rate = track.at.dgap_q;
  if (aim.last && vanishes(track, gap_q + rate * aim.step) && stop_at_crossing(track, u)) {
    return Outcome::kArrived;
  }
  Outcome outcome = step_by(track, aim.step, gap_q + rate * aim.step, false);
  if (outcome == Outcome::kOntoCrossing) {
    if (aim.last && stop_at_crossing(track, u)) {
      return Outcome::kArrived;
    }
    if (std::abs(aim.step) > near) {
      aim = {kShortOfCrossing * aim.step, false};
    }
    outcome = step_by(track, aim.step, gap_q + rate * aim.step, true);
  }
  if (outcome == Outcome::kRefused && aim.last && stop_at_crossing(track, u)) {
    return Outcome::kArrived;
  }
  return outcome;
}

// Follows the contact towards u; false if it is lost on the way. `limit` is set to where, also where u itself
// is a limit.
bool follow(FollowedContact& track, double u, std::optional<LimitPosition>& limit) {
  const double unit = unit_of(track.pair.motion1, track);
  const double largest = kLargestTurn * unit;
  const double way = std::abs(u - track.at.u);
  const int length = way > largest ? static_cast<int>(std::min(kMostSteps, way / largest)) : 0;
  int attempts = kAttempts + 4 * length;
  int steps = static_cast<int>(kMostSteps) + 4 * length;  // some may be lost in the rounding of u
  int halvings = 0;
  StepLength step_length(largest);
  while (track.at.u != u) {
    if (--steps < 0) {
      limit = LimitPosition{track.at.u, track.at.q};
      return false;
    }
    Stride aim = aim_at(track, u, step_length, kNearCrossing * unit);
    const Outcome outcome = step_towards(track, u, aim, kNearCrossing * unit);
    if (outcome == Outcome::kArrived) {
      return true;
    }
    if (outcome == Outcome::kTaken) {
      track.at.u = aim.last ? u : track.at.u;
      step_length.taken();
      continue;
    }
    step_length.refused(aim.step);
    limit = --attempts < 0 ? LimitPosition{track.at.u, track.at.q}
                           : obstacle(track, u, step_length.value(), ++halvings >= kHalvingsToLimit);
    if (limit && stop_at_limit(track, u, *limit)) {
      return true;
    }
    if (limit && !pass_crossing(track, *limit)) {
      return false;
    }
    limit.reset();
  }
  return true;
}

bool resume(FollowedContact& track, double u, std::optional<LimitPosition>& limit) {
  const FindResult found = find_nearest_contact(track.pair, u, track.at.q, track.branch);
  if (found.status != FindStatus::kFound) {
    return false;
  }
  FollowedContact next = start_track(track.pair, found.at, track.branch);
  next.phi = nearest_turn(next.phi, track.phi);
  // The stretch begins at the limit found on the way back. If there is none, this is another branch, which
  // the follower cannot have reached, or there was no limit at all.
  FollowedContact back = next;
  if (follow(back, track.at.u, limit)) {
    limit.reset();
    const double unit = unit_of(track.pair.motion2, track);
    if (!(std::abs(back.at.q - track.at.q) <= kSameContact * unit)) {
      return false;
    }
  }
  // Over the stretch without contact the angles take the short way round.
  next.phi += nearest_turn(back.phi, track.phi) - back.phi;
  if (track.pair.motion2.turns) {
    next.at.q += nearest_turn(back.at.q, track.at.q) - back.at.q;
  }
  track = next;
  return true;
}

}  // namespace

TrackResult follow_to(FollowedContact& track, double u) {
  TrackResult result;
  if (!std::isfinite(u)) {
    return result;
  }
  bool held = false;
  if (track.assembled) {
    held = follow(track, u, result.limit);
    // The branch may exist again beyond a stretch in which it does not.
    track.assembled = held && !result.limit;
  } else {
    held = resume(track, u, result.limit);
    track.assembled = held;
  }
  if (track.assembled && has_come_to_limit(track, result.limit)) {
    track.assembled = false;
  }
  result.status = held ? TrackStatus::kOk : TrackStatus::kNotAssemblable;
  return result;
}

}  // namespace higherpair
