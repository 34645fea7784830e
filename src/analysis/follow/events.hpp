#pragma once

#include "path_events.hpp"
#include "step.hpp"

namespace higherpair {

/// Adds to run.events what happens between run.at.state (at s of the path) and run.work.trial (at s + h):
/// ends of strokes, dead points, conforming contacts, each located by a root on the path. Leaves
/// run.work.trial as it was.
void note_events(Run& run, const Path& path, double s, double h);

/// Reports the change points of the present step that lie between s and `end` on the path, unless they have
/// been reported already: if several rows fall next to a change point, run.at.state remains short of it for
/// all of them.
void note_crossings(Run& run, const Path& path, double s, double end);

/// The joints to ground whose reversal ends a stroke: all that are not driven.
[[nodiscard]] std::vector<OutputJoint> output_joints(const Mechanism& mechanism);

/// Whether an output that comes to `position` has moved far enough in this sense for a stroke.
[[nodiscard]] bool is_stroke(const Run& run, const OutputJoint& output, double position);

}  // namespace higherpair
