#pragma once

#include "higherpair/analysis/run.hpp"

namespace higherpair {

/// The largest closure error of run.row, from the conditions of the joints and contacts themselves,
/// independently of how the row was computed: distances of joint points and of contact points, differences of
/// angles times the size, and disagreements of the velocities there, times size/(largest speed) [m].
[[nodiscard]] double residual_of(const Run& run);

}  // namespace higherpair
