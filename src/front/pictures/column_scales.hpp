#pragma once

#include "higherpair/front/motion.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// The largest absolute value of those that are finite; 0 if there are none.
[[nodiscard]] double largest_of(std::span<const double> values);

/// For each column the largest absolute value of all columns of its unit, for accelerations at least
/// speed²/travel: what is smaller than kColumnNoise times it is rounding.
/// \param largest  absolute value of each column; 0 where it has none
[[nodiscard]] std::vector<double> scales_of(const std::vector<Column>& columns,
                                            const std::vector<double>& largest);

}  // namespace higherpair
