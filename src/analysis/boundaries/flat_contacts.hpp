#pragma once

#include "joint_passage.hpp"

#include <optional>

// A flat part of one boundary that comes to lie on a flat part of the other. They touch all along at this one
// position; before it the contact is at one end of the flat part, after it at the other.

namespace higherpair {

/// Moves the contact of run.at.state, which is at the joint at s, to the other end of the part along which
/// the two flats lie on each other: the end of the span beyond the joint or of the other body's flat,
/// whichever comes first. Returns the joint on which the contact then is, as one that has been passed. If the
/// former is an end of the curve or a notch, returns none and changes nothing. Adds an event with the jump of
/// the follower's velocity.
[[nodiscard]] std::optional<JointPassage> go_over_flat(Run& run, const Path& path, double s,
                                                       const JointPassage& passage);

}  // namespace higherpair
