#pragma once

#include "higherpair/analysis/run.hpp"

namespace higherpair {

/// Over a stretch that cannot be assembled angles go the short way, however far apart the rows are: takes
/// whole turns off the bodies and normals of run.at.state, so that where its stretch begins they are within
/// half a turn of where the branch was lost. Nothing is done where gears make a turn of one body matter to
/// others. \param lost   the last state before that stretch \param begin  run.at.state followed back to it
void take_short_way(Run& run, const State& lost, const State& begin);

}  // namespace higherpair
