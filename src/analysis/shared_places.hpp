#pragma once

#include "higherpair/contact/near_places.hpp"
#include "straight_path.hpp"

#include <vector>

// Bodies of one contact of boundaries that touch at several places without getting into each other: two pairs
// of teeth at once, the next one before the one before it has ended. The motion stays with one place, and all
// of them agree with it; where it ends at the end of a curve another one takes over.

namespace higherpair {

/// At which places besides their contact two bodies touch at the begin and at the end of a step.
struct SharedTouch {
  std::size_t contact = 0;
  std::vector<NearPlace> before, after;
};

/// Adds an event wherever the bodies of a contact begin to touch at a further place between run.at.state,
/// which is at s, and run.work.trial, h beyond it (kEngage), or cease to (kRelease). run.work.trial is left
/// as it is.
void note_shared_places(Run& run, const Path& path, SharedTouch touch, double s, double h);

/// The same of a shorter step, up to `h`, whose end is in run.work.trial.
void note_shared_places_until(Run& run, const Path& path, SharedTouch touch, double s, double h);

/// Where the contact of group g has come to the end of a curve in run.at.state, at s: goes on with another
/// place at which the two bodies touch. False, and nothing done, if there is none. Adds an event.
[[nodiscard]] bool take_over(Run& run, const Path& path, double s, std::size_t g);

/// Where it comes with a corner to a corner or a notch at s, just beyond run.at.state: lets that, at s, go on
/// beyond it (see vertex_passage). False, and nothing done, elsewhere. Adds an event.
[[nodiscard]] bool go_over_vertex(Run& run, const Path& path, double s, std::size_t g);

}  // namespace higherpair
