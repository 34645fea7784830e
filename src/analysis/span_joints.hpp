#pragma once

#include "joint_passage.hpp"

#include <optional>

namespace higherpair {

/// The first joint over which a contact goes between run.at.state, which is at s, and run.work.trial, the
/// positions a step of h tried; none if all contacts stay on their spans. run.work.trial is left somewhere
/// between.
[[nodiscard]] std::optional<JointPassage> joint_within(Run& run, const Path& path, double s, double h);

}  // namespace higherpair
