#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <optional>

namespace higherpair {

/// Whether a body's joint moves its curve within itself, to within rounding: a circle or a point about its
/// own centre, a line along itself. The relative position of the bodies does not change with such a joint's
/// coordinate.
[[nodiscard]] bool moves_in_itself(const Curve& curve, const OneFreedom& motion);

/// A contact between a driver that moves its curve within itself and a follower that the contact does not
/// control (gap = ∂gap/∂q = 0): the follower is at rest at every position of the driver, but its rates are
/// not determined.
struct DwellContact {
  ContactPosition at;
};

/// The contact in which the follower, at q, stays at rest whatever the driver does. None where the driver has
/// any effect, where the gap is larger than `tolerance` [m], or where ∂gap/∂q determines how the follower
/// moves. Examples: concentric discs, and an arm that points to the centre of a disc turning about it.
[[nodiscard]] std::optional<DwellContact> dwell_contact(const ContactPair& pair, double u, double q,
                                                        double tolerance);

}  // namespace higherpair
