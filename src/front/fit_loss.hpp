#pragma once

#include "higherpair/io/tasks.hpp"

namespace higherpair {

/// ψ(u)/u of a loss, and ψ′, of a residual in units of its noise.
[[nodiscard]] double weight_of(FitLoss loss, double u);
[[nodiscard]] double slope_of(FitLoss loss, double u);

}  // namespace higherpair
