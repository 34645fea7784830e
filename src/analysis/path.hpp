#pragma once

#include "straight_path.hpp"

namespace higherpair {

/// Follows the path; false if the branch is lost on it (run.at.held is then false and an event says
/// where). Sets run.at.drivers to where run.at.state is, and run.at.beside to the end itself where that
/// is near a crossing or a limit.
bool follow(Run& run, const Path& path);

}  // namespace higherpair
