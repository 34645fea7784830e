#pragma once

// The tolerances of this room. Lengths are shares of the mechanism's size, angles are in radians.

namespace higherpair {

// The plan of a mechanism.

/// Points coincide that are nearer to each other than this fraction of their coordinates: the rounding of the
/// coordinates alone, 1e-16 of them, would be more than the default tolerance, 1e-9 of the distance.
inline constexpr double kCoincident = 1e-7;
/// The size itself [m], a hundredth of an atom: what is smaller is rounding.
inline constexpr double kLeastSize = 1e-12;
/// Points of a body that are one, of their coordinates.
inline constexpr double kSameBodyPoint = 1e-12;
/// How far lines and open conics are followed, of the size of the mechanism.
inline constexpr double kReachOfOpenCurves = 10;

/// Rounding of an interpolated sine, relative to its lever: of dyads, of bodies that touch, of coupled
/// bodies.
inline constexpr double kDyadNoise = 1e-14;
inline constexpr double kTouchNoise = 1e-12;
inline constexpr double kCoupledNoise = 1e-11;

// Assembly.

/// Largest closure error, where no other is asked for.
inline constexpr double kDefaultClosure = 1e-9;

// Assembly without an order of the bodies.

/// Largest closure error.
inline constexpr double kClosedMechanism = 1e-10;
/// A step that is none.
inline constexpr double kLeastFreeStep = 1e-14;
/// The common normal of bodies that need not touch yet, from which the iteration starts.
inline constexpr double kRoughNormal = 1e-6;

// Mobility.

/// Pivots of the derivatives of all conditions below this share of the largest count as 0: conditions that
/// repeat others.
inline constexpr double kRepeatedConditions = 1e-10;
/// Singular values below `kRankFloor` of the largest (or of 1, that of a row) count as zero: positions are
/// closed to 1e-14 of the size or so, and at 1e-8 from a singular position one is at it for every purpose
/// here.
inline constexpr double kRankFloor = 1e-8;
/// A move of an angle, or of the size, that shows whether a direction is free.
inline constexpr double kFreeMove = 0.03;
/// Of that step: what comes back closer than that has not moved.
inline constexpr double kLeadsAway = 0.1;
/// Of a unit vector of a null space: what is less does not move.
inline constexpr double kMoves = 1e-6;
/// The same where directions are known from moves only.
inline constexpr double kMovesShaky = 0.05;
/// What is left of the drivers' rates at a dead point is more.
inline constexpr double kDriversMove = 1e-6;
/// Entries of the projector on the left null space, at most 1.
inline constexpr double kInvolved = 1e-6;
/// Links that are equal and parallel.
inline constexpr double kParallelLinks = 1e-7;
/// Distance of a centre, or of a pin, from the point about which a body may turn idly.
inline constexpr double kRoundAbout = 1e-7;

}  // namespace higherpair
