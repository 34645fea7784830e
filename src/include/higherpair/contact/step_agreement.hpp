#pragma once

#include "higherpair/contact/tolerances.hpp"

#include <cmath>

namespace higherpair {

/// Whether the solution of a step is where it was predicted, to a share of the change in the step.
/// \param mismatch  between prediction and solution, in the units of `change` (radians, or sizes of the pair)
[[nodiscard]] inline bool is_as_predicted(double mismatch, double change, double share) {
  return mismatch <= share * change + kInnerMismatch;
}

/// Whether the quantity that is 0 at a change point has come closer to 0 in a step h, but not as its rates at
/// both ends predict. Next to a change point a step agrees with its prediction on either branch; on the wrong
/// one this quantity turns back.
[[nodiscard]] inline bool turns_back(double from, double from_rate, double to, double to_rate, double h) {
  const double rise = to - from;
  return std::abs(to) < std::abs(from) / 2 &&
         !(std::abs(rise - h * (from_rate + to_rate) / 2) <= kSmoothRise * std::abs(rise));
}

}  // namespace higherpair
