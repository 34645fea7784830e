#pragma once

#include "path.hpp"
#include "step.hpp"

namespace higherpair {

/// Whether a group stands so near to where its branches may cross that its closed form loses digits.
[[nodiscard]] bool is_near_crossing(const Run& run, const State& state);

/// Near a crossing of branches a closed form loses digits (1/distance for velocities, its square for
/// accelerations), and at it all rates. If the end of the path, `rest` beyond run.state at s, is such a
/// place, the position there is interpolated between both sides (quintic Hermite from positions, velocities
/// and accelerations) into run.trial. False, with run.trial at the end of the path as solved, where branches
/// do not cross there.
/// \param refused  the end of the path could not be taken as solved, so that run.trial tells nothing of it
[[nodiscard]] bool stop_near_crossing(Run& run, const Path& path, double s, double rest,
                                      bool refused = false);

/// Moves a run whose first position is singular a little back (or on, where it cannot go back), to a regular
/// position from which the first one is reached as any other; where it is singular to rounding it is kept as
/// the first row (run.between). Of branches that cross there the one with the slower motion is taken, of
/// equally fast ones the steadier, of two that meet in a limit the one nearer to the poses.
/// \returns the contact, if any, that is to start where it is singular and has no regular position near by
[[nodiscard]] std::optional<int> leave_singular_start(Run& run);

}  // namespace higherpair
