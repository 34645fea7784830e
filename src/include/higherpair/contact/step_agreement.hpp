#pragma once

#include <cmath>

namespace higherpair {

/// Largest difference between a step's solution and its prediction that is accepted, as a fraction of the
/// change in that step: beyond it the step may have jumped to another branch.
inline constexpr double kStepAgreement = 0.25;

/// The same where the branch changes, because branches cross within the step.
inline constexpr double kCrossingAgreement = 0.03;

/// The cosine of the angle by which a contact's normal may turn in one step: 30 degrees.
inline constexpr double kCosFarthestTurn = 0.866;

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
