#pragma once

// The tolerances of this room: what rounding, and the digits that people and programs write, make of numbers
// that ought to be equal, and from where on a note is worth its line.

namespace higherpair {

// Curves.

/// Ends that are no farther apart meet, unless the table has a `tolerance`; of the curve's size.
inline constexpr double kDefaultGap = 1e-5;
/// Of the size of a flank: where it closes to within rounding.
inline constexpr double kFlankMeets = 1e-9;
/// Of the size of a curve: the ends of its offset meet as exactly as its own.
inline constexpr double kOffsetGap = 1e-3;
/// Sweep of an arc that is none, or a whole turn [rad].
inline constexpr double kSweepRounding = 1e-12;
/// Below it a corner is rather a smooth joint of rounded numbers [rad].
inline constexpr double kSlightTurn = 0.02;
/// Of a curve's own curvature: an error of it by rounded coordinates that is worth a note.
inline constexpr double kCurvatureWorthANote = 0.05;
/// Of a point: a coordinate that is 0 but for rounding.
inline constexpr double kNoCoordinate = 1e-12;

// Drawings.

/// A direction across the plane of the drawing that is rounding.
inline constexpr double kPlanarDrawing = 1e-9;
/// Of a turn: parameters are written with some digits.
inline constexpr double kWholeTurn = 1e-9;
/// Of the radius: arcs that are one circle.
inline constexpr double kOneCircle = 1e-12;

// Gears.

/// Beyond, a turn of one wheel is within the rounding of the other's.
inline constexpr double kLargestGearRatio = 1e9;
/// Points that are one, of their coordinates.
inline constexpr double kSameGearPoint = 1e-12;
/// Of the base radius.
inline constexpr double kSameBaseRadius = 1e-9;

// Laws and schedules.

/// Segments that miss one turn by less than this, relative to a turn, are one: degrees as decimals of
/// radians.
inline constexpr double kOneTurn = 1e-6;
/// Noise below this share of the peak acceleration is not worth a note.
inline constexpr double kNoiseWorthSaying = 0.01;
/// A number, scaled by a power of ten, that is whole, of itself and of 1.
inline constexpr double kWholeNumber = 1e-9;
/// Places nearer to each other than this, relative to the duration or the time between rows, are one.
inline constexpr double kSameTime = 1e-12;
/// A remainder of the duration that is smaller, in time steps, is the rounding of the two numbers.
inline constexpr double kNoRemainder = 1e-9;
/// Of the range of a law: a value beyond it by rounding.
inline constexpr double kBeyondLaw = 1e-12;

// Designs and sweeps.

/// Of a step: multiples of it that lie on a bound.
inline constexpr double kOnVariableStep = 1e-9;
/// Of a truncated normal distribution: less is rounding.
inline constexpr double kLeastShareWithin = 1e-9;

// Notes.

/// What a quarter turn in radians loses by two decimals, up to 6.28.
inline constexpr double kRoundedPi = 4e-3;
/// Times the extent of a body, or a part of it: a radius of gyration that may be a slip.
inline constexpr double kGyrationOff = 100;
/// Of the mechanism's size, of a point from its place in the poses.
inline constexpr double kFarFromPose = 2.0 / 3;
/// Of the distances of a face and of a curve from the origin: farther behind the face the curve is behind it.
inline constexpr double kBehindFace = 1e-9;
/// Rounding of what is rounded up to a last digit, and of half a unit of it.
inline constexpr double kLastDigitUp = 1e-12;
inline constexpr double kHalfDigit = 1e-9;

}  // namespace higherpair
