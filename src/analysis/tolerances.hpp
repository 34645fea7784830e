#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>
#include <limits>

// The tolerances of the analysis. Unless stated otherwise, lengths are fractions of the mechanism's size and
// steps along a path are fractions of one unit of its drivers (unit_of in step.hpp). A driver's scale is one
// radian or, where it slides, the size (driver_scale in step.hpp).

namespace higherpair {

// Assemblies and starts.

/// Assemblies that differ by no more than this are the same [of the size, rad].
inline constexpr double kSameAssembly = 1e-12;
/// Positions that differ by less than this are the same [of the size, rad].
inline constexpr double kSameRunPosition = 1e-9;
/// Fraction of the size by which a sliding driver is tried to either side of its start, if it cannot start
/// there.
inline constexpr double kReachOfSlide = 2;

/// Ranges of positions to start from are equally near if their distances differ by less than this fraction of
/// the positions that were looked at: their ends are bisected to a hundredth of it.
inline constexpr double kSameStartDistance = 1e-7;

/// Relative to a group's lever: a start whose sine (see GroupState) is below this counts as singular.
inline constexpr double kSingularStart = 1e-7;
/// How near a start has to be to a singular point, as a fraction of the path's unit, to be moved onto it:
/// there Newton's method yields only half the digits.
inline constexpr double kNearSingularStart = 1e-5;
/// Largest distance of a position from one at which two branches merge [rad, of the size].
inline constexpr double kNearMerge = 0.3;
/// Of the branches at a start next to a change point, one is that of the poses if it is nearer to them than
/// any other by this factor: squared distances, a tenth of the distance.
inline constexpr double kPosesTell = 1e-2;
/// Speeds, and accelerations, whose relative difference is smaller are the same.
inline constexpr double kSameSpeed = 1e-3;
inline constexpr double kSameAcceleration = 1e-6;

// Steps along a motion.

/// Largest inner step of a sliding driver, as a fraction of the size; kLargestTurn is that of a turning one.
inline constexpr double kLargestSlide = 1.0 / 6;
/// Fraction of the driver's scale: longer steps may be shortened so that they do not end near a crossing of
/// branches.
inline constexpr double kLongStep = 0.02;
/// Fraction of the driver's scale: longer steps are halved where a contact has passed joints that are not
/// found.
inline constexpr double kShortPassing = 1e-4;
/// Largest step while a contact is open, as a fraction of the largest step otherwise.
inline constexpr double kOpenShare = 0.2;
/// Largest turn of a body in one step [rad].
inline constexpr double kFarthestBodyTurn = 2;
/// Largest mismatch between a step and a smooth motion, as a fraction of the step's change; see Smoothness in
/// step.cpp.
inline constexpr double kSmoothStep = 0.04;
/// The same of the travel of a contact point along a body, and the least travel, relative to the size, that
/// counts as a jump.
inline constexpr double kSmoothTravel = 0.3;
inline constexpr double kLeastJump = 1e-4;
/// Mismatch of a step that is accepted as rounding [rad, of the size].
inline constexpr double kNoMismatch = 1e-9;
/// Jumps of the normal, and of velocities per unit of the path, at a joint of two spans whose directions
/// differ by too little for a corner (kSameJointDirection): of bodies at rest beyond it nothing else is to be
/// seen.
inline constexpr double kTurnOfKink = 2e-7;
inline constexpr double kVelocityOfKink = 1e-6;
/// Drivers that are off the line ahead by no more than this are on it; relative to the driver's scale plus
/// its coordinate.
inline constexpr double kOnLineAhead = 1e-9;
/// Turns that differ from half a turn by less than this count as half a turn [rad].
inline constexpr double kHalfTurn = 1e-3;

// Limits of the motion.

/// A row this near to a limit is at the limit; relative to the driver's scale plus its coordinate.
inline constexpr double kOnLimit = 1e-14;
/// Fraction of the driver's scale: a row this near to a limit is solved for directly, without a step.
inline constexpr double kBesideLimit = 1e-12;
/// Fraction of the driver's scale: a limit this near is reached; what is left is rounding.
inline constexpr double kReachesLimit = 1e-9;
/// Fraction of the driver's scale: nearer to a limit, rates may be too inexact to go on.
inline constexpr double kNearLimit = 1e-6;
/// The same for a pole, where only its position is needed.
inline constexpr double kNearPole = 1e-2;
/// Length of the next step before a limit, as a fraction of what is left to the limit.
inline constexpr double kShareToLimit = 0.5;
/// Relative to the size: bodies and contacts farther away than this may be on their way to infinity.
inline constexpr double kFarAway = 100;
/// Relative to the size: farther out than this the rates of a contact lose their digits.
inline constexpr double kTooFar = 1e4;
/// Fraction of the size: a contact is at infinity if the rounding of its coordinates alone exceeds this, so
/// that its gap cannot be closed.
inline constexpr double kRoundingOfGap = 1e-10;
/// Largest distance of a predicted follower from its limit position, in units of its coordinate [rad, of the
/// size].
inline constexpr double kNearFollowerLimit = 0.3;
/// Lever added for a turning follower, so that it is not 0 if the contact is at its pivot, as a fraction of
/// the size.
inline constexpr double kLeastLever = 1e-3;
/// Limits that are nearer to each other than this fraction of the driver's scale are the same.
inline constexpr double kSameLimit = 1e-9;

// Beyond a limit at which the motion was lost.

/// Spacing of the positions at which a lost branch is looked for, as a fraction of the leading driver's
/// scale.
inline constexpr double kLostBranchProbe = kPi / 576;
/// Positions from which lost coupled bodies are looked for are rounded to multiples of this [rad, of the
/// size]: much more than rounding errors, and much less than any distance that counts.
inline constexpr double kSearchGrid = 1e-6;
/// Largest distance between a pole and the end of the stretch on its other side, as a fraction of the leading
/// driver's scale.
inline constexpr double kAcrossPole = kPi / 144;
/// Shortest first step away from a limit, as a fraction of the driver's scale.
inline constexpr double kNearestBegin = 1e-12;
/// Fraction of the driver's scale: a row this near to where a stretch begins, or could be followed back to,
/// is at its begin.
inline constexpr double kBesideBegin = 1e-6;
/// Relative to a group's lever: a GroupState::sine below this is too near to a limit.
inline constexpr double kTooNearLimit = 1e-6;
/// Relative to the size: contacts farther out than this come from infinity or are about to run off to it.
inline constexpr double kFarOut = 1e6;
/// How far inside a stretch the search for the limit at its begin starts, as a fraction of the driver's
/// scale; for a row at that limit.
inline constexpr double kInsideLimit = 1e-3;

/// Step by which it is tested how things change beyond a position, as a fraction of the distance to the next
/// position.
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
/// Farthest that a body may move within this distance, as an angle or relative to the size: the error of the
/// interpolation is its sixth power.
inline constexpr double kCrossingTurn = 0.012;

// Series through change points. Distances are how far the fastest of a group's bodies moves, as an angle or
// relative to the size.

/// Largest rounding of the last order of a row's series, relative, that is not looked into.
inline constexpr double kRoundingOfSeries = 1e-10;
/// With more rounding than this a series is given only where it does not matter.
inline constexpr double kSpoiltSeries = 1e-6;
/// Farthest change point that is looked for: beyond it no series of moderate order converges.
inline constexpr double kChangePointReach = 0.3;
/// A place this near to where the rank is lost is there; the last step is from a much smaller distance.
inline constexpr double kAtChangePoint = 1e-9;
/// Most steps of Newton's method for it.
inline constexpr int kMostChangePointSteps = 10;
/// Relative to the largest singular value: all but one are above this where branches cross.
inline constexpr double kOneLostRank = 1e-3;
/// Largest share of the last two terms of a series in a derivative beside the change point.
inline constexpr double kLastTerms = 1e-9;
/// Relative to the size: the series of a crossing leads past the row by no more, nor its rates relative to
/// the largest; other branches are farther away.
inline constexpr double kSameBranch = 0.02;
/// Branches that come near each other by more than this, as a violation of the conditions relative to the
/// size, are no matter of rounding, which is this fraction's 1e-7.
inline constexpr double kMeetsNoLonger = 1e-9;
/// Largest share of the conditions' derivatives by a parameter that bodies cannot make up for at the change
/// point.
inline constexpr double kKeepsChangePoint = 1e-9;

// Events.

/// Velocities below this fraction of the step's largest are rounding and do not count as a sense of motion.
inline constexpr double kSlowestOutput = 1e-12;
/// An estimated least speed within a step below this fraction of the speeds at its ends may be a reversal.
inline constexpr double kMayReverse = 0.3;
/// Change points that are nearer to each other than this fraction of the driver's scale are the same.
inline constexpr double kSameChangePoint = 1e-7;

// Reduction of a group's conditions to one equation.

/// Last change of a solution at which Newton's method ends, as a fraction of the size.
inline constexpr double kReductionSettled = 1e-13;
/// Fraction of the size: changes below this fall quadratically; once they do not, they are rounding.
inline constexpr double kReductionNear = 1e-9;
/// Difference steps for second derivatives, as fractions of the size and of the unit of s.
inline constexpr double kReductionDifference = 1e-5;
/// Largest |λ| that is followed, relative to the size.
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
/// Fraction of the size: where lost bodies violate their conditions by no more than this, a solution is next
/// to them.
inline constexpr double kCoupledApproach = 1e-6;
/// In the search for the least violation, for angles [rad] and for places as fractions of the size: the
/// difference step for second derivatives, the last change of the iteration, and the farthest that bodies may
/// be led in one step of the driver.
inline constexpr double kApproachDifference = 1e-6;
inline constexpr double kApproachSettled = 1e-7;
inline constexpr double kFarthestApproach = 4;
/// Most iterations of that search, by Newton's method and by the method of Levenberg and Marquardt.
inline constexpr int kApproachSteps = 6;
inline constexpr int kMostApproachSteps = 200;
/// Relative to the size: bodies that are lost farther out than this are on their way to infinity.
inline constexpr double kCoupledFarOut = 1e3;

// Overlap of bodies.

/// Fraction of the size: an overlap less deep than this is a touch. Ten times the precision to which
/// distances are computed.
inline constexpr double kOverlapDepth = 1e-9;
/// The same for boundaries, which are sampled.
inline constexpr double kOverlapOfBoundaries = 1e-7;
inline constexpr double kOverlapPrecision = kOverlapDepth / 10;

// Where a contact can either go onto a corner or go over to another place that gives the bodies the same
// motion, it is on the corner until the overlap exceeds kOverlapDepth. Rates closer than kSameRates are those
// of such a place, and a corner reached less than kAtCorner before is not reported.
inline constexpr double kSameRates = 1e-6;  // relative to the follower's unit
inline constexpr double kAtCorner = 1e-6;   // relative to the driver's scale

// Places of contacts on boundaries.

/// Fraction of the drivers' unit: a path that leads over a joint of spans by no more ends at the joint.
inline constexpr double kJointAtEnd = 1e-12;
/// A contact this near to the end of a span is at it, as a fraction of the boundary's size; on corners [rad].
inline constexpr double kAtSpanEnd = 1e-6;
/// How far beyond a second contact a step ends, as a fraction of the drivers' unit.
inline constexpr double kBehindSecondContact = 1e-6;
/// Largest distance that a contact runs in a step, relative to what its speeds at both ends suggest.
inline constexpr double kFartherAlong = 2;
/// A place at which bodies cease to touch nearer to the begin of the step than this fraction of the drivers'
/// unit ended there. A place this near to the end of a span, as a fraction of the boundary's size, is at it.
inline constexpr double kJustLeft = 1e-9;
/// Distances beyond a vertex, as fractions of the drivers' unit, at which the motion is tried to go on.
inline constexpr std::array kBeyondVertex = {0.0, 1e-14, 1e-13, 1e-12, 1e-11};
/// A smaller jump of a rate is due to rounded dimensions [1, of the size].
inline constexpr double kNoJump = 1e-9;
/// Relative to the larger of two rates: a rate below this is 0.
inline constexpr double kRateRounding = 1e-12;

/// Distance within which other places are looked for, relative to how far the bodies move against each other
/// by their rates.
inline constexpr double kFartherThanByRates = 1.5;
/// A place this near to the contact, as a fraction of the boundaries' size, is the contact itself.
inline constexpr double kSameMeeting = 1e-6;
/// The same for its normal [rad]: the two sides of a notch are near each other.
inline constexpr double kSameMeetingNormal = 1e-3;
/// Largest mismatch of a followed gap, as a fraction of its change by its rates, for it to belong to the same
/// place.
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
/// Fraction of the size: a pose that is farther from its contact than this starts open.
inline constexpr double kStartsApart = 1e-4;
/// Product of sines below which a normal is that of a sample to within rounding.
inline constexpr double kOnSample = 1e-12;
/// First distance, as a fraction of the drivers' unit, by which a contact that closes next to an end is moved
/// on if the curves do not meet yet.
inline constexpr double kFirstNudge = 1e-13;
/// Far out on open curves, rounding of the common normal shifts contact points along the tangent by this
/// fraction of the radii of curvature.
inline constexpr double kNormalRounding = 4 * std::numeric_limits<double>::epsilon();

// Chains of dyads, many rows at once.

/// Largest ratio of a coordinate to the shortest link. It leaves a link's direction a rounding of 1e-13, so
/// that no residual comes near 1e-9 of the size.
inline constexpr double kFarthestPoint = 1e3;
/// A body whose first angle differs from its pose's by more than this may be half a turn from it, on either
/// side.
inline constexpr double kSureTurn = kPi - 1e-6;
/// Fraction of the size: the direction of a shorter spring is made of rounding, or undefined.
inline constexpr double kShortestSpring = 1e-6;
/// Assemblies whose squared distances from the poses differ by less than this fraction of the size's square
/// are equally near: that whose bodies are turned less is taken.
inline constexpr double kAsNear = 1e-9;
/// Largest distance between a disc and where a Run has put it, as a fraction of the size. The other mode is
/// much farther away.
inline constexpr double kSameChainPlace = 1e-6;

/// A smaller sine is near a limit; steps of a run take a crossing into account from kNearCrossing on.
inline constexpr double kSafeSine = 0.02;
/// A body that turns by more than this from one position to the next might be whole turns off [rad].
inline constexpr double kSafeTurn = 2;
/// How far a contact's force may fall below its values in the rows, as a multiple of their differences.
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

/// Change of slip, in the mechanism's size, by a unit change of a coordinate, below which the coordinate does
/// not matter.
inline constexpr double kNoInfluenceSlip = 1e-9;

/// Largest displacement of a row for differences. Their truncation error, in its eighth power, is below
/// rounding, and rounding is not amplified much.
inline constexpr double kLargestDisplacement = 4e-3;
/// There is a kink or a jump at 0 if the slopes of its two sides differ by more than the sum of these
/// fractions of the fourth difference on the smoother side, of the slopes and of the values.
inline constexpr double kKinkOfBends = 100;
inline constexpr double kKinkOfSlopes = 1e-7;
inline constexpr double kKinkOfValues = 1e-12;
/// Fraction of the step by which a row is displaced to see how fast curvatures change.
inline constexpr double kCurvatureProbe = 1e-3;
/// A step for radii of curvature that is not shorter than this fraction of the step for all else serves both:
/// it costs a digit.
inline constexpr double kMuchShorterStep = 0.1;
/// How much smaller the estimated error of a derivative has to be with the shorter step for it to be taken;
/// that of a kink at 0 is the same with both.
inline constexpr double kWorthShorterStep = 2;
/// An eighth difference above both, relative to the change in a step and to the largest value, may spoil the
/// slope: the former of smooth functions is below, the latter is above rounding.
inline constexpr double kDoubtfulDifference = 1e-5;
inline constexpr double kSureDifference = 1e-10;
/// Relative to the largest value: that of |x| is at most 10, that of random numbers around 60.
inline constexpr double kRoundingDifference = 25;
/// The next shorter step where a slope is doubtful, and how often it is taken.
inline constexpr double kShorterStep = 1.0 / 16;
inline constexpr int kMostShorterSteps = 4;
/// Largest relative disagreement of differences of two orders for dimensions that count as smooth.
inline constexpr double kDimensionsNotSmooth = 1e-6;

/// Difference steps of a parameter that are tried, as fractions of its scale.
inline constexpr std::array kParameterSteps = {1e-3, 1e-4, 1e-5, 1e-7, 1e-9};
/// Disagreement of differences of two orders of boundaries: below the first it is rounding, or so little that
/// the better ones have no other error; above the second it is too much. Changes of boundaries with a
/// parameter below the third count as none.
inline constexpr double kBoundariesAgree = 1e-10;
inline constexpr double kBoundariesDisagree = 1e-8;
inline constexpr double kBoundariesStandStill = 1e-11;

}  // namespace higherpair
