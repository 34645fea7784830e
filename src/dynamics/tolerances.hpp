#pragma once

#include "higherpair/geometry/pose.hpp"

// The tolerances of the dynamics. Forces are relative to the largest that they are compared with, positions
// to the path or a piece of it.

namespace higherpair {

// Statics and inverse dynamics.

/// Largest fraction of a multiplier that other solutions may differ by if it counts as determined.
inline constexpr double kDetermined = 1e-9;
/// Largest residual of the balance of wrenches, as a fraction of the largest wrench.
inline constexpr double kBalancedWrenches = 1e-8;
/// Multipliers are differences of forces that may be much larger: below this fraction of the largest they,
/// and pulling forces, are rounding.
inline constexpr double kMultiplierRounding = 1e-11;
/// Moment about its pin that an idle body may be left with, relative to the largest force on it times the
/// size: above kRoundAbout, by which its curves may be off the pin.
inline constexpr double kHeldByRounding = 1e-6;
/// In the search for the least sum of forces, numbers below this, relative to the largest in a row of the
/// tableau or in a condition, count as zero.
inline constexpr double kTableauNothing = 1e-13;

// Forces as series over pieces of the path.

/// Longest piece, for a turning driver [rad] and for a sliding one relative to the size. Forces of ordinary
/// cams are resolved on pieces between one and a quarter of this length.
inline constexpr double kLongestPieceTurn = kPi / 6;
inline constexpr double kLongestPieceSlide = 0.25;
/// Shortest piece, relative to the longest; next to a pole, or where forces behave like a root of the
/// driver's coordinate, no piece converges.
inline constexpr double kShortestForcePiece = 0x1p-16;
/// Events nearer than this to the end of a piece, relative to the longest piece, are at its end.
inline constexpr double kAtPieceEnd = 1e-9;
/// A series has converged when its last coefficients are below this, relative to the largest multiplier.
inline constexpr double kSeriesConverged = 1e-13;
/// Near crossings of branches rates have fewer digits: a series whose last coefficients are below
/// kRoughSeries, and do not fall by kSeriesFall when the piece is halved, is accepted, as they are rounding.
inline constexpr double kRoughSeries = 1e-8;
inline constexpr double kSeriesFall = 8;
/// Forces are resolved relative to the largest in their piece, but no finer than relative to kForceFloor
/// times what they are on all but the worst tenth of the path, which may be next to a pole.
inline constexpr double kUsualShare = 0.9;
inline constexpr double kForceFloor = 0.1;

// Contacts that open.

/// A force that grows by this factor up to where its sign changes without a zero has a pole there.
inline constexpr double kGrownForce = 1e3;
/// A force at the end of a piece above this fraction of the largest in the next piece is not zero: if the
/// sign changes there, it jumps.
inline constexpr double kJumpOfForce = 1e-6;
/// First step back from where a force is below zero, in search of the zero, as a fraction of half a piece.
inline constexpr double kStepToZero = 1e-13;
/// Largest step of Newton's method towards a nearby zero, as a fraction of half a piece.
inline constexpr double kNearZero = 1e-6;
/// Rounding of a force, as a fraction of the sum of its parts' magnitudes.
inline constexpr double kSumRounding = 1e-12;
/// Precision of the lowest force, relative to the same.
inline constexpr double kLowestForce = 1e-15;

// Extremes along a path.

/// Largest distance between two samples, for a turning driver [rad] and for a sliding one relative to the
/// size.
inline constexpr double kLongestSampleTurn = kPi / 360;
inline constexpr double kLongestSampleSlide = 1.0 / 360;
/// In steps: what is left of a stretch and longer than a step by less is one step.
inline constexpr double kRoomInStep = 1e-6;
/// Distance of a stretch's outer samples from its ends, as a fraction of the stretch.
inline constexpr double kInsideStretch = 1e-6;
/// Samples nearer to a singular position than this fraction of the spacing are left out.
inline constexpr double kApartFromSingular = 0.25;
/// A quantity that rises by less than this fraction of its largest value where the distance from a singular
/// position is halved does not grow towards it: there rates lose several digits.
inline constexpr double kLeastGrowth = 1e-6;
/// Accuracy to which a jump is located, as a fraction of the path.
inline constexpr double kJumpPlace = 1e-12;
/// Rounding of a quantity, as a fraction of its largest value.
inline constexpr double kValueRounding = 1e-11;

}  // namespace higherpair
