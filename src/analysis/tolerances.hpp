#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>
#include <limits>

// The tolerances of the analysis. "The size" is that of the mechanism, "[rad, of the size]" means radians for
// angles and fractions of the size for lengths. Unless stated otherwise, lengths are fractions of the size
// and steps along a path are fractions of one unit of its drivers (unit_of in inputs.hpp). A driver's scale
// is one radian or, where it slides, the size (driver_scale in inputs.hpp).
//
// A sine is GroupState::sine: how far the conditions of a group of bodies are from losing their rank, 0 at
// limit positions and change points. A change point is a position in which branches cross.

namespace higherpair {

// Assemblies and starts.

/// Assemblies that differ by no more than this are the same [rad, of the size].
inline constexpr double kSameAssembly = 1e-12;
/// Positions of bodies in a run that differ by less than this are the same [rad, of the size].
inline constexpr double kSameRunPosition = 1e-9;
/// If a mechanism cannot start, other starts of a sliding driver are tried up to this distance to either
/// side, as a fraction of the size.
inline constexpr double kReachOfSlide = 2;

/// Ranges of positions to start from are equally near if their distances differ by less than this fraction of
/// the range that was searched: bisection finds their ends to a hundredth of it.
inline constexpr double kSameStartDistance = 1e-7;

/// Relative to a group's lever: a start whose sine is below this counts as singular.
inline constexpr double kSingularStart = 1e-7;
/// How near a start has to be to a singular point, as a fraction of the path's unit, to be moved onto it:
/// there Newton's method yields only half the digits.
inline constexpr double kNearSingularStart = 1e-5;
/// Farthest that the bodies at a start may be from where two branches merge, for the start to be moved there
/// [rad, of the size].
inline constexpr double kNearMerge = 0.3;
/// Next to a change point, a branch is taken to be the one meant by the poses if its squared distance from
/// them is below this fraction of every other branch's (a tenth in distance).
inline constexpr double kPosesTell = 1e-2;
/// Relative differences below which two speeds, or two accelerations, are the same.
inline constexpr double kSameSpeed = 1e-3;
inline constexpr double kSameAcceleration = 1e-6;

// Steps along a motion.

/// Largest inner step of a sliding driver, as a fraction of the size; kLargestTurn is that of a turning one.
inline constexpr double kLargestSlide = 1.0 / 6;
/// Steps longer than this fraction of the driver's scale are shortened if they end near a crossing of
/// branches.
inline constexpr double kLongStep = 0.02;
/// Factor by which they are shortened: the golden section, for crossings are often at simple fractions of the
/// path, as in symmetric mechanisms, and the shorter step should not end near another one.
inline constexpr double kShorterByCrossing = 0.618;
/// Steps longer than this fraction of the driver's scale are halved if a contact has left its span without a
/// joint of spans having been found within the step.
inline constexpr double kShortPassing = 1e-4;
/// Largest step while a contact is open, as a fraction of the largest step otherwise: it must not close and
/// open again within a step.
inline constexpr double kOpenShare = 0.2;
/// Largest turn of a body in one step [rad].
inline constexpr double kFarthestBodyTurn = 2;
/// Largest mismatch between the change of a coordinate in a step and the change that its rates at both ends
/// predict, as a fraction of the change; see Smoothness in step.cpp.
inline constexpr double kSmoothStep = 0.04;
/// The same for the travel of a contact point along a body; mismatches up to kLeastJump, relative to the
/// size, never count as a jump of the point.
inline constexpr double kSmoothTravel = 0.3;
inline constexpr double kLeastJump = 1e-4;
/// A mismatch up to this is always accepted: rounding [rad, of the size].
inline constexpr double kNoMismatch = 1e-9;
/// Jumps of the normal, and of velocities per unit of the path, at a joint of two spans whose directions
/// differ by too little for a corner (kSameJointDirection): if the bodies are at rest beyond the joint, these
/// jumps are the only sign of it.
inline constexpr double kTurnOfKink = 2e-7;
inline constexpr double kVelocityOfKink = 1e-6;
/// Drivers that are no farther than this from the line along which they left a limit are on it; relative to
/// the driver's scale plus its coordinate.
inline constexpr double kOnLineAhead = 1e-9;
/// At times that are nearer to a break of a curve in time than this, rates are those within the piece;
/// relative to the larger of the time and the length of the piece.
inline constexpr double kTimeRounding = 1e-14;
/// How far beyond a break the drivers go straight to the curve again, where the state has not come to the
/// break; in units of the inputs.
inline constexpr double kOverBreak = 0.01;
/// Turns that differ from half a turn by less than this count as half a turn [rad].
inline constexpr double kHalfTurn = 1e-3;

// Limits of the motion.

/// A row this near to a limit is at the limit; relative to the driver's scale plus its coordinate.
inline constexpr double kOnLimit = 1e-14;
/// Fraction of the driver's scale: a row this near to a limit is solved for directly, without a step.
inline constexpr double kBesideLimit = 1e-12;
/// Fraction of the driver's scale: a limit this near counts as reached; the rest is rounding.
inline constexpr double kReachesLimit = 1e-9;
/// Fraction of the driver's scale: nearer than this to a limit, rates may be too inexact to go on.
inline constexpr double kNearLimit = 1e-6;
/// The same for a pole, a limit at which bodies run off to infinity: there only its position is needed.
inline constexpr double kNearPole = 1e-2;
/// At this share of the distance to a limit, a group that is lost before it can no longer be placed.
inline constexpr double kNearlyAtLimit = 0.99;
/// Length of the next step before a limit, as a fraction of what is left to the limit.
inline constexpr double kShareToLimit = 0.5;
/// Relative to the size: bodies and contacts farther away than this may be on their way to infinity.
inline constexpr double kFarAway = 100;
/// Relative to the size: farther out than this the rates of a contact have too few correct digits.
inline constexpr double kTooFar = 1e4;
/// Fraction of the size: a contact counts as at infinity if the rounding of its coordinates alone exceeds
/// this, so that its gap cannot be closed.
inline constexpr double kRoundingOfGap = 1e-10;
/// Times the distance of the farthest body, the largest residual that rounding alone may leave: some sums of
/// coordinates of that size.
inline constexpr double kRoundingOfPosition = 8 * std::numeric_limits<double>::epsilon();
/// Largest distance of a predicted follower from its limit position, in units of its coordinate [rad, of the
/// size].
inline constexpr double kNearFollowerLimit = 0.3;
/// Added to the lever of a turning follower, as a fraction of the size, so that the lever is not 0 if the
/// contact is at the pivot.
inline constexpr double kLeastLever = 1e-3;
/// Where the motion ends, two curves conform if the sum of their curvatures is below this fraction of the
/// larger one, or of 1/size: it falls with the root of the distance, which is below kReachesLimit.
inline constexpr double kConforms = 1e-4;
/// Limits that are nearer to each other than this fraction of the driver's scale are the same.
inline constexpr double kSameLimit = 1e-9;

// Beyond a limit at which the motion was lost. A stretch is a range of the drivers in which the branch can be
// assembled.

/// Spacing of the positions at which a lost branch is looked for, as a fraction of the leading driver's
/// scale.
inline constexpr double kLostBranchProbe = kPi / 576;
/// Between two of these positions a lost contact that is found again is at another place if its normal turns
/// by more than the angle of this cosine, or if it moves by more than this fraction of the size.
inline constexpr double kSameNormalPlace = 0.98;
inline constexpr double kSameContactPlace = 0.1;
/// Positions from which lost coupled bodies are looked for are rounded to multiples of this [rad, of the
/// size]: much more than rounding errors, and much less than any distance that counts.
inline constexpr double kSearchGrid = 1e-6;
/// Largest distance between a pole and where the motion is resumed on its other side, as a fraction of the
/// leading driver's scale.
inline constexpr double kAcrossPole = kPi / 144;
/// Shortest first step away from a limit, as a fraction of the driver's scale.
inline constexpr double kShortestFirstStep = 1e-12;
/// Fraction of the driver's scale: a row this near to where a stretch begins, or to the earliest position
/// that it could be followed back to, is at its beginning.
inline constexpr double kAtBeginning = 1e-6;
/// Relative to a group's lever: a GroupState::sine below this is too near to a limit.
inline constexpr double kTooNearLimit = 1e-6;
/// Relative to the size: beyond a limit, contacts farther out than this come from infinity or are about to
/// run off to it.
inline constexpr double kFarOut = 1e6;
/// For a row at the limit at which a stretch begins: how far inside the stretch the search for that limit
/// starts, as a fraction of the driver's scale.
inline constexpr double kInsideLimit = 1e-3;

/// Step for the slope of the room that is left to assemble the bodies, as a fraction of the distance to the
/// next position that is tried.
inline constexpr double kALittleAhead = 1e-4;
/// Shortest stretch that is looked for, as a fraction of the leading driver's scale.
inline constexpr double kShortestStretch = 1e-9;

// Ends of joints.

/// Fraction of the size by which rounding may put a joint beyond its end, so that a row may be exactly at it.
inline constexpr double kBeyondJointEnd = 1e-12;
/// A joint this near to its end is at it, as a fraction of the size.
inline constexpr double kAtJointEnd = 1e-9;

// Crossings of branches.

/// Relative to a group's lever: a sine below this is near a crossing.
inline constexpr double kNearCrossing = 1e-3;
/// Distance from a crossing of branches, as a fraction of the driver's scale, at which positions are regular
/// and can be interpolated from.
inline constexpr double kCrossingReach = 4e-3;
/// Farthest that a body may move within this distance [rad, of the size]: the error of the interpolation is
/// the sixth power of it.
inline constexpr double kCrossingTurn = 0.012;

// Power series in time, of a row and through change points. Distances are how far the fastest of a group's
// bodies moves [rad, of the size].

/// Relative rounding error of the highest-order term up to which a series is used unchecked.
inline constexpr double kRoundingOfSeries = 1e-10;
/// Beyond this rounding error the series of a row near a change point is marked unknown, unless the series
/// through the change point replaces it.
inline constexpr double kSpoiltSeries = 1e-6;
/// Farthest change point that is looked for: beyond it no series of moderate order converges.
inline constexpr double kChangePointReach = 0.3;
/// Positions closer than this to the point of rank loss count as that point. It is the length of the last
/// step towards it, after which the distance is much smaller.
inline constexpr double kAtChangePoint = 1e-9;
/// Most steps of Newton's method towards that point.
inline constexpr int kMostChangePointSteps = 10;
/// At a change point all singular values but one are above this fraction of the largest.
inline constexpr double kOneLostRank = 1e-3;
/// A series converges if its last two terms make up no more than this fraction of the derivatives at the row.
inline constexpr double kLastTerms = 1e-9;
/// The series through a crossing must reproduce the row's position, relative to the size, and its rates,
/// relative to the largest, to within this; other branches are farther away.
inline constexpr double kSameBranch = 0.02;
/// Branches that violate the conditions where they would cross by more than this, relative to the size, do
/// not meet: rounding is 1e7 times smaller.
inline constexpr double kMeetsNoLonger = 1e-9;
/// A change point persists when a parameter changes if no more than this fraction of the conditions'
/// derivatives by the parameter is such that no motion of the bodies can compensate.
inline constexpr double kKeepsChangePoint = 1e-9;

// Events.

/// Velocities below this fraction of the largest in the step are rounding: they have no sense of motion.
inline constexpr double kSlowestOutput = 1e-12;
/// A shorter stroke is none [rad, of the size]: the ripple of a table, which steps may pass over.
inline constexpr double kShortestStroke = 1e-6;
/// The same for a stroke that had begun before the run did, or before the contact changed.
inline constexpr double kShortestFirstStroke = 1e-8;
/// A step in which the estimated least speed is below this fraction of the speeds at its ends is searched for
/// reversals.
inline constexpr double kMayReverse = 0.3;
/// Change points that are nearer to each other than this fraction of the driver's scale are the same.
inline constexpr double kSameChangePoint = 1e-7;

// Reduction of a group's conditions to one equation ε(λ, s) = 0 (see Reduction in reduction.hpp).

/// Last change of a solution at which Newton's method ends, as a fraction of the size.
inline constexpr double kReductionSettled = 1e-13;
/// Fraction of the size: changes below this fall quadratically; once they do not, they are rounding.
inline constexpr double kReductionNear = 1e-9;
/// Difference steps for second derivatives, as fractions of the size and of the unit of s.
inline constexpr double kReductionDifference = 1e-5;
/// Largest |λ|, and largest step of Newton's method, relative to the size.
inline constexpr double kReductionFarthest = 2;
/// Steps of Newton's method for the root below this fall quadratically; once they do not, they are rounding.
inline constexpr double kReductionNearRoot = 1e-7;
/// A step this short ends the iteration.
inline constexpr double kReductionNoStep = 1e-15;
/// A change point no farther outside of a step than this fraction of the unit of s belongs to the step.
inline constexpr double kAtStepEnd = 1e-9;
/// Relative to the size: an |ε| below this is 0 to within rounding.
inline constexpr double kCrosses = 1e-13;
/// Largest deviation of the branch from a parabola up to a limit, as a fraction of the distance.
inline constexpr double kLimitParabola = 0.04;
/// Largest distance of a limit ahead, in steps.
inline constexpr double kFarAhead = 64;

// Coupled bodies.

/// Largest step of Newton's method [rad, of the size].
inline constexpr double kLargestCoupledStep = 0.3;
/// Pivots below this fraction of the largest count as 0.
inline constexpr double kCoupledRank = 1e-10;
/// Scaled determinant above which a coupled group certainly has full rank.
inline constexpr double kSurelyPlaced = 1e-9;
/// A group is all but singular where its smallest pivot, the last step of Newton's method and the
/// remaining residual are below these; the latter two as fractions of the size.
inline constexpr double kAllButSingular = 1e-6;
inline constexpr double kSingularStep = 1e-6;
inline constexpr double kCoupledClosure = 1e-14;
/// Scaled determinant of a coupled group below which it is rounding.
inline constexpr double kCoupledRounding = 1e-14;
/// As fractions of the size: steps of Newton's method below the first fall quadratically; residuals below the
/// second meet the conditions.
inline constexpr double kCoupledNear = 1e-9;
inline constexpr double kCoupledResidual = 1e-9;
/// Fraction of the size: where bodies that cannot be assembled violate their conditions by no more than this,
/// there is a solution next to their position.
inline constexpr double kCoupledApproach = 1e-6;
/// The search for the position of least violation [rad, of the size]: the difference step for second
/// derivatives, the change at which the iteration ends, and the largest displacement of the bodies in one
/// driver step.
inline constexpr double kApproachDifference = 1e-6;
inline constexpr double kApproachSettled = 1e-7;
inline constexpr double kFarthestApproach = 4;
/// Most iterations of that search, by Newton's method and by the method of Levenberg and Marquardt.
inline constexpr int kApproachSteps = 6;
inline constexpr int kMostApproachSteps = 200;
/// Relative to the size: coupled bodies whose motion is lost farther out than this are on their way to
/// infinity.
inline constexpr double kCoupledFarOut = 1e3;

// Overlap of bodies.

/// Fraction of the size: an overlap less deep than this is a touch. Ten times the precision to which
/// distances are computed.
inline constexpr double kOverlapDepth = 1e-9;
/// The same for boundaries, which are sampled.
inline constexpr double kOverlapOfBoundaries = 1e-7;
/// That precision.
inline constexpr double kOverlapPrecision = kOverlapDepth / 10;

// A contact that reaches a corner can also change to another place that gives the bodies the same motion. It
// stays on the corner until the overlap at the other place exceeds kOverlapDepth. Rates that differ by less
// than kSameRates are the same motion; a corner that was reached less than kAtCorner before the change is not
// reported.
inline constexpr double kSameRates = 1e-6;  // relative to the follower's unit
inline constexpr double kAtCorner = 1e-6;   // relative to the driver's scale

// Places of contacts on boundaries.

/// Fraction of the drivers' unit: a path that ends no farther than this beyond a joint of spans ends at the
/// joint.
inline constexpr double kJointAtEnd = 1e-12;
/// A contact this near to the end of a span is at it, as a fraction of the boundary's size; on corners [rad].
inline constexpr double kAtSpanEnd = 1e-6;
/// Largest distance that a contact is expected to run along a boundary in a step, relative to what its speeds
/// at both ends suggest.
inline constexpr double kFartherAlong = 2;
/// A place at which bodies cease to touch nearer to the start of the step than this fraction of the drivers'
/// unit counts as left at that start. Also, as a fraction of the boundary's size: a place this near to the
/// end of a span is at the end.
inline constexpr double kJustLeft = 1e-9;
/// Distances beyond a vertex, as fractions of the drivers' unit, from which it is tried to continue the
/// motion.
inline constexpr std::array kBeyondVertex = {0.0, 1e-14, 1e-13, 1e-12, 1e-11};
/// A smaller jump of a rate is due to rounded dimensions [rad, of the size, per unit of the driver].
inline constexpr double kNoJump = 1e-9;
/// Relative to the larger of two rates: a rate below this is 0.
inline constexpr double kRateRounding = 1e-12;

/// Distance within which other places of touch are looked for, relative to how far the bodies move against
/// each other in the step at their largest rates.
inline constexpr double kFartherThanByRates = 1.5;
/// A place this near to the contact, as a fraction of the boundaries' size, is the contact itself ...
inline constexpr double kSameMeeting = 1e-6;
/// ... if the normals agree to within this [rad]: the two sides of a notch are near each other.
inline constexpr double kSameMeetingNormal = 1e-3;
/// Gaps before and after a step are of the same place if they agree with their rates to within this fraction
/// of the change.
inline constexpr double kGapAgrees = 0.1;
/// An estimated least gap within a step is solved for if it is below this fraction of the gaps at the step's
/// ends.
inline constexpr double kWorthALook = 0.5;

// Gaps and residuals.

/// Fraction of the size: a gap this small is 0 to within rounding.
inline constexpr double kClosedGap = 1e-14;
/// Fraction of the size by which a curve may pass beside an end and still meet it.
inline constexpr double kCapture = 1e-3;
/// Largest shift of a body that is moved onto its contact, as a fraction of the size.
inline constexpr double kFarthestShift = 5e-3;
/// Fraction of the size: a contact whose body is posed farther from it than this starts open.
inline constexpr double kStartsApart = 1e-4;
/// Contacts whose coordinates at the start differ by less than this [rad, or relative to the size] are made
/// at the same time.
inline constexpr double kTouchAtOnce = 1e-11;
/// A follower that is posed less than this [rad, or relative to the size] beyond a contact starts at it,
/// whatever the sense of its approach.
inline constexpr double kTouchAtStart = 1e-9;
/// Product of the sines between a normal and those of two neighbouring samples, below which it is one of
/// theirs to within rounding.
inline constexpr double kOnSample = 1e-12;
/// Speed at which a body comes towards a follower at rest that pushes it on, as a fraction of both speeds.
inline constexpr double kPushes = 1e-6;
/// First further distance, as a fraction of the drivers' unit, for a contact that closes next to an end of a
/// curve if the curves do not meet yet there.
inline constexpr double kFirstNudge = 1e-13;
/// Far out on open curves, rounding of the common normal shifts contact points along the tangent by this
/// fraction of the radii of curvature.
inline constexpr double kNormalRounding = 4 * std::numeric_limits<double>::epsilon();

// Chains of dyads, many rows at once.

/// Largest ratio of a coordinate to the shortest link: the rounding of a link's direction is then at most
/// 1e-13, so that no residual comes near 1e-9 of the size.
inline constexpr double kFarthestPoint = 1e3;
/// A body whose first angle differs from its pose's by more than this may be half a turn from it, on either
/// side.
inline constexpr double kSureTurn = kPi - 1e-6;
/// Fraction of the size: the direction of a shorter spring is made of rounding, or undefined.
inline constexpr double kShortestSpring = 1e-6;
/// Assemblies whose squared distances from the poses differ by less than this fraction of the square of the
/// size are equally near: the one whose bodies are turned less is taken.
inline constexpr double kAsNear = 1e-9;
/// Largest distance between a disc that a chain has placed and where a Run places it, as a fraction of the
/// size, for both to be in the same mode: the other mode is much farther away.
inline constexpr double kSameChainPlace = 1e-6;

/// Bounds are only given for sines above this; a smaller one may be near a limit or a crossing
/// (kNearCrossing).
inline constexpr double kSafeSine = 0.02;
/// If a body turns by more than this from one row to the next, its whole turns are uncertain [rad].
inline constexpr double kSafeTurn = 2;
/// How far a contact's force may fall between rows below its values in the rows, as a multiple of their
/// differences. At the two rows next to either end it is larger by the second factor, as the differences
/// there are those of the third row.
inline constexpr double kForceDip = 0.5;
inline constexpr double kForceDipAtEnd = 4;

/// More slender ellipses (q = 1 - e²) are nearly parabolas: their centres are too far away to locate the
/// vertex.
inline constexpr double kSlenderestOval = 1e-2;
/// Largest turn of the body or the normal in one pass of Newton's method [rad].
inline constexpr double kFarthestOvalGuess = 0.4;
/// Fraction of the size: from a gap this small one more pass reaches rounding, as the curvature is known well
/// enough.
inline constexpr double kOvalsArrived = 1e-12;
/// |∂gap/∂q| relative to the arm of the contact, below which it is near a limit.
inline constexpr double kLeastOvalSine = 0.02;
/// Relative change of the spacing of the rows above which third derivatives are not taken from three rows.
inline constexpr double kUnevenRows = 1e-3;

// Derivatives by dimensions.

/// A coordinate has no effect on the slip of a contact if its unit change changes the slip by less than this
/// fraction of the size.
inline constexpr double kNoInfluenceSlip = 1e-9;

/// Largest displacement of a row for difference quotients [rad, of the size]. Their truncation error, of the
/// eighth power, is below rounding, and rounding is not amplified much.
inline constexpr double kLargestDisplacement = 4e-3;
/// There is a kink or a jump at the row itself, displacement 0, if the slopes on its two sides differ by more
/// than the sum of these multiples of the fourth difference on the smoother side, of the slopes and of the
/// values.
inline constexpr double kKinkOfBends = 100;
inline constexpr double kKinkOfSlopes = 1e-7;
inline constexpr double kKinkOfValues = 1e-12;
/// Fraction of the step by which a row is displaced to see how fast curvatures change.
inline constexpr double kCurvatureProbe = 1e-3;
/// If the step suited to radii of curvature is at least this fraction of the step suited to the rest, it is
/// used for both, which costs a digit.
inline constexpr double kMuchShorterStep = 0.1;
/// The shorter step is used if its error estimate is smaller by this factor; at a kink at 0 both are equal.
inline constexpr double kWorthShorterStep = 2;
/// A slope is doubtful if the eighth difference exceeds both of these fractions, of the change in a step and
/// of the largest value: smooth functions stay below the first, rounding below the second ...
inline constexpr double kDoubtfulDifference = 1e-5;
inline constexpr double kSureDifference = 1e-10;
/// ... unless it exceeds this multiple of the largest value: then the values are nothing but rounding. The
/// eighth difference of |x| is at most 10 times the largest value, that of random numbers around 60 times.
inline constexpr double kRoundingDifference = 25;
/// Factor by which the step is shortened where a slope is doubtful, and how often at most.
inline constexpr double kShorterStep = 1.0 / 16;
inline constexpr int kMostShorterSteps = 4;
/// Largest relative disagreement of difference quotients of two orders for dimensions that count as smooth
/// functions of a parameter.
inline constexpr double kDimensionsNotSmooth = 1e-6;

/// Difference steps of a parameter that are tried one after another, as fractions of its scale.
inline constexpr std::array kParameterSteps = {1e-3, 1e-4, 1e-5, 1e-7, 1e-9};
/// Disagreement of two difference quotients, of different order, of a boundary by a parameter: below the
/// first the better one is exact to within rounding, and no other step is tried; above the second it is not
/// used. Boundaries that change with the parameter by less than the third do not change.
inline constexpr double kBoundariesAgree = 1e-10;
inline constexpr double kBoundariesDisagree = 1e-8;
inline constexpr double kBoundariesStandStill = 1e-11;

}  // namespace higherpair
