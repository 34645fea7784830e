#pragma once

#include "higherpair/analysis/run.hpp"

#include <vector>

namespace higherpair {

/// The bodies in the position of the last row, with one driver moving at unit rate and the others at rest.
/// \return the bodies of a state of `run` if it has one driver, else those of `scratch`, set to that motion:
/// copy what is to outlast a change of either
[[nodiscard]] const std::vector<BodyMotion>& unit_motion(const Run& run, std::size_t driver, State& scratch);

}  // namespace higherpair
