#pragma once

#include "higherpair/analysis/run.hpp"

#include <vector>

namespace higherpair {

/// The bodies in the position of the last row, with one driver moving at unit rate and the others at rest.
/// \param scratch  used where there are several drivers; the result is valid until it or the run changes
[[nodiscard]] const std::vector<BodyMotion>& unit_motion(const Run& run, std::size_t driver, State& scratch);

}  // namespace higherpair
