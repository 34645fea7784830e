#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>
#include <limits>

// The tolerances of this room. Lengths are shares of the mechanism's size, steps of a path shares of a unit
// of its drivers (unit_of in step.hpp). The driver's scale is a radian, or the size (driver_scale in
// step.hpp).

namespace higherpair {

// Assemblies and starts.

/// Assemblies as near as this are one [size, rad].
inline constexpr double kSameAssembly = 1e-12;
/// Two positions that differ by less count as the same one [rad], or of the size.
inline constexpr double kSameStanding = 1e-9;
/// Of the size: how far to either side of its start a sliding driver is tried, where it cannot start there.
inline constexpr double kReachOfSlide = 2;

/// Of a group's lever: a start whose sine (see GroupState) is below this counts as singular.
inline constexpr double kSingularStart = 1e-7;
/// Of the unit of the path: Newton's method comes near a singular start only to half the digits.
inline constexpr double kNearSingularStart = 1e-5;
/// Of a unit: how far a contact may be from where it merges with another.
inline constexpr double kNearMerge = 0.3;
/// Speeds, and accelerations, that differ less than by this share are one.
inline constexpr double kSameSpeed = 1e-3;
inline constexpr double kSameAcceleration = 1e-6;

// Steps along a motion.

/// Largest inner step of a driver that slides, of the size; see kLargestTurn for those that turn.
inline constexpr double kLargestSlide = 1.0 / 6;
/// Of the driver's scale: a step longer than this may be shortened, so as not to end at a bad place.
inline constexpr double kLongStep = 0.02;
/// Of the largest step: while a contact is open.
inline constexpr double kOpenShare = 0.2;
/// Turn of a body in one step [rad].
inline constexpr double kFarthestBodyTurn = 2;
/// How far a step may be from a smooth motion, as a share of the change in it; see Smoothness in step.cpp.
inline constexpr double kSmoothStep = 0.04;
/// A mismatch of a step that is nothing but rounding [rad, or of the size].
inline constexpr double kNoMismatch = 1e-9;
/// Off the line ahead by no more than rounding, of a driver's scale and coordinate.
inline constexpr double kOnLineAhead = 1e-9;
/// How far a turn is from half a one that is that [rad].
inline constexpr double kHalfTurn = 1e-3;

// Limits of the motion.

/// A row as near as this to a limit is at the limit itself, of a unit of the drivers.
inline constexpr double kOnLimit = 1e-14;
/// Of the driver's scale: as near before a limit a row needs no step.
inline constexpr double kBesideLimit = 1e-12;
/// Of the driver's scale: as near as this a limit is reached, nothing being left but rounding.
inline constexpr double kReachesLimit = 1e-9;
/// Of the driver's scale: nearer, rates may be too inexact to go on.
inline constexpr double kNearLimit = 1e-6;
/// The same of a pole, of which nothing but its place is needed.
inline constexpr double kNearPole = 1e-2;
/// Of what is left to a limit: the next step.
inline constexpr double kShareToLimit = 0.5;
/// Of the size: a body that is farther may be on its way to infinity.
inline constexpr double kFarAway = 100;
/// Of the size: farther out the rates of a contact lose their digits.
inline constexpr double kTooFar = 1e4;
/// Of the size: more than what gaps are closed to.
inline constexpr double kRoundingOfGap = 1e-10;
/// How far a follower may be guessed from its limit, of a unit of its coordinate.
inline constexpr double kNearFollowerLimit = 0.3;
/// Lever of a follower that touches at its pivot, of the size.
inline constexpr double kLeastLever = 1e-3;
/// Limits as near as this are one, of the driver's scale.
inline constexpr double kSameLimit = 1e-9;

// Beyond a limit at which the motion was lost.

/// Of the leading driver's scale: how far apart the places are at which a branch that was lost is looked for.
inline constexpr double kLostBranchProbe = kPi / 576;
/// The same: how far from a pole another stretch may end that goes on beyond it.
inline constexpr double kAcrossPole = kPi / 144;
/// Of the driver's scale: beside a limit, for the first step from it.
inline constexpr double kNearestBegin = 1e-12;
/// The same: a row at the limit where a stretch begins, or before where it could be followed back to.
inline constexpr double kBesideBegin = 1e-6;
/// GroupState::sine at a limit that is too near, of its lever.
inline constexpr double kTooNearLimit = 1e-6;
/// Of the size: contacts that are about to run off to infinity.
inline constexpr double kFarOut = 1e6;
/// Of the driver's scale: from where a limit with a row is come to.
inline constexpr double kInsideLimit = 1e-3;

/// Of the way between two positions: what is a little ahead.
inline constexpr double kALittleAhead = 1e-4;
/// Of the leading driver's scale.
inline constexpr double kShortestStretch = 1e-9;

// Ends of joints.

/// Of the size: rounding, so that a row may be at the very end.
inline constexpr double kBeyondJointEnd = 1e-12;
/// A joint as near to its end is there, of the size.
inline constexpr double kAtJointEnd = 1e-9;

// Crossings of branches.

/// Of a group's lever: a sine below this is near a crossing.
inline constexpr double kNearCrossing = 1e-3;
/// Of the driver's scale: how far from a crossing of branches positions are regular, and are interpolated
/// from.
inline constexpr double kCrossingReach = 4e-3;

// Events.

/// Velocities below this share of the step's largest are rounding, not a motion whose sense could change.
inline constexpr double kSlowestOutput = 1e-12;
/// Of the speed at the ends of a step: a least one that may be 0 within.
inline constexpr double kMayReverse = 0.3;
/// Of the driver's scale: change points as near as this are one.
inline constexpr double kSameChangePoint = 1e-7;

// Reduction of a group's conditions to one equation.

/// Of the size: last change of a solution.
inline constexpr double kReductionSettled = 1e-13;
/// Of the size: changes below this fall fast, until they are rounding.
inline constexpr double kReductionNear = 1e-9;
/// Of the size and of the unit of s: for second derivatives.
inline constexpr double kReductionDifference = 1e-5;
/// Of the size: how far λ may lead.
inline constexpr double kReductionFarthest = 2;
/// Steps of Newton's method below this fall fast.
inline constexpr double kReductionNearRoot = 1e-7;
/// A step as short as this ends it.
inline constexpr double kReductionNoStep = 1e-15;
/// Of the unit of s: a change point at the end of a step.
inline constexpr double kAtStepEnd = 1e-9;
/// Of the size: an ε that is rounding.
inline constexpr double kCrosses = 1e-13;
/// Of the path: how far the branch may be from a parabola.
inline constexpr double kLimitParabola = 0.04;
/// Of the step: how far a limit may lie ahead.
inline constexpr double kFarAhead = 64;

// Coupled bodies.

/// Largest step of an angle [rad], or of the size.
inline constexpr double kLargestCoupledStep = 0.3;
/// A pivot below this share of the largest one is none.
inline constexpr double kCoupledRank = 1e-10;
/// Determinant, scaled, of a coupled group that has its rank for certain.
inline constexpr double kSurelyPlaced = 1e-9;
/// Determinant, scaled, of a group that is all but singular; its last step and what is left open, of the
/// size.
inline constexpr double kAllButSingular = 1e-6;
inline constexpr double kSingularStep = 1e-6;
inline constexpr double kCoupledClosure = 1e-14;
/// Determinant, scaled, of a coupled group that is rounding.
inline constexpr double kCoupledRounding = 1e-14;
/// Of the size: steps of Newton's method below this fall fast, and conditions are met to this.
inline constexpr double kCoupledNear = 1e-9;
inline constexpr double kCoupledResidual = 1e-9;
/// Of the size: where the conditions of lost bodies are violated no more than this a solution is next to it.
inline constexpr double kCoupledApproach = 1e-6;
/// Changes of angles [rad] and places, of the size: for second derivatives; the last one on the way there;
/// the farthest that a step of the driver may lead.
inline constexpr double kApproachDifference = 1e-6;
inline constexpr double kApproachSettled = 1e-7;
inline constexpr double kFarthestApproach = 4;
/// Steps of Newton's method there, and of the method of Levenberg and Marquardt.
inline constexpr int kApproachSteps = 6;
inline constexpr int kMostApproachSteps = 200;
/// Of the size: bodies that are lost on their way to infinity.
inline constexpr double kCoupledFarOut = 1e3;

// Overlap of bodies.

/// A depth below this is a touch: ten times the precision of the distances that are asked for.
inline constexpr double kOverlapDepth = 1e-9;
/// The same of boundaries, which are looked at in samples.
inline constexpr double kOverlapOfBoundaries = 1e-7;
inline constexpr double kOverlapPrecision = kOverlapDepth / 10;
/// The common normal of bodies that need not touch yet, from which an iteration starts.
inline constexpr double kRoughSeparation = 1e-6;

// A contact that goes onto a corner where it could go over to another place, which moves the bodies in the
// same manner, is on the corner for as long as a touch cannot be told from a depth of kOverlapDepth.
inline constexpr double kSameRates = 1e-6;  // of the follower's unit
inline constexpr double kAtCorner = 1e-6;   // of the driver's scale

// Places of contacts on boundaries.

/// A contact as near as this to the end of a span has come there, of the boundary's size; on corners [rad].
inline constexpr double kAtSpanEnd = 1e-6;
/// Of the drivers' unit: how far a step leads behind a second contact.
inline constexpr double kBehindSecondContact = 1e-6;
/// What a contact runs at most, of what its speeds at both ends of a step make likely.
inline constexpr double kFartherAlong = 2;
/// Of a unit of the drivers: a place that ended where the step begins.
inline constexpr double kJustLeft = 1e-9;
/// The same: where it goes on beyond a vertex.
inline constexpr std::array kBeyondVertex = {0.0, 1e-14, 1e-13, 1e-12, 1e-11};
/// A jump of a rate that is that of a mechanism whose dimensions are rounded.
inline constexpr double kNoJump = 1e-9;
/// Of a rate: another one that is 0.
inline constexpr double kRateRounding = 1e-12;

/// What is looked at for other places, of how far the bodies move against each other by their rates.
inline constexpr double kFartherThanByRates = 1.5;
/// Of the boundaries: a place that is that of the contact.
inline constexpr double kSameMeeting = 1e-6;
/// The same of its normal [rad]: the sides of a notch are near each other.
inline constexpr double kSameMeetingNormal = 1e-3;
/// Of the change by rates: a gap that may be that of the same place.
inline constexpr double kGapAgrees = 0.1;
/// Of a gap: a least one within the step that may be none in truth.
inline constexpr double kWorthALook = 0.5;

// Gaps and residuals.

/// A gap that is 0 to within rounding.
inline constexpr double kClosedGap = 1e-14;
/// Of the size: how far beside an end a curve still meets the other one.
inline constexpr double kCapture = 1e-3;
/// Of the size: of a body that is moved onto its contact.
inline constexpr double kFarthestShift = 5e-3;
/// Of the size: a pose that touches only by that much is open.
inline constexpr double kStartsApart = 1e-4;
/// Product of sines: a normal that is a sample's but for rounding.
inline constexpr double kOnSample = 1e-12;
/// Of a step: a contact that closes beside an end begins farther in.
inline constexpr double kFirstNudge = 1e-13;
/// Of the radii of curvature: far out on open curves a rounding of the common normal shifts points of contact
/// by this along the tangent.
inline constexpr double kNormalRounding = 4 * std::numeric_limits<double>::epsilon();

// Chains of dyads, many rows at once.

/// Coordinates this many times as long as a link leave its direction 1e-13 of rounding: no residual comes
/// near 1e-9 of the size then.
inline constexpr double kFarthestPoint = 1e3;
/// A body that starts as far from its pose's angle may be half a turn from it, on either side.
inline constexpr double kSureTurn = kPi - 1e-6;
/// Of the size: a spring shorter than this has a direction made of rounding, or none.
inline constexpr double kShortestSpring = 1e-6;
/// Assemblies whose distances from the poses differ by less than this share are as near as each other.
inline constexpr double kAsNear = 1e-9;
/// Of the size: how far a disc may be from where a Run has put it. The other mode is much farther away.
inline constexpr double kSameChainPlace = 1e-6;

/// A sine smaller than this is near a limit; steps of a run take a crossing into account from kNearCrossing
/// on.
inline constexpr double kSafeSine = 0.02;
/// A body that turns further from one position to the next might be whole turns off [rad].
inline constexpr double kSafeTurn = 2;
/// Of the differences of a contact's forces: how far the force may fall below its rows.
inline constexpr double kForceDip = 0.5;
inline constexpr double kForceDipAtEnd = 4;

/// Ellipses this slender (q = 1 - e²) are nearly parabolas: their centres are too far away to say where the
/// vertex is.
inline constexpr double kSlenderestOval = 1e-2;
/// Turn of body or normal that a pass may guess [rad].
inline constexpr double kFarthestOvalGuess = 0.4;
/// Of the size: from a gap this small one more pass reaches rounding, as the curvature is known well enough.
inline constexpr double kOvalsArrived = 1e-12;
/// |∂gap/∂q| of the arm of the contact, below which it is near a limit.
inline constexpr double kLeastOvalSine = 0.02;
/// Of the path from row to row: where it changes by more, third derivatives are not taken from three rows.
inline constexpr double kUnevenRows = 1e-3;

// Derivatives by dimensions.

/// Slip, in the mechanism's size, by a unit change of a coordinate: one that does not matter.
inline constexpr double kNoInfluenceSlip = 1e-9;

/// Largest displacement of a row for differences: what they leave, of its eighth power, is below rounding,
/// and rounding is not enlarged much.
inline constexpr double kLargestDisplacement = 4e-3;
/// By so much more than what the smoother side bends are slopes of both sides apart where there is a kink or
/// a jump; and by so much of themselves, and their changes of the values, at least.
inline constexpr double kKinkOfBends = 100;
inline constexpr double kKinkOfSlopes = 1e-7;
inline constexpr double kKinkOfValues = 1e-12;
/// Of the step: how far the radii of curvature are looked at.
inline constexpr double kRadiiProbe = 1e-3;
/// Share by which differences of two orders may disagree before the dimensions count as not smooth.
inline constexpr double kDimensionsNotSmooth = 1e-6;

/// Steps of a parameter, of its scale.
inline constexpr std::array kParameterSteps = {1e-3, 1e-4, 1e-5, 1e-7, 1e-9};
/// Disagreement of differences of two orders of boundaries that is rounding, or so little that the better
/// ones have no other error. Disagreement that is too much. And a change of them with a parameter that is
/// none.
inline constexpr double kBoundariesAgree = 1e-10;
inline constexpr double kBoundariesDisagree = 1e-8;
inline constexpr double kBoundariesStandStill = 1e-11;

}  // namespace higherpair
