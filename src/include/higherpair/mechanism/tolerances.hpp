#pragma once

// Tolerances of mechanisms. Lengths are relative to the mechanism's size, angles are in radians.

namespace higherpair {

// The plan of a mechanism.

/// Points closer than this fraction of their coordinates coincide: rounding of the coordinates alone, 1e-16
/// of them, would exceed the default tolerance of 1e-9 of the distance.
inline constexpr double kCoincident = 1e-7;
/// Least size of a mechanism [m], a hundredth of an atom: anything smaller is rounding.
inline constexpr double kLeastSize = 1e-12;
/// Relative to how far a sliding driver goes: a mechanism of smaller size would take as many steps to go that
/// far as this is small.
inline constexpr double kLeastOfTravel = 1e-4;
/// Two points of a body are the same if they differ by no more than this fraction of their coordinates.
inline constexpr double kSameBodyPoint = 1e-12;
/// With larger ratios a whole turn of one wheel is within the rounding of the other's angle.
inline constexpr double kLargestGearRatio = 1e9;
inline constexpr const char* kGearRatioRule = "must be between 1e-9 and 1e9";
/// How far lines and open conics are followed at least, relative to the size of the mechanism.
inline constexpr double kReachOfOpenCurves = 10;

/// Rounding of an interpolated sine, relative to its lever: for dyads, touching bodies, coupled bodies.
inline constexpr double kDyadNoise = 1e-14;
inline constexpr double kTouchNoise = 1e-12;
inline constexpr double kCoupledNoise = 1e-11;

// Assembly.

/// Largest closure error, unless another one is asked for.
inline constexpr double kDefaultClosure = 1e-9;

// Assembly by iteration over all bodies at once.

/// Largest closure error.
inline constexpr double kClosedMechanism = 1e-10;
/// Steps up to this count as zero.
inline constexpr double kLeastFreeStep = 1e-14;
/// Precision of the common normals, of bodies that need not touch yet, from which iterations start.
inline constexpr double kRoughNormal = 1e-6;

// Mobility.

/// Conditions that repeat others: pivots of the derivatives of all conditions below this fraction of the
/// largest count as 0.
inline constexpr double kRepeatedConditions = 1e-10;
/// Singular values below this fraction of the largest (or of 1, that of a row) count as 0. Positions are
/// closed to about 1e-14 of the size, and a position within 1e-8 of a singular one is treated as singular
/// everywhere here.
inline constexpr double kRankFloor = 1e-8;
/// Trial move of an angle, or relative to the size, that shows whether a direction is a real freedom.
inline constexpr double kFreeMove = 0.03;
/// Moves that come back closer to the start than this fraction of the step have not moved.
inline constexpr double kLeadsAway = 0.1;
/// Components of a unit vector of a null space below this do not move.
inline constexpr double kMoves = 1e-6;
/// The same where directions are known from trial moves only.
inline constexpr double kMovesShaky = 0.05;
/// Residual of the drivers' rates, relative to them, beyond which a driver is at a dead point.
inline constexpr double kDriversMove = 1e-6;
/// Entries of the projector on the left null space (at most 1) below this count as 0: the condition is not
/// involved.
inline constexpr double kInvolved = 1e-6;
/// Difference of two links that count as equal and parallel.
inline constexpr double kParallelLinks = 1e-7;
/// Distance of a centre or pin from the point about which a body may turn idly, below which it coincides.
inline constexpr double kRoundAbout = 1e-7;
/// A contact hardly sets the angle of a body whose curve is round about a point this close to its pin,
/// relative to the size of the mechanism: the angle would change a thousand times as much as the place of
/// what touches.
inline constexpr double kNearlyRound = 1e-3;

}  // namespace higherpair
