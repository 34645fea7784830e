#pragma once

#include "fit_problem.hpp"

namespace higherpair {

/// A message for each column, driver or time whose values do not fit the profile's motion in the assumed
/// unit, but would in another one. Units given in the header are trusted.
[[nodiscard]] Diagnostics unit_suspicions(const FitProblem& problem);

}  // namespace higherpair
