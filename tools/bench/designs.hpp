#pragma once

#include "higherpair/front/design.hpp"

#include <vector>

namespace higherpair::bench {

/// A four-bar whose coupler point is to pass through a hundred points, each at a given position of the crank.
struct DesignCase {
  DesignProblem problem;
  std::vector<std::vector<double>> candidates;  ///< close to the one whose path has these points
};

/// Ends the program if the linkage that the points come from misses them, or if derivatives differ from
/// differences.
[[nodiscard]] DesignCase checked_design();

}  // namespace higherpair::bench
