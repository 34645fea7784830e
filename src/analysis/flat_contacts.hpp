#pragma once

#include "joint_passage.hpp"

#include <optional>

// A flat part of a boundary that comes to lie on a flat part of the other one. They touch all along for this
// one position; before it the contact is at one end of the flat part, after it at the other.

namespace higherpair {

/// Whether the span behind a joint lies flat on the other curve there.
[[nodiscard]] bool lies_flat_behind(const Run& run, const JointPassage& passage);

/// Lets run.at.state, which is at the joint at s, go on at the other end of the part along which the two
/// flats lie on each other: that of the span behind the joint, or of the other body's, whichever comes first.
/// None, and nothing done, where the former is an end of the curve or a notch; else the joint on which the
/// contact then rests, as one that has been passed. An event says how the follower's velocity jumps.
[[nodiscard]] std::optional<JointPassage> go_over_flat(Run& run, const Path& path, double s,
                                                       const JointPassage& passage);

}  // namespace higherpair
