#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>

// Tolerances of this folder. Lengths are relative to the mechanism's size, values to what they are compared
// with: a result, the largest value of a column, the range of a variable.

namespace higherpair {

// Shapes.

/// A pin this close to the centre of a round curve is at it.
inline constexpr double kPinAtCenter = 1e-9;

// Rows and events.

/// Fraction of the path between two rows: an event this close to the end is at the row.
inline constexpr double kAtRowEnd = 1e-9;
/// Fraction of the row spacing: a place this close to a row is on it.
inline constexpr double kOnRow = 1e-9;
/// Relative width at which bisection for a place on the path ends.
inline constexpr double kPlaceOnPath = 1e-15;
/// Fraction of the span of all rows: a row this close to a place is at that place.
inline constexpr double kAtPlace = 1e-9;
/// Driver positions that differ by less are the same; relative to 1 + |position| in its unit.
inline constexpr double kSamePosition = 1e-9;
/// Arcs of contacts up to a row that differ by less are the same; relative to the mechanism's size.
inline constexpr double kSameRowArc = 1e-9;
/// Longest travel of a sliding driver, in sizes of the mechanism: farther away, positions are rounded by more
/// than the default tolerance; the path is followed in steps of a sixth of the size.
inline constexpr double kLongestDriverSlide = 1e7;
/// The same for a turning driver, in turns; the path is followed in steps of 10 degrees.
inline constexpr double kMostDriverTurns = 1e7;
/// Smallest tolerance for which a DyadChain is used.
inline constexpr double kLeastChainTolerance = 1e-9;
/// Largest deviation from 1 of the length of a unit vector.
inline constexpr double kUnitDirection = 1e-9;

// Results of a path.

/// Relative to the value that the mechanism's size and the drivers' speed give in a column's dimension:
/// values below are rounding.
inline constexpr double kResultRounding = 1e-12;
/// Fraction of the spread of a column: extremes that differ by less are equal.
inline constexpr double kSameResult = 1e-9;
/// Fraction of the largest value of a column: a change of it from one row to the next that is smaller is no
/// jump.
inline constexpr double kNoColumnJump = 1e-6;
/// An extreme is tested for smoothness at this fraction of the whole path to either side; there a smooth
/// column is lower by at most kSmoothFall times its spread.
inline constexpr double kBesideExtreme = 1e-5;
inline constexpr double kSmoothFall = 3e-7;
/// The end of a stretch on which a column is constant, as found by halving, is taken back by this fraction of
/// the distance to the sample within it: at the end itself rounding decides on which side a place is.
inline constexpr double kInsideEdge = 1e-6;
/// Relative difference below which scaling may make two values equal; a generous bound.
inline constexpr double kScalingRounding = 1e-15;

// Checks.

/// A value within this fraction of its limit is at the limit.
inline constexpr double kAtCheckLimit = 1e-9;
/// Values on the path whose relative difference is below this are equal to within rounding.
inline constexpr double kSamePathValue = 1e-9;
/// Relative to the size of a flank: differences below count as zero.
inline constexpr double kNoFlankSize = 1e-9;
/// Fraction of the path: breaks of a flank's law closer together than this are one.
inline constexpr double kSameBreak = 1e-12;
/// Relative to the curvature 1/size: smaller curvatures are straight.
inline constexpr double kStraightContact = 1e-9;
/// Fraction of the speeds at a contact: a slower motion along the normal is rounding.
inline constexpr double kRestingContact = 1e-9;
/// Relative to the largest entrainment speed: values below count as zero.
inline constexpr double kNoEntrainment = 1e-9;

// Noise levels: extremes below are rounding and are not searched for. Their places would mean nothing, and
// finding them would take thousands of steps.
inline constexpr double kNoAngle = 1e-13;          // [rad]
inline constexpr double kNoCurvature = 1e-13;      // relative to the curvature 1/size
inline constexpr double kSlidingRounding = 1e-13;  // relative to the drivers' speed times the size
inline constexpr double kTravelRounding = 1e-12;   // the same for accelerations
inline constexpr double kRoundingOfJerk = 1e-11;   // and for jerks

// Mobility in words.

/// A slider-crank with a smaller offset is central; relative to the sum of its links.
inline constexpr double kCentralOffset = 1e-12;
/// Relative to the coupler: a crank with less than this to spare turns fully through a change point only.
inline constexpr double kChangePointSlack = 1e-12;
/// Numbers of the text below this are written as 0.
inline constexpr double kNoNumber = 1e-12;

// Pictures and reports.

/// Relative to the scale of a column: smaller values and changes are rounding.
inline constexpr double kColumnNoise = 1e-9;
// Rounding steps of what a report draws.
inline constexpr double kPlaceStep = 1e-8;  // of the picture's size: positions of bodies
inline constexpr double kAngleStep = 1e-8;  // [rad]
inline constexpr double kShapeStep = 1e-6;  // of the picture's size: shapes that are redrawn in each row
// Fraction of the picture's size, and [rad]: first and last row closer than this show the same picture.
inline constexpr double kSamePicture = 1e-6;
inline constexpr double kPowerOfTen = 1e-9;  // rounding of the exponent of a step that is a power of ten
/// A polygon is a line if no arrow reaches farther sideways than this fraction of the longest one.
inline constexpr double kFlatPolygon = 1e-6;
/// Driver positions closer together than this, in SI units, share one mark in a plot.
inline constexpr double kSameMark = 1e-6;
/// Fraction of the path: rounding allowed for the last scene of `every`, at the end of the path.
inline constexpr double kLastScene = 1e-12;
/// Fraction of a lap: rounding allowed at the ends of a branch of a map over which a run is drawn lap by lap.
inline constexpr double kWholeLap = 1e-9;
/// Overlap of a contact that counts as free on a map, relative to the size.
inline constexpr double kMapOverlap = 1e-9;

// Derivatives by numbers of a profile.

/// Step of finite differences, as a fraction of the number's scale.
inline constexpr double kDifferenceStep = 2e-4;
/// Change of the mechanism's numbers over one step, relative to the largest of them: smaller changes are
/// rounding.
inline constexpr double kNoNumberChange = 1e-14;
/// Change of a result when a number changes by its whole scale, relative to the result or its rival: smaller
/// changes are rounding. For a result that is rounding itself, kNoSlopeOfRounding times the rounding of its
/// column is the bound as well; for a column that is constant along the path, kNoSlopeOfConstant times it:
/// to each side the largest rounding of all its places counts.
inline constexpr double kNoSlope = 1e-10;
inline constexpr double kNoSlopeOfRounding = 100;
inline constexpr double kNoSlopeOfConstant = 1e4;
/// Slopes at several equal extremes of a column whose difference is smaller are equal; relative to the larger
/// one.
inline constexpr double kSameSlope = 1e-7;
/// Relative to the result: a smaller second difference is no kink.
inline constexpr double kKinkRounding = 1e-8;
/// A kink if the second difference over two steps is below this fraction of the value for a smooth function,
/// four times that over one step.
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
/// Rounding of a function that is linear in the variables, relative to the number. Its slope is that between
/// the ends of the variable's range: over a range of a thousand times the number it loses three digits.
inline constexpr double kLinearRounding = 1.001e-10;
/// Step of finite differences for the derivative of the Grashof margin, relative to the size.
inline constexpr double kGrashofStep = 1e-6;
/// Changes of a variable, as fractions of its range, that are tried to see whether it has any effect.
inline constexpr std::array kIdleShares = {1e-3, 0.02};
/// Places in the ranges of the variables that are tried, where the start does not assemble, to see which
/// constraints the variables change.
inline constexpr int kMostIdleStarts = 32;
/// A target that differs from the profile's value by more than this factor may be given in a wrong unit.
inline constexpr double kTargetApart = 20;
/// Another unit is suggested where it brings the target to within this factor.
inline constexpr double kTargetAsMuch = 3;

// Steps of a driver at which the reach of dyads is checked: [rad] for a pin, relative to the size for a
// slide.
inline constexpr double kGapStep = kPi / 30;
inline constexpr double kGapSlide = 0.05;
inline constexpr double kWholeGapSteps = 1e-9;  // rounding of a number of steps
inline constexpr double kEvenStep = 1e-6;       // relative: steps that are equal

/// Fraction of the row spacing: a smaller step ends Newton's method.
inline constexpr double kSharpestStep = 1e-13;
/// Fraction of a path's length: a path whose ends are closer together is closed.
inline constexpr double kClosedPath = 1e-6;
/// A smaller relative change of a path's placement ends its iteration.
inline constexpr double kSettledPlacement = 1e-13;
/// Scale of a placement: a path scaled to less has shrunk to a point.
inline constexpr double kLeastPathScale = 1e-9;

// Fits to a measured motion.

/// Lower bound of the noise of a column, relative to its largest value.
inline constexpr double kNoiseRounding = 1e-13;
/// Noise and weights that change by less have settled.
inline constexpr double kNoiseSettled = 1e-6;
/// Relative to the largest effect of any variable, each scaled: a smaller effect is none.
inline constexpr double kNoFitChange = 1e-12;
/// Relative to the largest value of a column: if a number that changes by its own size changes the column by
/// less, that is rounding.
inline constexpr double kNoFitEffect = 1e-11;
/// Relative to the largest value of a column: a smaller spread counts as zero; also the least robust
/// deviation.
inline constexpr double kNoSpread = 1e-12;
/// The same for residuals: those below are not noise but rounding of exact values.
inline constexpr double kNoisyColumn = 1e-9;
/// Rounding of a value, relative to the largest of its column.
inline constexpr double kValueNoise = 1e-15;
/// Fraction of a range: searches that end closer together have found the same solution.
inline constexpr double kSameFitEnd = 1e-4;
/// Relative: an end of a search is better only if its sum is smaller by this.
inline constexpr double kBetterSum = 1e-9;
/// Relative to a column's largest value: the new profile moves as was fitted.
inline constexpr double kSameMotion = 1e-9;
/// Step of fourth-order differences, as a fraction of a variable's scale.
inline constexpr double kFourthOrderStep = 1e-3;
/// Step of differences by the offset of a driver: [rad], a fraction of the size, or of the time span.
inline constexpr double kOffsetStep = 1e-3;
/// Derivatives found by two methods agree to within this fraction of the largest, plus kNoDerivative.
inline constexpr double kDerivativesAgree = 1e-5;
inline constexpr double kNoDerivative = 1e-12;
/// Rank of the Jacobian with columns scaled to length 1: singular values below this fraction of the largest
/// are zero.
inline constexpr double kFitRank = 1e-8;
/// An unknown with a smaller component has no part in a direction.
inline constexpr double kPartOfDirection = 1e-5;
/// Relative difference of changes that are equal.
inline constexpr double kAlikeChanges = 1e-4;
/// Correlation beyond which two unknowns can hardly be told apart.
inline constexpr double kCloseCorrelation = 0.99;
/// Misfit relative to the size of the values above which the unit is doubted, and below which another one
/// fits.
inline constexpr double kFarMisfit = 0.5;
inline constexpr double kNearMisfit = 0.25;
/// The other unit must also bring the misfit below this fraction of that in the given unit.
inline constexpr double kBetterMisfit = 0.2;

}  // namespace higherpair
