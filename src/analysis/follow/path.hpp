#pragma once

#include "higherpair/numeric/special_values.hpp"
#include "path_events.hpp"

namespace higherpair {

/// Follows the path; false if the branch is lost on it (run.at.on_branch is then false and an event describes
/// where). A curve is followed from break to break. Sets run.at.inputs to where run.at.state is, and
/// run.at.beside to the position at the end itself if that is near a crossing or a limit. \param first_step
/// the longest first step that may be tried, in the path's coordinate: where the path
///                    begins next to a limit or a pole, about the distance to that
bool follow(Run& run, const Path& path, double first_step = kInf);

}  // namespace higherpair
