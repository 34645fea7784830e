#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>

// The tolerances of this room. Lengths are shares of the mechanism's size, values shares of what they are
// compared with: of a result, of the largest value of a column, of the range of a variable.

namespace higherpair {

// Rows and events.

/// Share of the path between two rows: as near as this to the end is there.
inline constexpr double kAtRowEnd = 1e-9;
/// Of the distance of two rows: as near as this is on a row.
inline constexpr double kOnRow = 1e-9;
/// Of a place on the path: by halving.
inline constexpr double kPlaceOnPath = 1e-15;
/// Of the span of all rows: a row as near to a place is there.
inline constexpr double kAtPlace = 1e-9;
/// Positions of a driver that are one, of itself and of 1 in its unit.
inline constexpr double kSamePosition = 1e-9;
/// Arcs that a contact has run along its curves up to a row, and that are alike, of the size.
inline constexpr double kSameRowArc = 1e-9;
/// Travel of a driver that slides, in sizes of the mechanism: farther away positions are rounded by more than
/// the default tolerance, and a path is followed in steps of a sixth of the size.
inline constexpr double kLongestDriverSlide = 1e7;
/// The same of a driver that turns, in turns: a path is followed in steps of 10 degrees.
inline constexpr double kMostDriverTurns = 1e7;
/// Least tolerance of a DyadChain.
inline constexpr double kLeastChainTolerance = 1e-9;
/// Length of a direction that is given as a unit vector, less 1.
inline constexpr double kUnitDirection = 1e-9;

// Results of a path.

/// Of what lengths and the drivers' speed make of a column's dimension: smaller values are rounding.
inline constexpr double kResultRounding = 1e-12;
/// Of the spread of a column: extremes that differ by less are equal.
inline constexpr double kSameResult = 1e-9;
/// Of the whole path: so far to either side of an extreme the column is looked at, and by so much of its
/// spread it may be lower there if it is smooth.
inline constexpr double kBesideExtreme = 1e-5;
inline constexpr double kSmoothFall = 3e-7;
/// Of a value: what scaling may make of two neighbours, generously.
inline constexpr double kScalingRounding = 1e-15;

// Checks.

/// A value that differs from its limit by less is at it.
inline constexpr double kAtCheckLimit = 1e-9;
/// Of a value on the path: equal but for rounding.
inline constexpr double kSamePathValue = 1e-9;
/// Of a size of a flank: rounding.
inline constexpr double kNoFlankSize = 1e-9;
/// Breaks of a flank's path that are one, of the path.
inline constexpr double kSameBreak = 1e-12;
/// Of the curvature 1/size: straight but for rounding.
inline constexpr double kStraightContact = 1e-9;
/// Of the speed along a contact: rounding.
inline constexpr double kRestingContact = 1e-9;
/// Of the largest entrainment speed: 0 but for rounding.
inline constexpr double kNoEntrainment = 1e-9;

// Extremes of rounding are not looked for: they lie at places without meaning, thousands of steps away.
inline constexpr double kNoAngle = 1e-13;          // [rad]
inline constexpr double kNoCurvature = 1e-13;      // of the curvature 1/size
inline constexpr double kSlidingRounding = 1e-13;  // of what the drivers' speed makes of the size
inline constexpr double kTravelRounding = 1e-12;   // the same of accelerations
inline constexpr double kRoundingOfJerk = 1e-11;   // and of jerks

// Mobility in words.

/// Offset of a slider-crank that is central, of its links together.
inline constexpr double kCentralOffset = 1e-12;
/// What a crank that turns fully has to spare, of the coupler: none at a change point.
inline constexpr double kChangePointSlack = 1e-12;
/// Numbers of the text that are none but for rounding.
inline constexpr double kNoNumber = 1e-12;

// Pictures and reports.

/// Of columns: what is small against it is rounding.
inline constexpr double kReportNoise = 1e-9;
// Precisions of what a report draws.
inline constexpr double kPlaceStep = 1e-8;  // of the picture: places of bodies
inline constexpr double kAngleStep = 1e-8;  // [rad]
inline constexpr double kShapeStep = 1e-6;  // of the picture: what is drawn in one row alone
// Of the picture, and [rad]: first and last row show one picture.
inline constexpr double kSamePicture = 1e-6;
inline constexpr double kPowerOfTen = 1e-9;  // of an exponent: that of a step that is a power of ten
/// Of the longest arrow: a polygon none of whose arrows leads farther across it is a line.
inline constexpr double kFlatPolygon = 1e-6;
/// Positions of a driver with one mark in a plot, in SI units.
inline constexpr double kSameMark = 1e-6;
/// Of a step: scenes of `every` up to the end of the path.
inline constexpr double kLastScene = 1e-12;
/// Of a lap: places of a run on a map that is drawn again and again.
inline constexpr double kWholeLap = 1e-9;
/// Overlap of a contact that counts as free on a map, of the size.
inline constexpr double kMapOverlap = 1e-9;

// Derivatives by numbers of a profile.

/// Steps of differences, of the scale of the number.
inline constexpr double kDifferenceStep = 2e-4;
/// Change of a number of the mechanism over all steps, of the mechanism's largest: less is rounding.
inline constexpr double kNoNumberChange = 1e-14;
/// Change of a result by a change of a number over its whole scale, of the largest value of its column: less
/// is rounding; and of the rounding of a column that is the same everywhere.
inline constexpr double kNoSlope = 1e-10;
inline constexpr double kNoSlopeOfRounding = 100;
/// Slopes at places where a column is equally large that differ by less are equal, of the larger one.
inline constexpr double kSameSlope = 1e-7;
/// Of the result: a bend of less is no kink.
inline constexpr double kKinkRounding = 1e-8;
/// Of the bend with two steps: with one step as much is a kink.
inline constexpr double kKinkOfDifference = 0.75;
/// Of the slope: less is no kink.
inline constexpr double kKinkOfSlope = 1e-3;

// Bands of tolerances, of the variance and of the value: rounding.
inline constexpr double kVarianceRounding = 1e-14;
inline constexpr double kBandSlack = 1e-12;

// Design.

/// Of the range of a variable: at its bound.
inline constexpr double kAtBound = 1e-6;
/// Of a limit: what rounding may take from it.
inline constexpr double kHoldsLimit = 1e-9;
/// What dyads are to have to spare: on the very edge of their reach rounding loses the motion.
inline constexpr double kSpareReach = 1e-7;
/// Bodies that are no farther apart have the same pose.
inline constexpr double kSamePose = 1e-6;
/// Of the largest number: what rounding leaves of a linear function.
inline constexpr double kLinearRounding = 1e-13;
/// Displacement for slopes of what a linkage has to spare to Grashof's condition.
inline constexpr double kGrashofStep = 1e-6;
/// Of a range: how far from the start things are tried.
inline constexpr std::array kIdleShares = {1e-3, 0.02};
/// Times what the profile has, or a part of it: a target that may be a slip.
inline constexpr double kTargetApart = 20;
/// The same: where it is in the unit that is meant.
inline constexpr double kTargetAsMuch = 3;

// Of a driver, between two places where the reach of dyads is looked at: a pin's angle [rad], or of the size.
inline constexpr double kGapStep = kPi / 30;
inline constexpr double kGapSlide = 0.05;
inline constexpr double kWholeGapSteps = 1e-9;  // a count of them that is whole
inline constexpr double kEvenStep = 1e-6;       // of a step: steps that are even

/// Of the distance between rows: a step as small as this ends Newton's method.
inline constexpr double kSharpestStep = 1e-13;
/// Of the way round: ends of a path that are no farther apart are one point.
inline constexpr double kClosedPath = 1e-6;
/// Of the path: a change of its placement as small as this ends it.
inline constexpr double kSettledPlacement = 1e-13;
/// Scale of a placement: a path that is placed smaller has become a point.
inline constexpr double kLeastPathScale = 1e-9;

// Fits to a measured motion.

/// Of the largest value of a column: what no noise is smaller than.
inline constexpr double kNoiseRounding = 1e-13;
/// Noise and weights that change by less.
inline constexpr double kNoiseSettled = 1e-6;
/// Of the most that a variable changes, each by its own scale: nothing.
inline constexpr double kNoFitChange = 1e-12;
/// Of the largest value of a column: a spread that is none, and the least robust deviation.
inline constexpr double kNoSpread = 1e-12;
/// The same of residuals that are noise, and not what rounding leaves of exact values.
inline constexpr double kNoisyColumn = 1e-9;
/// Rounding of a value, of the largest of its column.
inline constexpr double kValueNoise = 1e-15;
/// Of a range: ends of two searches are one.
inline constexpr double kSameFitEnd = 1e-4;
/// Of a sum: a better end of a search.
inline constexpr double kBetterSum = 1e-9;
/// Of a column's largest value: the new profile moves as was fitted.
inline constexpr double kSameMotion = 1e-9;
/// Of a variable's scale, for differences of the fourth order.
inline constexpr double kFourthOrderStep = 1e-3;
/// Of a driver's position [rad], and of what moves it by as much.
inline constexpr double kOffsetStep = 1e-3;
/// Of the largest: derivatives by two ways that agree; and where all are 0.
inline constexpr double kDerivativesAgree = 1e-5;
inline constexpr double kNoDerivative = 1e-12;
/// Of the largest singular value: columns scaled to length 1.
inline constexpr double kFitRank = 1e-8;
/// Of a direction: an unknown with a smaller part has none.
inline constexpr double kPartOfDirection = 1e-5;
/// Changes that are alike.
inline constexpr double kAlikeChanges = 1e-4;
/// Two unknowns that can hardly be told from each other.
inline constexpr double kCloseCorrelation = 0.99;
/// Misfit, as a share of the values' own size, that is no matter of dimensions, and one that may be.
inline constexpr double kFarMisfit = 0.5;
inline constexpr double kNearMisfit = 0.25;
/// Of the misfit as it is.
inline constexpr double kBetterMisfit = 0.2;

}  // namespace higherpair
