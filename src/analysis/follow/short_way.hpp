#pragma once

#include "higherpair/analysis/run.hpp"

namespace higherpair {

/// Across a range in which the mechanism cannot be assembled, angles take the short way, however far apart
/// the rows are: removes whole turns from the bodies and normals of run.at.state, so that where its stretch
/// begins they are within half a turn of where the branch was lost. Does nothing where gears make whole turns
/// of one body matter to others.
/// \param lost   the last state before that range
/// \param begin  run.at.state followed back to the beginning of its stretch
void take_short_way(Run& run, const State& lost, const State& begin);

}  // namespace higherpair
