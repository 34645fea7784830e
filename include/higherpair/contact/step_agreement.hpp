#pragma once

namespace higherpair {

/// How far the solution of a step may be from its prediction, of the change in that step: else it may be on
/// another branch.
inline constexpr double kStepAgreement = 0.25;

/// The same where the branch changes, because branches cross within the step.
inline constexpr double kCrossingAgreement = 0.03;

}  // namespace higherpair
