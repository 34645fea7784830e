#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <optional>

namespace higherpair {

/// A position in which the gap has an extreme with respect to the follower's coordinate.
struct ExtremeGap {
  double gap = 0;      ///< [m]; 0 where two contacts of opposite branches meet
  ContactPosition at;  ///< u, q, normal, points and radii; no rates
};

/// The extreme of the gap with respect to the follower's coordinate near a contact, the driver being held:
/// the root of ∂gap/∂q = 0, ∂gap/∂φ = 0 by Newton's method. It varies smoothly with the driver and passes
/// through 0 where two contacts of opposite branches meet: at a limit position. None where the iteration does
/// not converge.
/// \param near  a contact, or a position close to the extreme (u, q and n are used)
[[nodiscard]] std::optional<ExtremeGap> extreme_gap(const ContactPair& pair, const ContactPosition& near);

}  // namespace higherpair
