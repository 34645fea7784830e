#pragma once

#include "higherpair/contact/tracker.hpp"

#include <optional>

namespace higherpair {

/// The end of a stroke: where the follower is at rest and turns back, dq/du = 0, between the driver position
/// of the track and `u`, to full precision: u is known to (rounding of dq)/|d²q/du²|. None where dq/du has
/// the same sign at both ends, or the contact is lost between them. Of several ends at most one is found;
/// closely spaced positions have at most one between them.
[[nodiscard]] std::optional<ContactPosition> stroke_end(const ContactTrack& track, double u);

}  // namespace higherpair
