#pragma once

#include "higherpair/contact/tracker.hpp"

#include <optional>

namespace higherpair {

/// The end of a stroke: where the follower is at rest and turns back, dq/du = 0, between the driver
/// position of the track and `u`, to full precision: u is known to (rounding of dq)/|d²q/du²|. None where
/// dq/du has the same sign at both ends, or the contact is lost between them. At most one end of several is
/// found; rows that follow the motion closely have one at most between them.
[[nodiscard]] std::optional<ContactPosition> stroke_end(const ContactTrack& track, double u);

}  // namespace higherpair
