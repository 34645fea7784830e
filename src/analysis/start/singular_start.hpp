#pragma once

#include "higherpair/analysis/run.hpp"

#include <optional>

namespace higherpair {

/// Moves a run whose first position is singular a little back (or forward, if it cannot go back), to a
/// regular position from which the first one is reached like any other; if the first position is singular to
/// within rounding it is kept as the first row (run.at.beside). Of branches that cross there the one with the
/// slower motion is taken, of equally fast ones the one with the smaller acceleration; of two that meet in a
/// limit the one nearer to the poses.
/// \returns the contact, if any, that starts where it is singular and has no regular position nearby
[[nodiscard]] std::optional<int> leave_singular_start(Run& run);

}  // namespace higherpair
