#pragma once

// Tolerances of the variants of a sweep.

namespace higherpair {

/// Smallest share of a normal distribution that must lie between its limits: of less, quantiles have lost
/// their digits.
inline constexpr double kLeastShareWithin = 1e-9;

}  // namespace higherpair
