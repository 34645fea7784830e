#pragma once

// The tolerances of this room. Lengths are shares of the mechanism's size, steps of a path shares of a unit
// of its drivers (unit_of in step.hpp). Those of steps along a motion are beside the code that follows it.

namespace higherpair {

/// Assemblies as near as this are one [size, rad].
inline constexpr double kSameAssembly = 1e-12;

/// A depth below this is a touch: ten times the precision of the distances that are asked for.
inline constexpr double kOverlapDepth = 1e-9;
/// The same of boundaries, which are looked at in samples.
inline constexpr double kOverlapOfBoundaries = 1e-7;
inline constexpr double kOverlapPrecision = kOverlapDepth / 10;

/// The common normal of bodies that need not touch yet, from which an iteration starts.
inline constexpr double kRoughSeparation = 1e-6;

/// A contact as near as this to the end of a span has come there, of the boundary's size; on corners [rad].
inline constexpr double kAtSpanEnd = 1e-6;

/// A gap that is 0 to within rounding.
inline constexpr double kClosedGap = 1e-14;

/// A row as near as this to a limit is at the limit itself, of a unit of the drivers.
inline constexpr double kOnLimit = 1e-14;

/// How far a step may be from a smooth motion, as a share of the change in it; see Smoothness in step.cpp.
inline constexpr double kSmoothStep = 0.04;
/// A mismatch of a step that is nothing but rounding [rad, or of the size].
inline constexpr double kNoMismatch = 1e-9;

/// How far a follower may be guessed from its limit, of a unit of its coordinate.
inline constexpr double kNearFollowerLimit = 0.3;

/// Determinant, scaled, of a coupled group that has its rank for certain.
inline constexpr double kSurelyPlaced = 1e-9;

/// Velocities below this share of the step's largest are rounding, not a motion whose sense could change.
inline constexpr double kSlowestOutput = 1e-12;

}  // namespace higherpair
