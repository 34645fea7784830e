#pragma once

#include "step.hpp"
#include "straight_path.hpp"

namespace higherpair {

/// Whether a group is so near to where its branches may cross that its closed form loses digits.
[[nodiscard]] bool is_near_crossing(const Run& run, const State& state);

/// Near a crossing of branches a closed form loses digits (1/distance for velocities, its square for
/// accelerations), and at it all rates. If branches cross at the end of the path, `rest` beyond run.at.state
/// at s, or near there, the position there is interpolated between both sides (quintic Hermite from
/// positions, velocities and accelerations) into run.work.trial, run.at.beside is set, and run.at.drivers to
/// where run.at.state is. Else false, and run.work.trial as it was.
[[nodiscard]] bool stop_near_crossing(Run& run, const Path& path, double s, double rest);

}  // namespace higherpair
