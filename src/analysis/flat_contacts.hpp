#pragma once

#include "span_joints.hpp"

// A flat part of a boundary that comes to lie on a flat part of the other one. They touch all along for this
// one position; before it the contact is at one end of the flat part, after it at the other.

namespace higherpair {

/// Whether the span behind a joint lies flat on the other curve there.
[[nodiscard]] bool lies_flat_behind(const Run& run, const JointPassage& passage);

/// Lets run.at.state, which is at the joint at s, go on at the other end of the flat span behind it;
/// false, and nothing done, where that is an end of the curve or a notch. An event says how the follower's
/// velocity jumps.
[[nodiscard]] bool go_over_flat(Run& run, const Path& path, double s, const JointPassage& passage);

}  // namespace higherpair
