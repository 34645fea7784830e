#pragma once

// The tolerances of this folder. Variables are scaled to their ranges, constraints and objectives to the
// order of 1.

namespace higherpair {

/// Step of u for central differences: of the order of the cube root of the rounding in the values, where the
/// error is least.
inline constexpr double kDesignDifference = 1e-6;
/// A constraint is active if it is within this of its limit, a bound if u is within this of it.
inline constexpr double kActiveConstraint = 1e-6;
/// Gain, as a fraction of the objective, for which a search begins again from its best point.
inline constexpr double kWorthwhileGain = 1e-6;
/// Step of u at which a search by gradients looks for something better where it has ended.
inline constexpr double kLookAround = 1e-3;
/// Penalty per unit of violation, for the methods that do not support constraints: far above objectives,
/// which are of the order of 1.
inline constexpr double kPenalty = 1e3;
/// First step of a search, as a fraction of the range of each variable: long enough to leave the noise of a
/// flat objective, short enough to stay in the neighbourhood of the start.
inline constexpr double kFirstDesignStep = 0.05;
/// A search ends when the relative change of the variables, or of the objective, is below these.
inline constexpr double kVariablesSettled = 1e-12;
inline constexpr double kObjectiveSettled = 1e-14;
/// Fraction of a variable's step within which a value counts as a multiple of it.
inline constexpr double kOnDesignStep = 1e-9;
/// Every third search starts near the best so far, at a distance drawn from this range (fractions of the
/// range of each variable).
inline constexpr double kNearBestLeast = 0.003;
inline constexpr double kNearBestMost = 0.3;
/// Fraction of the range of each variable within which the results of two searches count as the same.
inline constexpr double kSameOptimum = 1e-3;

}  // namespace higherpair
