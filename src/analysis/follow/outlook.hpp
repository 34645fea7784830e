#pragma once

#include "analysis/tolerances.hpp"
#include "line_ahead.hpp"
#include "step.hpp"

#include <cmath>
#include <optional>
#include <vector>

// Looks between positions on a line of the drivers at which a lost branch cannot be placed.

namespace higherpair {

/// Where a lost contact has been found again.
struct PlacedContact {
  Vector2d p_W, n_W;
};

/// How much of the mechanism can be placed at a position on the line, and whether that is less (-1) or more
/// (1) a little further ahead; 0: the same, or unknown.
struct Outlook {
  double x = 0;
  Placeable placing;
  int rises = 0;
  double slope = 0;  ///< of Placeable::room, if the same condition fails a little further ahead; else NaN
  std::vector<PlacedContact> contacts;  ///< of the groups that can be placed
};

/// A number rounded to the grid of the search for lost bodies: a long search would magnify the rounding
/// errors in which runs with other rows differ. \param unit  1 for angles, the size for lengths
[[nodiscard]] inline double on_search_grid(double x, double unit) {
  return std::round(x / (kSearchGrid * unit)) * (kSearchGrid * unit);
}

/// Changes run.work.trial. \param spacing  distance to the next position that is tested
[[nodiscard]] Outlook outlook_at(Run& run, const LineAhead& line, double x, double spacing);

/// A position between two others at which the branch cannot be placed where it can be: between conditions
/// that fail or places at which contacts are found, or where one condition fails least.
[[nodiscard]] std::optional<double> placed_between(Run& run, const LineAhead& line, const Outlook& a,
                                                   const Outlook& b);

}  // namespace higherpair
