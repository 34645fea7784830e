#pragma once

#include "higherpair/geometry/pose.hpp"

// The tolerances of this room: forces are shares of the largest they are compared with, places shares of the
// path or of a piece of it.

namespace higherpair {

// Statics and inverse dynamics.

/// Share of a multiplier that other solutions may differ by.
inline constexpr double kDetermined = 1e-9;
/// What may be left of the wrenches, of the largest.
inline constexpr double kBalancedWrenches = 1e-8;
/// Multipliers are balances of forces that may be much larger: below this share of the largest they, and
/// pulling forces, are rounding.
inline constexpr double kMultiplierRounding = 1e-11;
/// Of the largest number of a tableau's row, or of a condition, in the search for the least sum of forces.
inline constexpr double kTableauNothing = 1e-13;

// Forces as series over pieces of the path.

/// Longest piece: of a turning driver [rad], of a sliding one relative to the size. Forces of ordinary cams
/// are resolved on pieces between one and a quarter of this.
inline constexpr double kLongestPieceTurn = kPi / 6;
inline constexpr double kLongestPieceSlide = 0.25;
/// Shortest piece, relative to the longest; next to a pole or a root of the driver no piece converges.
inline constexpr double kShortestForcePiece = 0x1p-16;
/// Events nearer to the end of a piece, relative to the longest, are at the end.
inline constexpr double kAtPieceEnd = 1e-9;
/// A series has converged when its last coefficients are below this, relative to the largest multiplier.
inline constexpr double kSeriesConverged = 1e-13;
/// Near crossings of branches rates have fewer digits: a series whose last coefficients are below this and do
/// not fall by kSeriesFall when the piece is halved shows their rounding.
inline constexpr double kRoughSeries = 1e-8;
inline constexpr double kSeriesFall = 8;
/// Forces are resolved relative to the largest in their piece, but no smaller than kForceFloor of what they
/// are on all but the worst tenth of the path, which may be next to a pole.
inline constexpr double kUsualShare = 0.9;
inline constexpr double kForceFloor = 0.1;

// Contacts that open.

/// A force that has grown by this up to where it changes sign without a zero has a pole there.
inline constexpr double kGrownForce = 1e3;
/// A force at the end of a piece that is one, of the largest in the next: it jumps.
inline constexpr double kJumpOfForce = 1e-6;
/// Of half a piece: the first step back from where a force is below zero, in search of the zero.
inline constexpr double kStepToZero = 1e-13;
/// Of half a piece: a step of Newton's method towards a zero that is near.
inline constexpr double kNearZero = 1e-6;
/// Of the sum of a force's parts.
inline constexpr double kSumRounding = 1e-12;
/// The same: precision of the lowest force.
inline constexpr double kLowestForce = 1e-15;

// Extremes along a path.

/// Between two samples: of a turning driver [rad], of a sliding one relative to the size.
inline constexpr double kLongestSampleTurn = kPi / 360;
inline constexpr double kLongestSampleSlide = 1.0 / 360;
/// Of a stretch: so far from its ends are its outer samples.
inline constexpr double kInsideStretch = 1e-6;
/// Of the way between two samples: nearer to a singular position is none.
inline constexpr double kApartFromSingular = 0.25;
/// Of the path: where a jump lies is known to that.
inline constexpr double kJumpPlace = 1e-12;
/// Of the largest value of a quantity.
inline constexpr double kValueRounding = 1e-11;

}  // namespace higherpair
