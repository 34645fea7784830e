#pragma once

#include "fit_problem.hpp"

namespace higherpair {

/// Columns, drivers and times whose values would fit the profile's motion as it is if they were in
/// another unit, and do not as they are: a message for each. What has its unit in the header is believed.
[[nodiscard]] Diagnostics unit_suspicions(const FitProblem& problem);

}  // namespace higherpair
