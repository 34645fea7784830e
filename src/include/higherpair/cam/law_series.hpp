#pragma once

#include "higherpair/cam/motion_law.hpp"
#include "higherpair/geometry/expansion.hpp"

namespace higherpair {

/// The Taylor series of a law's value at x.
template <int N>
[[nodiscard]] PowerSeries<double, N> series_at(const MotionLaw& law, double x,
                                               LawSide side = LawSide::kAfter) {
  PowerSeries<double, N> s;
  law.expand(x, side, s.c);
  return s;
}

}  // namespace higherpair
