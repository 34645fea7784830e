#pragma once

#include "higherpair/contact/tolerances.hpp"

#include <cmath>

namespace higherpair {

/// Whether what is 0 where branches cross has come nearer to 0 in a step h, but not as its rates at both ends
/// say. Next to a crossing a step agrees with its prediction on either branch; on the one that is not its own
/// this turns back.
[[nodiscard]] inline bool turns_back(double from, double from_rate, double to, double to_rate, double h) {
  const double rise = to - from;
  return std::abs(to) < std::abs(from) / 2 &&
         !(std::abs(rise - h * (from_rate + to_rate) / 2) <= kSmoothRise * std::abs(rise));
}

}  // namespace higherpair
