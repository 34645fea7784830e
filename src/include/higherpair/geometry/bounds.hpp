#pragma once

#include "higherpair/geometry/curve.hpp"

#include <algorithm>

namespace higherpair {

/// Converts an interval of numeric/interval.hpp.
template <class Enclosure>
[[nodiscard]] Bounds to_bounds(const Enclosure& x) {
  return {x.lower(), x.upper()};
}

/// The smallest interval that contains both.
[[nodiscard]] inline Bounds hull(const Bounds& a, const Bounds& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace higherpair
