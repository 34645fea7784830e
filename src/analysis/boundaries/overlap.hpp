#pragma once

#include "analysis/follow/step.hpp"
#include "analysis/follow/straight_path.hpp"
#include "meetings.hpp"
#include "shared_places.hpp"

namespace higherpair {

/// Which contacts could touch or overlap a second time: all in which one body is concave, except where a body
/// is everywhere more curved than the ring around it.
[[nodiscard]] std::vector<OverlapWatch> watched_contacts(const Mechanism& mechanism);

/// At the start of a run, or where the motion is resumed: sets which bodies overlap in run.at.state.
void renew_overlaps(Run& run);

/// Sets run.work.overlaps: which touching bodies overlap elsewhere in run.work.trial. For boundaries, whose
/// meetings are looked for before a step is taken, only whether they still do. False if nothing has changed
/// since before the step, so that watch_overlaps() need not be called.
[[nodiscard]] bool find_overlaps(Run& run);

/// Where in the step of `h` to run.work.trial, whose overlaps have been found, a driver and follower go over
/// to a second contact; none if they do not.
[[nodiscard]] std::optional<double> second_contact_within(Run& run, const Path& path, double s, double h);

/// Processes what find_overlaps() has found in run.work.trial, which is `h` of the path beyond run.at.state
/// at s. A driver and follower whose contact allows it go over to the second contact there (run.work.trial
/// changes); others are marked. Adds an event where an overlap begins. \returns whether the motion has gone
/// over to a second contact
bool watch_overlaps(Run& run, const Path& path, double s, double h);

/// Where touching boundaries meet elsewhere in a step.
struct Meetings {
  std::optional<Meeting> first;
  std::vector<SharedTouch> sharing;  ///< contacts that touch at several places in it
};

/// The meetings between run.at.state, which is at s, and run.work.trial, h beyond it; bodies that already
/// overlap are left out.
[[nodiscard]] Meetings meetings_elsewhere(Run& run, const Path& path, double s, double h);

/// Continues run.at.state, which is at s where two touching boundaries meet elsewhere, with the contact
/// there, if that keeps the bodies on the same side; otherwise marks them as overlapping. Adds an event.
/// \param may_go_over  false: only marks them
void go_over_to(Run& run, const Path& path, double s, const Meeting& meeting, bool may_go_over);

}  // namespace higherpair
