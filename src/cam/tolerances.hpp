#pragma once

#include <limits>

// The tolerances of this room. Those of motion laws are relative to the values or derivatives that are
// compared, those of cams to their size.

namespace higherpair {

// Motion laws.

/// A change of a derivative at a join that is smaller, relative to its largest size in the law, is rounding.
inline constexpr double kNoLawJump = 1e-9;
/// Where the last repetition ends higher by less than this, relative to the largest value, it is rounding.
inline constexpr double kNoAdvance = 1e-14;
/// Derivatives below this, relative to their largest size, are rounding.
inline constexpr double kLawNoise = 1e-13;
/// Values that ought to be the same may differ by the rounding of sums, relative to the largest of them.
inline constexpr double kSameLawValue = 1e-9;
/// What rounding adds to bounds, relative to the numbers that they are made of.
inline constexpr double kLawBoundsRounding = 16 * std::numeric_limits<double>::epsilon();
/// What a law is near a join: within so many units in the last place.
inline constexpr double kAtJoin = 8 * std::numeric_limits<double>::epsilon();
/// Of the law: where a jump lies is known to that.
inline constexpr double kJumpWidth = 1e-13;
/// Of the piece: shorter intervals are a place.
inline constexpr double kShortestLawInterval = 0x1p-40;

// Flanks.

/// Of a turn: a law that is longer goes more than once round.
inline constexpr double kTurnRounding = 1e-14;
/// Of the size: a motion against the cam that is none.
inline constexpr double kNoMotionOnCam = 1e-12;
/// A law that goes round exactly once [rad].
inline constexpr double kOnceRound = 1e-12;

// Envelopes.

/// Last step to an angle of the normal [rad].
inline constexpr double kEnvelopeSettled = 1e-14;
/// Of a speed or an angle.
inline constexpr double kEnvelopeRounding = 1e-13;
/// Of a coordinate: a law is not looked at as near to a join, where derivatives of the next piece count too.
inline constexpr double kBesideJoin = 64 * std::numeric_limits<double>::epsilon();

// Sizes and cutters.

/// Relative change of a size that is none.
inline constexpr double kSameCamSize = 4e-16;
/// Of the radius: where a cutter begins to undercut.
inline constexpr double kBisectedRadius = 1e-9;
/// Of the size: an offset's ends meet as exactly as those of the flank.
inline constexpr double kOffsetMeets = 1e-3;
/// Of the limit: a hollow arc of the cutter's own radius.
inline constexpr double kSameCutterRadius = 1e-9;
/// Of the limit: where a path still has no cusp.
inline constexpr double kJustBelowCutter = 1e-6;

}  // namespace higherpair
