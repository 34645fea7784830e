#pragma once

#include "group_solver.hpp"
#include "higherpair/analysis/run.hpp"

#include <vector>

namespace higherpair {

/// Sets the ends of a path.
void set_path(Path& path, const std::vector<double>& from, const std::vector<double>& to);

/// Follows the path; false if the branch is lost on the way (run.held is then false and an event says where).
bool follow(Run& run, const Path& path);

/// Looks for the branch held last at the drivers' positions; true if it is there again.
bool resume(Run& run, const std::vector<double>& drivers);

}  // namespace higherpair
