#pragma once

#include "higherpair/analysis/run.hpp"

#include <vector>

namespace higherpair {

/// Looks for the branch held last at the drivers' positions; true if it is there again. Adds an event that
/// tells where on the path from `from`, the row before, this stretch begins.
bool resume(Run& run, const std::vector<double>& drivers, const std::vector<double>& from);

}  // namespace higherpair
