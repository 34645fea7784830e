#pragma once

#include "meetings.hpp"
#include "shared_places.hpp"
#include "step.hpp"
#include "straight_path.hpp"

namespace higherpair {

/// Which contacts could touch or cut a second time: all in which one body is concave, but for a body that is
/// everywhere more curved than the ring about it.
[[nodiscard]] std::vector<OverlapWatch> watched_contacts(const Mechanism& mechanism);

/// Where a run starts, or a branch is taken up again: sets which bodies overlap in run.at.state.
void renew_overlaps(Run& run);

/// Sets run.work.overlaps: which touching bodies are in each other elsewhere in run.work.trial. Of
/// boundaries, whose meetings are looked for before a step is taken, it says only whether they still are.
/// False where that is as before the step, so that there is nothing to take note of.
[[nodiscard]] bool find_overlaps(Run& run);

/// Where in the step of `h` to run.work.trial, whose overlaps have been found, a driver and follower go over
/// to a second contact; none where none does.
[[nodiscard]] std::optional<double> second_contact_within(Run& run, const Path& path, double s, double h);

/// Takes note of what find_overlaps has found in run.work.trial, which is `h` of the path beyond run.at.state
/// at s. A driver and follower whose contact allows it go over to the second contact there (run.work.trial is
/// changed); others are marked. Adds an event where this begins. Whether a contact has been gone over to.
bool watch_overlaps(Run& run, const Path& path, double s, double h);

/// Where touching boundaries meet elsewhere in a step.
struct Meetings {
  std::optional<Meeting> first;
  std::vector<SharedTouch> sharing;  ///< contacts that touch at several places in it
};

/// The meetings between run.at.state, which is at s, and run.work.trial, h beyond it; of bodies that are in
/// each other already none.
[[nodiscard]] Meetings meetings_elsewhere(Run& run, const Path& path, double s, double h);

/// Lets run.at.state, which is at s where two touching boundaries meet elsewhere, go on with the contact
/// there, if that keeps the bodies on the same side; else they are marked as in each other. Adds an event.
/// \param may_go_over  false: only marked
void go_over_to(Run& run, const Path& path, double s, const Meeting& meeting, bool may_go_over);

}  // namespace higherpair
