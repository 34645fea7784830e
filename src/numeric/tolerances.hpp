#pragma once

// The tolerances of this room. Its methods know of no model: numbers are shares of what they are compared
// with, of the largest one, or of the interval, from -1 to 1.

namespace higherpair {

// In place of a divisor that may be 0, or added to it: no other number is changed by it.
inline constexpr double kNeverZero = 1e-300;

// Least squares.
inline constexpr double kFirstDamping = 1e-3;  // of the scaled columns
inline constexpr double kLeastDamping = 1e-12;
inline constexpr double kMostDamping = 1e20;
inline constexpr double kNoChangeRank = 1e-11;  // of the largest: what counts as no change of r at all
inline constexpr double kLeastGain = 1e-22;     // of the sum: the best step gains less
inline constexpr double kUnseenGain = 1e-12;    // the same: rounding of the sum may hide it
inline constexpr double kSameSum = 1e-14;       // of the sum: one that is no larger but for rounding
inline constexpr double kNoGain = 1e-8;         // of the sum, where no step gains anything
inline constexpr double kNoFitStep = 4e-16;     // of the variables: a step that is none

// Chebyshev series.
inline constexpr double kNarrowestBelow = 1e-14;  // an interval at whose begin a series is below a level
inline constexpr double kNarrowestLower = 1e-9;   // an interval in which no lower value is looked for
inline constexpr double kNearMinimum = 1e-3;      // a step of Newton's method to the minimum that it is near

// The largest value of a function, by series over intervals that are halved.
inline constexpr double kPeakRounding = 1e-12;  // of the largest sample
inline constexpr double kTermsFall = 1.4;       // last terms of a half that fall less do not fall
inline constexpr double kRoughTerms = 1e5;      // times the noise: more is no rounding
inline constexpr double kFarthestSeries = 20;   // times the last terms: farther no series is, even at a jump
inline constexpr double kFineOfNoise = 1e-3;    // precision of the lowest value, of the noise
inline constexpr double kFineOfTerms = 0.1;     // and of the last terms

// Splines. Weights on smoothness in units in which the points are 1 apart, as powers of ten: from a spline
// that goes through all points, to within rounding, to a polynomial.
inline constexpr double kLightestSmoothing = -10;
inline constexpr double kHeaviestSmoothing = 16;

// Band matrices. What is smaller is taken for 0: influence falls off along a band, and numbers that leave the
// normal range on their way to 0 are slow.
inline constexpr double kBandNothing = 1e-250;

// Intervals. How near to an end of an interval of angles an extreme of their sine lies within, of a radian
// and of the angle.
inline constexpr double kExtremeSlack = 1e-15;

}  // namespace higherpair
