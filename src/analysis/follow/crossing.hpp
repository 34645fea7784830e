#pragma once

#include "path_events.hpp"
#include "step.hpp"

namespace higherpair {

/// Whether a group is so near to where its branches may cross that its closed form loses digits.
[[nodiscard]] bool is_near_crossing(const Run& run, const State& state);

/// How far from a crossing of branches, in s, positions are regular and can be interpolated from.
/// \param state  near the crossing; the faster its bodies move, the nearer
[[nodiscard]] double crossing_reach(const Run& run, const Path& path, const State& state);

/// Sets `b` to the position at the fraction t of the step from `a` to it, which lead from one side of a
/// crossing to the other: quintics of Hermite from positions, velocities and accelerations.
/// \param h  from `a` to `b`, in s
void interpolate(const Run& run, const State& a, double h, double t, State& b);

/// Near a crossing of branches a closed form loses digits: as 1/distance for velocities, as its square for
/// accelerations; at the crossing it gives no rates. If branches cross at or near the end of the path, `rest`
/// beyond run.at.state at s, the position there is interpolated between both sides into run.work.trial;
/// run.at.beside is set to it, and run.at.inputs to where run.at.state is. Otherwise returns false and
/// leaves run.work.trial unchanged.
[[nodiscard]] bool stop_near_crossing(Run& run, const Path& path, double s, double rest);

}  // namespace higherpair
