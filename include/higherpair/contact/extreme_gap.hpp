#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <optional>

namespace higherpair {

/// The extreme of the gap over the follower's coordinate near a contact, driver held: the root of ∂gap/∂q =
/// 0, ∂gap/∂φ = 0 by Newton's method [m]. It varies smoothly with the driver and goes through 0 where two
/// contacts of opposite branches meet: at a limit position. None where the iteration does not converge.
/// \param near  a contact, or a position close to the extreme (u, q and n are used)
[[nodiscard]] std::optional<double> extreme_gap(const ContactPair& pair, const ContactPosition& near);

}  // namespace higherpair
