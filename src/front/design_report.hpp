#pragma once

#include "design_rows.hpp"
#include "higherpair/front/design.hpp"

namespace higherpair {

/// The report on what a search of the task has found, but for its method. \pre something was found
[[nodiscard]] Result<DesignReport> design_report(const DesignSetup& setup, const DesignOutcome& outcome);

}  // namespace higherpair
