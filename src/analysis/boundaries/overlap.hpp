#pragma once

#include "analysis/follow/path_events.hpp"
#include "analysis/follow/step.hpp"
#include "meetings.hpp"
#include "shared_places.hpp"

namespace higherpair {

/// Which contacts could touch or overlap a second time: all in which one body is concave, except where a body
/// is everywhere more curved than the ring around it.
[[nodiscard]] std::vector<OverlapWatch> watched_contacts(const Mechanism& mechanism);

/// At the start of a run, or where the motion is resumed: sets which bodies overlap in run.at.state.
void renew_overlaps(Run& run);

/// After a step: which of the bodies that have overlapped still do so in run.at.state.
void end_overlaps(Run& run);

/// Where touching bodies meet elsewhere in a step.
struct Meetings {
  std::optional<Meeting> first;
  std::vector<SharedTouch> sharing;  ///< contacts that touch at several places in it
};

/// The meetings between run.at.state, which is at s, and run.work.trial, h beyond it; bodies that already
/// overlap are left out.
[[nodiscard]] Meetings meetings_elsewhere(Run& run, const Path& path, double s, double h);

/// Continues run.at.state, which is at s where two touching bodies meet elsewhere, with the contact
/// there, if that keeps the bodies on the same side; otherwise marks them as overlapping. Adds an event.
/// \param may_go_over  false: only marks them
void go_over_to(Run& run, const Path& path, double s, const Meeting& meeting, bool may_go_over);

}  // namespace higherpair
