#pragma once

#include "contact_points.hpp"
#include "higherpair/contact/common_normal.hpp"
#include "higherpair/contact/step_agreement.hpp"
#include "higherpair/contact/step_length.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/contact/tracker.hpp"

#include <cmath>

// One step of a track: predicted, solved, compared with the prediction, and accepted.

namespace higherpair {

// One unit of a coordinate: a radian, or the size of the mechanism.
[[nodiscard]] inline double unit_of(const OneFreedom& freedom, const ContactTrack& track) {
  return freedom.turns ? 1 : track.size;
}

// The rotation by an angle; without trigonometric functions if the angle is small.
[[nodiscard]] inline Rotation<double> predicted_turn(double angle) {
  return angle * angle <= kSmallTurn2 ? Rotation<double>{1 - small_versine(angle), small_sine(angle)}
                                      : Rotation<double>::from_angle(angle);
}

struct Step {
  ContactResult result;
  double change = 0;    // of q and φ, in units
  double mismatch = 0;  // between prediction and solution, of q and φ, in units
  bool solved = false;
};

// Derivatives taken over a very short step are dominated by rounding: they are not used for much longer
// steps.
[[nodiscard]] inline bool reaches(const ContactTrack& track, double h) {
  return std::abs(h) <= kFarthestReach * track.last_step;
}

// The normal after a step h, to third order as for the follower; long steps leave out the third derivative,
// with which a jump of the normal could seem to agree.
[[nodiscard]] inline Vector2d predicted_normal(const ContactTrack& track, double h) {
  const double half_h2 = h * h / 2;
  const double d2phi = reaches(track, h) ? track.d2phi : 0;
  const double d3phi = std::abs(h) <= kShortTurn * unit_of(track.pair.motion1, track) ? track.d3phi : 0;
  const double turn = h * track.at.dphi + half_h2 * d2phi + half_h2 * h * (1 / 3.0) * d3phi;
  return predicted_turn(turn) * track.at.n_W;
}

// place_pair() with the rotations that the track has stored.
[[nodiscard]] inline PlacedPair placed_near(const ContactTrack& track, double u, double q) {
  const auto& [curve1, motion1, curve2, motion2] = track.pair;
  const Rotation<double> R_W1 = motion1.turns ? track.driver.at(u) : motion1.R_WB;
  const Rotation<double> R_W2 = motion2.turns ? track.follower.at(q) : motion2.R_WB;
  return {place_on(curve1, motion1, u, R_W1), place_on(curve2, motion2, q, R_W2)};
}

[[nodiscard]] inline Step try_step(const ContactTrack& track, double h, int branch) {
  const ContactPosition& from = track.at;
  // The least accurate terms are added last.
  const double half_h2 = h * h / 2;
  const double d3q = reaches(track, h) ? track.d3q : 0;
  const double q = from.q + h * from.dq + half_h2 * from.d2q + half_h2 * h * (1 / 3.0) * d3q;
  const Vector2d n = predicted_normal(track, h);
  const double u = from.u + h;
  Step step{solve_contact(track.pair, placed_near(track, u, q), u, q, n, branch)};
  const ContactPosition& to = step.result.at;
  if (step.result.status != ContactStatus::kOk) {
    return step;
  }
  const double unit = unit_of(track.pair.motion2, track);
  step.change = std::abs(to.q - from.q) / unit + std::abs(cross(from.n_W, to.n_W));
  step.mismatch = std::abs(to.q - q) / unit + step.result.step_n;
  const bool turned_far = to.n_W.dot(from.n_W) < kCosFarthestTurn ||
                          (track.pair.motion2.turns && std::abs(to.q - from.q) > kFarthestInnerTurn);
  step.solved = !turned_far && same_curvature(track.pair.curve1, track.pair.curve2, from.rho1 + from.rho2,
                                              to.rho1 + to.rho2);
  return step;
}

[[nodiscard]] inline bool turns_back(const ContactPosition& from, const ContactPosition& to, double h) {
  return turns_back(from.gap_q, from.dgap_q, to.gap_q, to.dgap_q, h);
}

[[nodiscard]] inline bool agrees(const Step& step, double share) {
  return step.solved && is_as_predicted(step.mismatch, step.change, share);
}

// Not renewed for long steps, after which the motion would not come back near the stored rotation.
inline void renew(KnownRotation& known, double from, double to) {
  if (!known.is_near(to) && std::abs(to - from) <= kShortTurn) {
    known = KnownRotation(to);
  }
}

// The higher derivatives over the last step h, in which the normal turned by `turn`. Over a very short step
// they would be rounding: the previous ones are kept. At a change of branch they are reset.
inline void renew_derivatives(ContactTrack& track, const ContactPosition& at, int branch, double turn) {
  if (branch != track.branch) {
    track.d3q = track.d2phi = track.d3phi = 0;
    return;
  }
  const double h = at.u - track.at.u;
  const double unit = unit_of(track.pair.motion1, track);
  if (!(std::abs(h) > kShortestForSecond * unit)) {
    return;
  }
  track.last_step = std::abs(h);
  const double per_h = 1 / h;
  track.d3q = per_h * (at.d2q - track.at.d2q);
  // The turn computed from the rates at both ends is too large by h³ φ‴/12.
  const double excess = (at.dphi + track.at.dphi) / 2 - per_h * turn;
  track.d3phi = std::abs(h) > kShortestForThird * unit ? 12 * per_h * per_h * excess : 0;
  track.d2phi = per_h * (at.dphi - track.at.dphi) + h / 2 * track.d3phi;
}

inline void accept(ContactTrack& track, const ContactPosition& at, int branch) {
  const double turn = angle_between(track.at.n_W, at.n_W);
  renew_derivatives(track, at, branch, turn);
  track.phi += turn;
  renew(track.driver, track.at.u, at.u);
  renew(track.follower, track.at.q, at.q);
  track.at = at;
  track.branch = branch;
}

}  // namespace higherpair
