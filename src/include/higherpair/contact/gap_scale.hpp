#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/contact/tolerances.hpp"

#include <algorithm>
#include <limits>

namespace higherpair {

/// What is left of `gap_q_scale2` where a contact passes over the follower's pivot: the radii of curvature,
/// and a share of the distances from the pivots [m²]; 0 of a sliding follower.
[[nodiscard]] inline double least_gap_q_scale2(const ContactPair& pair, const ContactPosition& at) {
  if (!pair.motion2.turns) {
    return 0;
  }
  const double size2 =
      (at.p2_W - pair.motion2.p_WO).squaredNorm() + (at.p1_W - pair.motion1.p_WO).squaredNorm();
  const double rho1 = is_line(pair.curve1) ? 0 : at.rho1;
  const double rho2 = is_line(pair.curve2) ? 0 : at.rho2;
  const double radii2 = rho1 * rho1 + rho2 * rho2;
  return std::clamp(radii2, kLeastGapScale * kLeastGapScale * size2, kMostGapScale * kMostGapScale * size2) +
         std::numeric_limits<double>::min();
}

/// Square of what ∂gap/∂q is of the order of near a contact, for telling when it vanishes: of a sliding
/// follower 1, of a turning one the arm [m²], with the above.
[[nodiscard]] inline double gap_q_scale2(const ContactPair& pair, const ContactPosition& at) {
  return velocity_per_q(pair.motion2, at.p2_W).squaredNorm() + least_gap_q_scale2(pair, at);
}

[[nodiscard]] inline bool gap_q_may_vanish(const ContactPair& pair, const ContactPosition& at) {
  return at.gap_q * at.gap_q <= kGapQMayVanish * kGapQMayVanish * gap_q_scale2(pair, at);
}

}  // namespace higherpair
