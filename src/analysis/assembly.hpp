#pragma once

#include "higherpair/analysis/run.hpp"

namespace higherpair {

/// Sets run.state to the assembly nearest to the poses at run.drivers, without rates; says why there is none.
[[nodiscard]] std::optional<StartFailure> assemble(Run& run);

}  // namespace higherpair
