#pragma once

#include "higherpair/contact/near_places.hpp"
#include "straight_path.hpp"

#include <optional>
#include <vector>

// Where the two bodies of a contact of boundaries come together at another place than that of their contact.
// A place of least gap is followed through a step by the gap and its rate n·(v2 - v1) at both ends. Where the
// gap falls first and rises then, its least value within the step is looked at, so that a place that is
// touched and left again between two steps is found like any other.

namespace higherpair {

/// A place at which two bodies come to touch.
struct Meeting {
  std::size_t contact = 0;
  double x = 0;   ///< beyond run.at.state on the path
  double at = 0;  ///< the same of the touch itself, which may lie before run.at.state by a rounding
  NearPlace place;
};

/// What the two bodies of a contact do elsewhere in a step.
struct ContactMeeting {
  std::optional<Meeting> first;  ///< none if they are in each other nowhere
  /// The other places at which smooth parts touch, and are no deeper in each other, at the step's begin and
  /// end.
  std::vector<NearPlace> sharing_before, sharing_after;
};

/// The first place at which the two bodies of a contact by_boundary touch, besides their contact if they have
/// one, between run.at.state, which is at s, and run.work.trial, h beyond it. run.work.trial is left as it
/// is.
[[nodiscard]] ContactMeeting meeting_within(Run& run, const Path& path, std::size_t contact, double s,
                                            double h);

/// Whether a place is that of a contact, to within what its search leaves.
/// \param size  of both boundaries together [m]
[[nodiscard]] bool is_place_of(const CommonNormal& contact, const NearPlace& place, double size);

/// Whether neither of the two is an end or a corner.
[[nodiscard]] bool is_smooth_touch(const NearPlace& place);

}  // namespace higherpair
