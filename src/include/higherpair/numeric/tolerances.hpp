#pragma once

// Tolerances of the numerical methods. They do not depend on any model: numbers are relative to what they are
// compared with, to the largest one, or to the interval from -1 to 1.

namespace higherpair {

// Replaces a divisor that may be 0, or is added to it: too small to change any other number.
inline constexpr double kNeverZero = 1e-300;

// Least squares.
inline constexpr double kFirstDamping = 1e-3;  // relative to the scaled columns
inline constexpr double kLeastDamping = 1e-12;
inline constexpr double kMostDamping = 1e20;
// Singular directions below this fraction of the largest do not change r at all.
inline constexpr double kNoChangeRank = 1e-11;
// The best step gains less than this fraction of the sum: converged.
inline constexpr double kLeastGain = 1e-22;
inline constexpr double kUnseenGain = 1e-12;  // rounding of the sum may hide a gain below this fraction
inline constexpr double kSameSum = 1e-14;     // increase of the sum, as a fraction, that is rounding
// Converged if no step gains anything and the best predicted gain is below this fraction of the sum.
inline constexpr double kNoGain = 1e-8;
inline constexpr double kNoFitStep = 4e-16;  // steps below this fraction of the variables count as 0

// Newton's method. Steps are expected to converge quadratically below this size [rad, units of length].
inline constexpr double kNewtonQuadratic = 1e-9;
inline constexpr double kNewtonLeast = 1e-17;  // steps up to this size count as zero [rad, units of length]
// Root of a function in an interval: steps below this fraction of its width converge quadratically, or are
// rounding.
inline constexpr double kNewtonRootNear = 1e-9;
// Where the function jumps beyond its root, steps stop short of the predicted root. Least and greatest
// fraction of the step that is left out; the least exceeds rounding.
inline constexpr double kLeastShortOfRoot = 1e-6;
inline constexpr double kMostShortOfRoot = 0.1;

// Chebyshev series.
inline constexpr double kNarrowestBelow = 1e-14;  // narrowest interval examined for a crossing of a level
inline constexpr double kNarrowestLower = 1e-9;   // narrowest interval searched for a lower value
inline constexpr double kNearMinimum = 1e-3;      // largest Newton step to a minimum close by

// The largest value of a function, by series over intervals that are halved.
inline constexpr double kPeakRounding = 1e-12;  // rounding of values, relative to the largest sample
// Last terms of a half that fall by less than this factor do not fall any more.
inline constexpr double kTermsFall = 1.4;
inline constexpr double kRoughTerms = 1e5;  // last terms above this multiple of the noise are not rounding
// Largest error of a series, in multiples of its last terms, even at a jump.
inline constexpr double kFarthestSeries = 20;
inline constexpr double kFineOfNoise = 1e-3;  // precision of the lowest value, relative to the noise
inline constexpr double kFineOfTerms = 0.1;   // and relative to the last terms

// Splines. Exponents of ten of the weight on smoothness, in units in which the points are 1 apart: from a
// spline through all points, to within rounding, to a polynomial.
inline constexpr double kLightestSmoothing = -10;
inline constexpr double kHeaviestSmoothing = 16;

// Band matrices. Smaller numbers are replaced by 0: influences decay along a band, and subnormal numbers are
// slow.
inline constexpr double kBandNothing = 1e-250;

// Intervals. Distance beyond the ends of an interval of angles, relative to a radian plus the angle, within
// which an extreme of sine or cosine is counted as inside.
inline constexpr double kExtremeSlack = 1e-15;

}  // namespace higherpair
