#pragma once

#include "analysis/follow/path_events.hpp"
#include "higherpair/contact/near_places.hpp"

#include <optional>
#include <vector>

// Where the two bodies of a contact come to touch at another place than their contact. A place of least gap
// is followed through a step by the gap and its rate n·(v2 - v1) at both ends. Where the gap first falls and
// then rises, its least value within the step is computed, so that a place that is touched and left again
// between two steps is found like any other.

namespace higherpair {

/// A place at which two bodies come to touch.
struct Meeting {
  std::size_t contact = 0;
  double x = 0;   ///< distance beyond run.at.state on the path
  double at = 0;  ///< distance of the touch itself, which may lie before run.at.state by a rounding error
  NearPlace place;
};

/// Where else the two bodies of a contact meet in a step.
struct ContactMeeting {
  std::optional<Meeting> first;  ///< none if the bodies do not overlap anywhere
  /// Of boundaries: the other places at which smooth parts touch without overlapping, at the step's
  /// beginning and end.
  std::vector<NearPlace> sharing_before, sharing_after;
};

/// The first place at which the two bodies of a contact touch, other than their contact if they have one,
/// between run.at.state, which is at s, and run.work.trial, h beyond it. Leaves run.work.trial unchanged.
[[nodiscard]] ContactMeeting meeting_within(Run& run, const Path& path, std::size_t contact, double s,
                                            double h);

/// The length to which distances between the bodies of a contact are compared [m]: the size of the mechanism,
/// or how far out on their curves the contact is: on a parabola or hyperbola it may run off to infinity, and
/// the rounding of positions with it.
[[nodiscard]] double size_at_contact(const Run& run, const State& state, std::size_t contact);

/// Whether a place is that of a contact, to within the accuracy of its search.
/// \param size  of both boundaries together; for curves size_at_contact() [m]
[[nodiscard]] bool is_place_of(const CommonNormal& contact, const NearPlace& place, double size);

/// Whether neither boundary touches there with an end or a corner.
[[nodiscard]] bool is_smooth_touch(const NearPlace& place);

}  // namespace higherpair
