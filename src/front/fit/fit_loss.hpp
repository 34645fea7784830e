#pragma once

#include "higherpair/io/tasks.hpp"

namespace higherpair {

/// ψ(u)/u and ψ′(u) of a loss function, for a residual u in units of its noise.
[[nodiscard]] double weight_of(FitLoss loss, double u);
[[nodiscard]] double slope_of(FitLoss loss, double u);

}  // namespace higherpair
