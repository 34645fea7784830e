#pragma once

#include "step.hpp"
#include "straight_path.hpp"

namespace higherpair {

/// Adds to run.events what happens between run.at.state (at s of the path) and run.work.trial (at s + h):
/// ends of strokes, dead points, conforming contacts, each located by a root on the path. Leaves
/// run.work.trial as it was.
void note_events(Run& run, const Path& path, double s, double h);

/// Reports the change points of the present step that lie between s and `end` on the path, unless it has been
/// done: where rows fall next to one, run.at.state is short of it for several of them.
void note_crossings(Run& run, const Path& path, double s, double end);

/// The joints to ground whose reversal ends a stroke: all that are not driven.
[[nodiscard]] std::vector<OutputJoint> output_joints(const Mechanism& mechanism);

}  // namespace higherpair
