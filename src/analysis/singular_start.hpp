#pragma once

#include "higherpair/analysis/run.hpp"

#include <optional>

namespace higherpair {

/// Moves a run whose first position is singular a little back (or on, where it cannot go back), to a regular
/// position from which the first one is reached as any other; where it is singular to within rounding it is
/// kept as the first row (run.at.beside). Of branches that cross there the one with the slower motion is
/// taken, of equally fast ones the steadier, of two that meet in a limit the one nearer to the poses.
/// \returns the contact, if any, that is to start where it is singular and has no regular position near by
[[nodiscard]] std::optional<int> leave_singular_start(Run& run);

}  // namespace higherpair
