#pragma once

#include "higherpair/front/design.hpp"

#include <vector>

namespace higherpair::bench {

/// A four-bar whose point is to pass a hundred places, each at its position of the crank.
struct DesignCase {
  DesignProblem problem;
  std::vector<std::vector<double>> candidates;  ///< near one whose path these places are
};

/// Ends the program where the linkage that the places come from misses them, or where derivatives are not
/// those of differences.
[[nodiscard]] DesignCase checked_design();

}  // namespace higherpair::bench
