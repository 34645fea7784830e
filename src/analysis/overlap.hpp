#pragma once

#include "path.hpp"
#include "step.hpp"

namespace higherpair {

/// Which contacts could touch or cut a second time: all in which one body is concave, but for a body that is
/// everywhere more curved than the ring about it.
[[nodiscard]] std::vector<OverlapWatch> watched_contacts(const Mechanism& mechanism);

/// Where two bodies that are apart in run.at.state, which is at s, first touch on the way to run.work.trial,
/// h beyond.
struct Closing {
  double x = 0;          ///< beyond run.at.state on the path
  ContactMotion motion;  ///< near their contact: its normal, or its places
};
/// None if they are apart in run.work.trial. run.work.trial is left as it is.
[[nodiscard]] std::optional<Closing> closing_within(Run& run, const Path& path, const Contact& contact,
                                                    double s, double h);

/// Where a branch is taken up again: sets which bodies overlap in run.at.state.
void renew_overlaps(Run& run);

/// Looks for overlaps of touching bodies elsewhere in run.work.trial, which is `h` of the path beyond
/// run.at.state at s. A driver and follower whose contact allows it go over to the second contact there
/// (run.work.trial is changed); others are marked. Adds an event where this begins.
void watch_overlaps(Run& run, const Path& path, double s, double h);

}  // namespace higherpair
