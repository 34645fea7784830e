#pragma once

#include "higherpair/contact/step_agreement.hpp"
#include "inner_step.hpp"

#include <cmath>

namespace higherpair {

// Whether the normal has turned as predicted, to a share of the step's change.
[[nodiscard]] inline bool normal_agrees(const ContactTrack& track, const Step& step, double h, double share) {
  return (step.result.at.n_W - predicted_normal(track, h)).norm() <= share * step.change + 1e-9;
}

/// Follows a contact to the driver coordinate u, within a range in which it is known to be smooth: nothing is
/// looked for on the way, and nothing jumped over. False where it cannot be followed; the track then stands
/// where it was last.
/// \param may_cross  branches may cross on the way: ∂gap/∂q may change its sign
[[nodiscard]] inline bool walk_to(ContactTrack& track, double u, bool may_cross) {
  constexpr double kAgreement = 0.1;
  constexpr double kSmallest = 1e-14;  // step, of the driver's unit
  const double unit = unit_of(track.pair.motion1, track);
  const double largest = kMaxTurn * unit;
  double h = largest;
  while (track.at.u != u) {
    const double rest = u - track.at.u;
    const bool last = std::abs(rest) <= h;
    const double length = last ? rest : std::copysign(h, rest);
    const bool crosses = may_cross && (track.at.gap_q + track.at.dgap_q * length) * track.at.gap_q < 0;
    const int branch = crosses ? -track.branch : track.branch;
    const double agreement = crosses ? kCrossingAgreement : kAgreement;
    const Step step = try_step(track, length, branch);
    const bool strays = may_cross && turns_back(track.at, step.result.at, length);
    if (agrees(step, agreement) && normal_agrees(track, step, length, agreement) && !strays) {
      accept(track, step.result.at, branch);
      h = std::min(2 * h, largest);
      if (last) {
        track.at.u = u;
      }
      continue;
    }
    h = std::abs(length) / 2;
    if (h < kSmallest * (unit + std::abs(u))) {
      return false;
    }
  }
  return true;
}

}  // namespace higherpair
