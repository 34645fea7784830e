#pragma once

#include <limits>

// Tolerances of cams. Those of motion laws are relative to the values or derivatives that are compared, those
// of cams to their size.

namespace higherpair {

// Motion laws.

/// A smaller change of a derivative at a join, relative to its largest size in the law, is rounding.
inline constexpr double kNoLawJump = 1e-9;
/// A smaller advance of one repetition over the one before, relative to the largest value, is rounding.
inline constexpr double kNoAdvance = 1e-14;
/// Derivatives below this, relative to their largest size, are rounding.
inline constexpr double kLawNoise = 1e-13;
/// Values that should be equal may differ by the rounding of sums, relative to the largest of them.
inline constexpr double kSameLawValue = 1e-9;
/// Rounding of bounds, relative to the numbers that they are computed from.
inline constexpr double kLawBoundsRounding = 16 * std::numeric_limits<double>::epsilon();
/// A coordinate this close to a join, relative to it, is at the join.
inline constexpr double kAtJoin = 8 * std::numeric_limits<double>::epsilon();
/// Precision of the position of a jump, as a fraction of the law's length.
inline constexpr double kJumpWidth = 1e-13;
/// Shorter intervals, as a fraction of the piece, are a single place.
inline constexpr double kShortestLawInterval = 0x1p-40;

// Flanks.

/// Excess over a whole turn, as a fraction of it, that is rounding: a longer law exceeds one turn.
inline constexpr double kTurnRounding = 1e-14;
/// Smaller motions relative to the cam, as a fraction of the size, count as none.
inline constexpr double kNoMotionOnCam = 1e-12;
/// Deviation from exactly one turn that is rounding [rad].
inline constexpr double kOnceRound = 1e-12;

// Envelopes.

/// Last step of the angle of the normal [rad].
inline constexpr double kEnvelopeSettled = 1e-14;
/// Rounding of a speed or an angle, relative to it.
inline constexpr double kEnvelopeRounding = 1e-13;
/// Distance from a join, relative to the coordinate, within which a law is not evaluated, because derivatives
/// of the next piece would count as well.
inline constexpr double kBesideJoin = 64 * std::numeric_limits<double>::epsilon();

// Sizes and cutters.

/// Most places that a search for the smallest size takes up one by one.
inline constexpr int kMostSizeExchanges = 60;
/// Trials of sizes: the largest cam is about 2⁷ times the first, the smallest follower 2⁻¹² times.
inline constexpr int kMostSizeTrials = 12;
/// Longest step of the search for the size at which a condition holds, relative to the first: beyond it none
/// is expected.
inline constexpr double kLargestSizeStep = 1e12;
/// Distance beyond the limit of a size, relative to it, at which a flank certainly has no cusp.
inline constexpr double kJustBeyondSize = 1e-6;
/// Precision of a size that is found by trial, relative to it.
inline constexpr double kTriedSize = 1e-3;
/// Smaller relative changes of a size count as none.
inline constexpr double kSameCamSize = 4e-16;
/// Precision of the radius at which a cutter begins to undercut, relative to the radius.
inline constexpr double kBisectedRadius = 1e-9;
/// Largest gap between spans of an offset, relative to the size; the offset's ends meet as exactly as the
/// flank's.
inline constexpr double kOffsetMeets = 1e-3;
/// Tolerance, relative to the limit, for a cutter with the radius of a concave arc.
inline constexpr double kSameCutterRadius = 1e-9;
/// Distance below the limit, relative to it, at which a path certainly has no cusp.
inline constexpr double kJustBelowCutter = 1e-6;

}  // namespace higherpair
