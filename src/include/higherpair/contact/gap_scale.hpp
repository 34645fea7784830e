#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/contact/tolerances.hpp"

#include <algorithm>
#include <limits>

namespace higherpair {

/// Square of the order of magnitude of ∂gap/∂q near a contact, for deciding when it vanishes: 1 for a sliding
/// follower; for a turning one the arm squared plus, for a contact that passes over the pivot, the squares of
/// the radii of curvature, clamped between fractions of the distances from the pivots [m²].
[[nodiscard]] inline double gap_q_scale2(const ContactPair& pair, const ContactPosition& at) {
  const double arm2 = velocity_per_q(pair.motion2, at.p2_W).squaredNorm();
  if (!pair.motion2.turns) {
    return arm2;
  }
  const double size2 =
      (at.p2_W - pair.motion2.p_WO).squaredNorm() + (at.p1_W - pair.motion1.p_WO).squaredNorm();
  const double rho1 = is_line(pair.curve1) ? 0 : at.rho1;
  const double rho2 = is_line(pair.curve2) ? 0 : at.rho2;
  const double radii2 = rho1 * rho1 + rho2 * rho2;
  const double least2 =
      std::clamp(radii2, kLeastGapScale * kLeastGapScale * size2, kMostGapScale * kMostGapScale * size2);
  return arm2 + (least2 + std::numeric_limits<double>::min());
}

/// Whether ∂gap/∂q is small enough to vanish nearby: the contact may be at a limit position of its follower.
[[nodiscard]] inline bool gap_q_may_vanish(const ContactPair& pair, const ContactPosition& at) {
  return at.gap_q * at.gap_q <= kGapQMayVanish * kGapQMayVanish * gap_q_scale2(pair, at);
}

}  // namespace higherpair
