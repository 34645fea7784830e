#pragma once

#include "higherpair/analysis/run.hpp"

#include <vector>

namespace higherpair {

/// Looks for the branch that was lost at the drivers' positions; true if it exists there again. Adds an event
/// where, on the path from `from`, the row before, this stretch of it begins.
bool resume(Run& run, const std::vector<double>& drivers, const std::vector<double>& from);

}  // namespace higherpair
