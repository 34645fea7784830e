#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>

// Tolerances of this folder. Lengths are relative to the mechanism's size, values to what they are compared
// with: a result, the largest value of a column, the range of a variable.

namespace higherpair {

// Shapes.

/// A pin this close to the centre of a round curve is at it: the curve is a roller that turns about it.
inline constexpr double kPinAtCenter = 1e-9;

// Rows and events.

/// Fraction of the path between two rows: an event this close to its end is at the later row.
inline constexpr double kAtRowEnd = 1e-9;
/// Fraction of the row spacing: a place this close to a row is on it.
inline constexpr double kOnRow = 1e-9;
/// Relative width of the interval at which bisection for a place on the path ends.
inline constexpr double kPlaceOnPath = 1e-15;
/// Fraction of the span of all rows: a row this close to a place is at that place.
inline constexpr double kAtPlace = 1e-9;
/// Distances that a contact has travelled along its curves up to a row: those that differ by less are the
/// same, relative to the mechanism's size.
inline constexpr double kSameRowArc = 1e-9;
/// Longest travel of a sliding driver, in sizes of the mechanism: farther away, positions are rounded by more
/// than the default tolerance; and with steps of a sixth of the size the path would take too long.
inline constexpr double kLongestDriverSlide = 1e7;
/// The same for a turning driver, in turns, with steps of 10 degrees.
inline constexpr double kMostDriverTurns = 1e7;
/// Smallest tolerance of a run for which the fast DyadChain is used: its residuals stay below this.
inline constexpr double kLeastChainTolerance = 1e-9;
/// Largest deviation from 1 of the length of a unit vector.
inline constexpr double kUnitDirection = 1e-9;
/// Parts of a piece at whose ends a support function from outside is looked at.
inline constexpr int kSupportSamples = 16;
/// By how much its radius of curvature may miss its bounds through rounding, relative to its size.
inline constexpr double kSupportRounding = 1e-12;
/// Places in which a span is looked at, where in a part they are, the step of differences there, as a
/// fraction of the span's range ...
inline constexpr int kSpanSamples = 16;
inline constexpr double kSpanPlace = 0.43;
inline constexpr double kSpanStep = 1e-6;
/// ... the rounding of its values, relative to the farthest point for points, and how far differences and
/// rates may differ, relative to the largest rate.
inline constexpr double kSpanRounding = 1e-11;
inline constexpr double kSpanMismatch = 0.02;

// Results of a path.

/// Values of a column below this are rounding; relative to its scale, the value in its dimension that is made
/// of the mechanism's size and the drivers' speed.
inline constexpr double kResultRounding = 1e-12;
/// Fraction of the spread of a column: extremes that differ by less are equal.
inline constexpr double kSameResult = 1e-9;
/// Fraction of the largest value of a column: smaller changes from one row to the next are no jumps.
inline constexpr double kNoColumnJump = 1e-6;
/// A column jumps at an event if its change to the next row exceeds those before and after it by this factor;
/// the change to the next row alone tells nothing, as smooth columns may be steep.
inline constexpr double kStepOfJump = 4;
/// The same where the branch ends: that the motion is on another one beyond is known, and only whether this
/// column shows it is asked.
inline constexpr double kStepOntoBranch = 1.5;
/// An extreme is tested for a jump or kink at this fraction of the whole path to either side: a smooth column
/// falls there by at most kSmoothFall times its spread.
inline constexpr double kBesideExtreme = 1e-5;
inline constexpr double kSmoothFall = 3e-7;
/// The end of a stretch on which a column is constant, found by bisection, is moved inwards by this fraction
/// of the distance to the nearest sample: at the end itself rounding decides on which side a place is.
inline constexpr double kInsideEdge = 1e-6;
/// Values whose relative difference is below this may become equal when they are converted to other units.
inline constexpr double kScalingRounding = 1e-15;

// Checks.

/// A value within this fraction of its limit is at the limit.
inline constexpr double kAtCheckLimit = 1e-9;
/// Values on the path whose relative difference is below this are equal to within rounding.
inline constexpr double kSamePathValue = 1e-9;
/// Relative to the size of a flank: differences below count as zero.
inline constexpr double kNoFlankSize = 1e-9;
/// Fraction of the path: breaks of a flank's law closer together than this are the same.
inline constexpr double kSameBreak = 1e-12;
/// Curvatures below this, relative to 1/size, are those of straight lines.
inline constexpr double kStraightContact = 1e-9;
/// A relative velocity along the normal below this fraction of the speeds at a contact is rounding.
inline constexpr double kRestingContact = 1e-9;
/// Entrainment speeds below this fraction of the largest count as zero.
inline constexpr double kNoEntrainment = 1e-9;

// Columns whose values all stay below these are rounding, and their extremes are not searched for: the places
// of these would mean nothing, and finding them would take thousands of steps.
inline constexpr double kNoAngle = 1e-13;          // [rad]
inline constexpr double kNoCurvature = 1e-13;      // relative to the curvature 1/size
inline constexpr double kSlidingRounding = 1e-13;  // relative to the drivers' speed times the size
inline constexpr double kTravelRounding = 1e-12;   // the same for accelerations
inline constexpr double kRoundingOfJerk = 1e-11;   // and for jerks

// Mobility in words.

/// A slider-crank with a smaller offset is central; relative to the sum of its links.
inline constexpr double kCentralOffset = 1e-12;
/// The coupler of a slider-crank whose crank just turns fully, r3 = r2 + |offset|, to within this fraction of
/// the coupler: it does so through a change point only.
inline constexpr double kChangePointSlack = 1e-12;
/// Numbers below this are written as 0 in the text.
inline constexpr double kNoNumber = 1e-12;

// Pictures and reports.

/// Relative to the scale of a column: smaller values and changes are rounding.
inline constexpr double kColumnNoise = 1e-9;
// Rounding steps of what a report draws.
inline constexpr double kPlaceStep = 1e-8;  // of the picture's size: positions of bodies
inline constexpr double kAngleStep = 1e-8;  // [rad]
inline constexpr double kShapeStep = 1e-6;  // of the picture's size: shapes that are redrawn in each row
// The first and the last row show the same picture if positions [of the picture's size] and angles [rad]
// differ by less than this.
inline constexpr double kSamePicture = 1e-6;
inline constexpr double kPowerOfTen = 1e-9;  // rounding of the exponent of a step that is a power of ten
/// A polygon is a line if no arrow reaches farther sideways than this fraction of the longest one.
inline constexpr double kFlatPolygon = 1e-6;
/// Events whose driver positions differ by less than this, in SI units, share one mark in a plot.
inline constexpr double kSameMark = 1e-6;
/// Of scenes at equal distances (`every`) the last one may be beyond the end of the path by this fraction of
/// it: rounding.
inline constexpr double kLastScene = 1e-12;
/// A driver's position of at most this, of 1 rad or of the diagonal of the picture, is 0 in a caption:
/// rounding.
inline constexpr double kCaptionNoise = 1e-12;
/// A run is drawn over a map lap by lap; positions this far beyond the ends of a branch, as a fraction of a
/// lap, are on it.
inline constexpr double kWholeLap = 1e-9;
/// Overlap of a contact that counts as free on a map, relative to the size.
inline constexpr double kMapOverlap = 1e-9;

// Derivatives by numbers of a profile.

/// Step of finite differences, as a fraction of the number's scale.
inline constexpr double kDifferenceStep = 2e-4;
/// Differences of two orders agree if their relative difference is below the first. Else shorter steps are
/// tried, each this fraction of the one before, and so many in all: four of the result's twelve digits are
/// left with the last one.
inline constexpr double kDifferencesAgree = 1e-5;
inline constexpr double kShorterDifference = 0.1;
inline constexpr int kMostDifferenceSteps = 4;
/// Rows of differences that do not agree have a derivative all the same if its error is below this fraction.
inline constexpr double kDifferencesTell = 1e-3;
/// Relative to the result: the two agree if they differ by a smaller change of it over the step, which may be
/// rounding.
inline constexpr double kDifferenceRounding = 1e-11;
/// A number of the profile whose step changes no number of the mechanism by more than this has no effect;
/// relative to the largest of them.
inline constexpr double kNoNumberChange = 1e-14;
/// Slopes are 0 if the result would change by less than this when a number changes by its whole scale,
/// relative to the result or its rival. A result that is rounding itself may change by kNoSlopeOfRounding
/// times the rounding of its column as well, one that is constant along the path by kNoSlopeOfConstant times
/// the largest rounding of its places.
inline constexpr double kNoSlope = 1e-10;
inline constexpr double kNoSlopeOfRounding = 100;
inline constexpr double kNoSlopeOfConstant = 1e4;
/// Where a column has several equal extremes: their slopes are equal if they differ by less than this,
/// relative to the larger one.
inline constexpr double kSameSlope = 1e-7;
/// Relative to the result: a smaller second difference is no kink.
inline constexpr double kKinkRounding = 1e-8;
/// Over two steps the second difference of a smooth function is four times that over one step; below this
/// fraction of that there is a kink.
inline constexpr double kKinkOfDifference = 0.75;
/// Relative to the change by the slope over one step: a smaller second difference is no kink.
inline constexpr double kKinkOfSlope = 1e-3;

// Rounding of tolerance bands, relative to the variance and to the value.
inline constexpr double kVarianceRounding = 1e-14;
inline constexpr double kBandSlack = 1e-12;

// Design.

/// Fraction of a variable's range: closer to its bound it is at the bound.
inline constexpr double kAtBound = 1e-6;
/// A limit missed by less than this, relative to its scale, holds.
inline constexpr double kHoldsLimit = 1e-9;
/// Margin that dyads must keep to the edge of their reach, where rounding loses the motion; relative to the
/// size.
inline constexpr double kSpareReach = 1e-7;
/// Bodies closer than this, relative to the size and [rad], have the same pose.
inline constexpr double kSamePose = 1e-6;
/// Digits of a pose that is written, counted from the mechanism's size or from a radian.
inline constexpr int kPoseDigits = 10;
/// Objectives of a design and of its profile, read again, that differ by less are the same; relative to the
/// larger one and to DesignSetup::cost_scale. Extremes between rows are less accurate than the rows.
inline constexpr double kSameScore = 1e-6;
/// A constraint that changes by less, relative to its scale, does not depend on the variable: rounding.
inline constexpr double kNoConstraintChange = 1e-11;
/// Rounding of a number that is linear in the variables, relative to it. Its slope is found from the ends of
/// the variable's range: three digits are lost if the range is a thousand times the number.
inline constexpr double kLinearRounding = 1.001e-10;
/// Step of finite differences for the derivative of the Grashof margin, relative to the size.
inline constexpr double kGrashofStep = 1e-6;
/// Changes of a variable, as fractions of its range, that are tried to see whether it has any effect.
inline constexpr std::array kIdleShares = {1e-3, 0.02};
/// Places in the ranges of the variables that are tried, where the start does not assemble, to see which
/// constraints the variables change.
inline constexpr int kMostIdleStarts = 32;
/// A target that differs from the profile's value by more than this factor may be in a wrong unit ...
inline constexpr double kTargetApart = 20;
/// ... and another unit is suggested if with it the target is within this factor of the value.
inline constexpr double kTargetAsMuch = 3;

// Steps of a driver at which the reach of dyads is checked: [rad] for a pin, relative to the size for a
// slide.
inline constexpr double kGapStep = kPi / 30;
inline constexpr double kGapSlide = 0.05;
inline constexpr double kWholeGapSteps = 1e-9;  // rounding of a number of steps
inline constexpr double kEvenStep = 1e-6;       // relative: steps that are equal

// Paths that a point is to follow.

/// Value of a path constraint that holds, for the optimiser: any value well below 0, so that the constraint
/// is not taken to be active.
inline constexpr double kGoodPath = -0.01;
/// How far the place of the path that is nearest to a target may be from the row of the target, in steps to
/// the farther of the rows beside it: that row and half a step more.
inline constexpr double kReachOfPlace = 1.5;
/// Newton's method for the nearest place uses the curvature of the squared distance if it exceeds this
/// fraction of that for a straight path; else, far inside a bend, it would lead too far or to the farthest
/// place.
inline constexpr double kConvexDistance = 0.1;
/// Newton's method for it ends with a step below this fraction of the reach.
inline constexpr double kSharpestStep = 1e-13;
/// Fraction of a path's length: a path whose ends are closer together than this is closed.
inline constexpr double kClosedPath = 1e-6;
/// The iteration for the placement of a path (where, how turned and how large) ends with a smaller relative
/// change.
inline constexpr double kSettledPlacement = 1e-13;
/// A placement that scales the path to less than this has shrunk it to a point.
inline constexpr double kLeastPathScale = 1e-9;

// Fits to a measured motion.

/// Half of the range of an unknown without bounds, as a fraction of its start: measured mechanisms are known
/// to within a few per cent.
inline constexpr double kUnboundedRange = 0.25;
/// Lower bound of the noise of a column, relative to its largest value.
inline constexpr double kNoiseRounding = 1e-13;
/// The iteration for noise and weights ends with a smaller relative change.
inline constexpr double kNoiseSettled = 1e-6;
/// A variable has no effect if it is below this fraction of the largest effect of any, each over its scale.
inline constexpr double kNoFitChange = 1e-12;
/// Relative to the largest value of a column: if a number that changes by its own size changes the column by
/// less, that is rounding.
inline constexpr double kNoFitEffect = 1e-11;
/// Relative to the largest value of a column: a smaller spread counts as zero. It is also the lower bound of
/// a column's robust deviation.
inline constexpr double kNoSpread = 1e-12;
/// The same for residuals: those below are not noise but rounding of exact values.
inline constexpr double kNoisyColumn = 1e-9;
/// R² of a column that the fit does not explain. That of values without any trend is hardly below 0.
inline constexpr double kUnexplained = -0.1;
/// Rounding of a value, relative to the largest of its column.
inline constexpr double kValueNoise = 1e-15;
/// Fraction of the range of each unknown: searches that end closer together have found the same solution.
inline constexpr double kSameFitEnd = 1e-4;
/// The end of a search is better than another only if its sum is smaller by this fraction.
inline constexpr double kBetterSum = 1e-9;
/// The profile that is written moves as was fitted if its columns agree to within this, relative to the
/// largest value of each.
inline constexpr double kSameMotion = 1e-9;
/// Step of fourth-order differences, as a fraction of a variable's scale.
inline constexpr double kFourthOrderStep = 1e-3;
/// Step of differences by the offset of a driver: [rad], a fraction of the size, or of the time span.
inline constexpr double kOffsetStep = 1e-3;
/// Derivatives found by two methods agree if they differ by less than this fraction of the largest plus
/// kNoDerivative.
inline constexpr double kDerivativesAgree = 1e-5;
inline constexpr double kNoDerivative = 1e-12;
/// Singular values of the Jacobian, its columns scaled to length 1, below this fraction of the largest are
/// zero: their directions cannot be determined.
inline constexpr double kFitRank = 1e-8;
/// Unknowns whose component in such a direction is smaller than this have no part in it.
inline constexpr double kPartOfDirection = 1e-5;
/// Changes of the unknowns along such a direction are equal if their relative difference is below this.
inline constexpr double kAlikeChanges = 1e-4;
/// Correlation beyond which two unknowns can hardly be told apart.
inline constexpr double kCloseCorrelation = 0.99;
/// Residuals of neighbouring rows are correlated, which shows what the mechanism leaves out, if the
/// correlation is above this ...
inline constexpr double kSuccessionWorthSaying = 0.3;
/// ... and above this many of its standard deviations, 1/√n for n independent residuals: chance once in
/// 30000.
inline constexpr double kSureSuccession = 4;
/// The unit of a column is doubted if the misfit, relative to the size of the values, is above the first;
/// another unit fits if the misfit with it is below the second.
inline constexpr double kFarMisfit = 0.5;
inline constexpr double kNearMisfit = 0.25;
/// The other unit must also bring the misfit below this fraction of that in the given unit.
inline constexpr double kBetterMisfit = 0.2;

}  // namespace higherpair
