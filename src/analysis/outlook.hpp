#pragma once

#include "line_ahead.hpp"
#include "step.hpp"

#include <optional>

// What lies between positions on a line of the drivers at which a branch that was lost cannot be placed.

namespace higherpair {

/// How much can be placed at a position on the line, and whether that is less (-1) or more (1) than a
/// little ahead; 0: as much, or nothing is known of it.
struct Outlook {
  double x = 0;
  Placeable placing;
  int rises = 0;
  double slope = 0;  ///< of Placeable::room, where it is of the same condition; else NaN
};

/// Uses run.work.trial. \param spacing  to the next position that is looked at
[[nodiscard]] Outlook outlook_at(Run& run, const LineAhead& line, double x, double spacing);

/// Where the branch can be placed between two positions at which it cannot: between conditions that fail, or
/// where one fails least.
[[nodiscard]] std::optional<double> placed_between(Run& run, const LineAhead& line, const Outlook& a,
                                                   const Outlook& b);

}  // namespace higherpair
