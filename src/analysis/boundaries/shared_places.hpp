#pragma once

#include "analysis/follow/path_events.hpp"
#include "higherpair/contact/near_places.hpp"

#include <vector>

// Bodies of one contact of boundaries that touch at several places without overlapping: two pairs of teeth at
// once, the next pair before the previous one has separated. The motion follows one place, and all of them
// agree with it; where it comes to the end of its curve another one takes over.

namespace higherpair {

/// The places other than their contact at which two bodies touch at the beginning and at the end of a step.
struct SharedTouch {
  std::size_t contact = 0;
  std::vector<NearPlace> before, after;
};

/// Adds an event wherever the bodies of a contact begin to touch at a further place (kEngage) or cease to
/// (kRelease) between run.at.state, which is at s, and run.work.trial, h beyond it. Leaves run.work.trial
/// unchanged.
void note_shared_places(Run& run, const Path& path, SharedTouch touch, double s, double h);

/// The same for a shorter step, up to `h`, whose end is in run.work.trial.
void note_shared_places_until(Run& run, const Path& path, SharedTouch touch, double s, double h);

/// Adds the event that a contact has gone on, at s, at another place where the two bodies touch, with the
/// same velocities. If it has only just gone onto a corner at the place before, that event is removed.
void report_change_of_place(Run& run, const Path& path, double s, std::size_t contact);

/// If the contact of group g, in run.at.state at s, has just gone over a joint of spans behind which the
/// bodies would come to overlap at another place where they touch: goes on with that place, and adds an
/// event. Otherwise returns false and changes nothing. Gaps that begin to grow or fall there do so with the
/// square of the distance, so that for long it could not be seen from them which place holds.
[[nodiscard]] bool yield_to_shared_place(Run& run, const Path& path, double s, std::size_t g);

/// Where the contact of group g leaves its place in run.at.state, at s, as at the end of a curve: goes on
/// with another place at which the two bodies touch, and adds an event. If there is none, returns false and
/// changes nothing.
[[nodiscard]] bool take_over(Run& run, const Path& path, double s, std::size_t g);

/// If the contact comes with a corner to a corner or a notch at s, just beyond run.at.state: moves
/// run.at.state to s and lets it go on beyond (see vertex_passage), and adds an event. Otherwise returns
/// false and changes nothing.
[[nodiscard]] bool go_over_vertex(Run& run, const Path& path, double s, std::size_t g);

}  // namespace higherpair
