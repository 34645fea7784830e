#pragma once

#include <cmath>

namespace higherpair {

/// How far the solution of a step may be from its prediction, of the change in that step: else it may be on
/// another branch.
inline constexpr double kStepAgreement = 0.25;

/// The same where the branch changes, because branches cross within the step.
inline constexpr double kCrossingAgreement = 0.03;

/// Of a step: a way no longer than this is one step, so that no rest of rounding is left.
inline constexpr double kAlmostThere = 1.001;

/// Whether what is 0 where branches cross has come nearer to 0 in a step h, but not as its rates at both ends
/// say. Next to a crossing a step agrees with its prediction on either branch; on the one that is not its own
/// this turns back.
[[nodiscard]] inline bool turns_back(double from, double from_rate, double to, double to_rate, double h) {
  constexpr double kSmooth = 0.25;  // of the change
  const double rise = to - from;
  return std::abs(to) < std::abs(from) / 2 &&
         !(std::abs(rise - h * (from_rate + to_rate) / 2) <= kSmooth * std::abs(rise));
}

}  // namespace higherpair
