#pragma once

#include "joint_passage.hpp"

#include <optional>

namespace higherpair {

/// The first joint that a contact passes between run.at.state, which is at s, and run.work.trial, the
/// positions that a step of h has tried; none if all contacts stay on their spans. If one is found
/// run.work.trial is left within the step, at the joint only if JointPassage::solved.
[[nodiscard]] std::optional<JointPassage> joint_within(Run& run, const Path& path, double s, double h);

/// Whether a step of h to run.work.trial, in which joint_within() has found no joint, passes one all the
/// same: a contact is on another span than in run.at.state, or it comes back to its own from where the bodies
/// cannot be placed.
[[nodiscard]] bool passes_unseen(Run& run, const Path& path, double s, double h);

}  // namespace higherpair
