#pragma once

#include "design_rows.hpp"
#include "higherpair/front/design.hpp"

namespace higherpair {

/// Reports the result of a search, except its method. \pre something was found
[[nodiscard]] Result<DesignReport> design_report(const DesignSetup& setup, const DesignOutcome& outcome);

}  // namespace higherpair
