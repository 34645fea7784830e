#pragma once

#include "higherpair/geometry/pose.hpp"

// Tolerances of the input and output code: how far numbers that should be equal may differ through rounding
// and a limited number of written digits, and above which size a possible mistake is worth a note.

namespace higherpair {

// Curves.

/// Relative to the curve's size: ends that are no farther apart count as meeting, unless the table gives a
/// `tolerance`.
inline constexpr double kDefaultGap = 1e-5;
/// Relative to the mechanism's size: ends of neighbouring spans of a flank that are no farther apart count as
/// meeting.
inline constexpr double kFlankMeets = 1e-9;
/// Share of a turn beyond which a law that does not close its flank was probably meant to.
inline constexpr double kNearlyATurn = 0.75;
/// Relative to the size of a curve: gap up to which the ends of its offset count as meeting. It may be
/// generous, for they meet as exactly as those of the curve itself.
inline constexpr double kOffsetGap = 1e-3;
/// Smallest sweep of an arc, and how close to a whole turn a sweep counts as one [rad].
inline constexpr double kSweepRounding = 1e-12;
/// A corner of less than this is probably meant to be a smooth joint of rounded coordinates [rad].
inline constexpr double kSlightTurn = 0.02;
/// Relative to the curve's own curvature: curvature noise from rounded coordinates that is worth a note.
inline constexpr double kCurvatureWorthANote = 0.05;
/// Relative to the distance of a point from the origin: a coordinate below it is 0 to within rounding.
inline constexpr double kNoCoordinate = 1e-12;

// Drawings.

/// Components of an extrusion direction in the plane of the drawing count as 0 up to this.
inline constexpr double kPlanarDrawing = 1e-9;
/// Drawings whose numbers have so many decimals are taken to be rounded.
inline constexpr int kLeastRoundedDecimals = 3;
inline constexpr int kMostRoundedDecimals = 12;
/// Gap between ends that meet: in steps of their last decimal, and at most relative to the drawing's size.
inline constexpr double kGapInSteps = 3;
inline constexpr double kLargestRoundingGap = 1e-3;
/// Relative to the drawing's size: ends of two contours that are no farther apart are probably meant to meet.
inline constexpr double kNearEnds = 0.01;
/// Sweeps of an ellipse count as a whole turn if they are this close to one, or to 0: files give parameters
/// with a limited number of digits [rad].
inline constexpr double kWholeTurn = 1e-9;
/// Relative to the radius: arcs that meet and whose centres differ by less form one circle.
inline constexpr double kOneCircle = 1e-12;

// Gears.

/// Relative to the sum of the distances of two points from the origin: closer points count as one.
inline constexpr double kSameGearPoint = 1e-12;
/// Relative: base pitches of two wheels that differ by more do not mesh.
inline constexpr double kSameBasePitch = 1e-3;
/// Relative to the base radius: base circles and centres that differ by less are the same.
inline constexpr double kSameBaseRadius = 1e-9;

// Laws and schedules.

/// Relative to a turn: segments or points whose span is this close to one turn fill it exactly. Leaves room
/// for degrees written as decimals of radians.
inline constexpr double kOneTurn = 1e-6;
/// Relative to the peak acceleration: noise below this is not worth a note.
inline constexpr double kNoiseWorthSaying = 0.01;
/// Most repetitions of a law in a run: each takes several steps, and some are looked through at once.
inline constexpr double kMostRepetitions = 1e6;
/// How far a number may be from a whole one and count as whole, relative to the larger of itself and 1.
inline constexpr double kWholeNumber = 1e-9;
/// Relative to the step: steps of a driver from row to row that differ by less are equal.
inline constexpr double kSameStep = 1e-9;
/// Relative to the duration: times that are closer to each other count as one.
inline constexpr double kSameTime = 1e-12;
/// In time steps: a smaller remainder of the duration is due to rounding of the two numbers.
inline constexpr double kNoRemainder = 1e-9;
/// Relative to the range of a law's values: a value beyond the range by less is at its end.
inline constexpr double kBeyondLaw = 1e-12;

// Designs and sweeps.

/// As a fraction of a step: multiples of the step this close to a bound lie on it.
inline constexpr double kOnVariableStep = 1e-9;

// Notes.

/// Relative: a gravity whose number is this close to that of the earth in some unit (9.8 or 10, say) is meant
/// to be the earth's ...
inline constexpr double kEarthsNumber = 0.02;
/// ... and its unit is a mistake unless the value that it gives is this close to the earth's.
inline constexpr double kEarthsGravity = 0.05;

/// Sizes of a mechanism beyond which its unit of length may be a mistake [m]: a drawing's millimetres read as
/// metres, or metres read as millimetres, where also the number is below 1.
inline constexpr double kLargeMechanism = 50;
inline constexpr double kSmallMechanism = 3e-4;
/// Error of a multiple of π/2, up to 6.28, that is written with two decimals.
inline constexpr double kRoundedPi = 4e-3;
/// A radius of gyration this many times larger or smaller than its body is probably a mistake of units.
inline constexpr double kGyrationOff = 100;
/// So is a centre of mass this many sizes of the mechanism from its body's origin.
inline constexpr double kFarCenterOfMass = 20;
/// Relative to the mechanism's size: a point that starts farther from its position in the poses is worth a
/// note.
inline constexpr double kFarFromPose = 2.0 / 3;
/// So is a body that starts turned from its pose by more than this: it points the other way [rad].
inline constexpr double kTurnedFromPose = 3 * kPi / 4;
/// Relative to the sum of the distances of a face and a curve from the origin: the curve is behind the face
/// only if it is farther behind it than this.
inline constexpr double kBehindFace = 1e-9;
/// Relative to the mechanism's size: points of two joints that are no farther apart are the same; and the
/// sine of the angle between two directions that are.
inline constexpr double kSamePoint = 1e-9;
/// Relative allowances for rounding errors: of a number that is rounded up to its last digit, and of half a
/// unit of its last digit.
inline constexpr double kLastDigitUp = 1e-12;
inline constexpr double kHalfDigit = 1e-9;

}  // namespace higherpair
