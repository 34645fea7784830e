#pragma once

#include <algorithm>

namespace higherpair {

/// The closed interval from low to high.
struct Bounds {
  double low = 0;
  double high = 0;

  [[nodiscard]] bool contains(double x) const { return low <= x && x <= high; }
  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] Bounds operator-() const { return {-high, -low}; }
};

/// The smallest interval that contains both.
[[nodiscard]] inline Bounds hull(const Bounds& a, const Bounds& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// The bounds of an enclosure with lower() and upper().
template <class Enclosure>
[[nodiscard]] Bounds to_bounds(const Enclosure& x) {
  return {x.lower(), x.upper()};
}

}  // namespace higherpair
