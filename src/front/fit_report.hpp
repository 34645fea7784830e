#pragma once

#include "fit_search.hpp"

namespace higherpair {

/// What a fit has found, but for the text of the new profile.
[[nodiscard]] FitReport fit_report(const FitProblem& problem, const FitSolution& solution);

}  // namespace higherpair
