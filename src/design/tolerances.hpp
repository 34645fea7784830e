#pragma once

// The tolerances of this room. Variables are scaled to their ranges, constraints and objectives to the order
// of 1.

namespace higherpair {

/// Central differences: the step of u that loses least, of the cube root of the rounding in the values.
inline constexpr double kDesignDifference = 1e-6;
/// A constraint, or a distance from a bound, as small as this is active.
inline constexpr double kActiveConstraint = 1e-6;
/// Of the objective: a gain for which a search begins again from its best point.
inline constexpr double kWorthwhileGain = 1e-6;
/// Last change of the variables, and of the objective, that ends a search.
inline constexpr double kVariablesSettled = 1e-12;
inline constexpr double kObjectiveSettled = 1e-14;
/// Of a variable's step: a value that lies on a multiple of it.
inline constexpr double kOnDesignStep = 1e-9;
/// Every third search begins near the best so far; how far is drawn from this range, as shares.
inline constexpr double kNearBestLeast = 0.003;
inline constexpr double kNearBestMost = 0.3;
/// Of the range of each variable: ends of two searches are one.
inline constexpr double kSameOptimum = 1e-3;

}  // namespace higherpair
