#pragma once

#include "straight_path.hpp"

#include <limits>

namespace higherpair {

/// Follows the path; false if the branch is lost on it (run.at.held is then false and an event says
/// where). Sets run.at.drivers to where run.at.state is, and run.at.beside to the end itself where that
/// is near a crossing or a limit.
/// \param first_step  the longest that may be tried at first, in the path's coordinate: where the path begins
///                    next to a limit or a pole, about as far as that is away
bool follow(Run& run, const Path& path, double first_step = std::numeric_limits<double>::infinity());

}  // namespace higherpair
