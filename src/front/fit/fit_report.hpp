#pragma once

#include "fit_search.hpp"

namespace higherpair {

/// The report on a fit, without the text of the new profile.
[[nodiscard]] FitReport fit_report(const FitProblem& problem, const FitSolution& solution);

}  // namespace higherpair
