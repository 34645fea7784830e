#pragma once

#include "higherpair/geometry/curve.hpp"

#include <algorithm>

namespace higherpair {

/// The ends of an interval, as numeric/interval.hpp has it.
template <class Enclosure>
[[nodiscard]] Bounds to_bounds(const Enclosure& x) {
  return {x.lower(), x.upper()};
}

/// From the lower begin to the higher end.
[[nodiscard]] inline Bounds hull(const Bounds& a, const Bounds& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace higherpair
