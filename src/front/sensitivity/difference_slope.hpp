#pragma once

#include "higherpair/front/sensitivity.hpp"

#include <array>

namespace higherpair {

/// The derivative of a smooth quantity, to fourth order, from its values for a number changed by -2 h, -h, h
/// and 2 h.
[[nodiscard]] double slope_beside(const std::array<double, 4>& values, double h);

/// The derivative of a result from its values for a number changed by -2 h, -h, 0, h and 2 h; a value is NaN
/// where there is none.
/// \param rounding  smaller second differences of the values are rounding
[[nodiscard]] Slope slope_by_differences(const std::array<double, 5>& values, double h, double rounding);

}  // namespace higherpair
