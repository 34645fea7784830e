#pragma once

#include "higherpair/front/sensitivity.hpp"

#include <array>

namespace higherpair {

/// The derivative of a result from its values at a number less 2 h, less h, at it, and as far above; NaN:
/// there is none.
/// \param rounding  a bend of the values by less is none
[[nodiscard]] Slope slope_by_differences(const std::array<double, 5>& values, double h, double rounding);

}  // namespace higherpair
