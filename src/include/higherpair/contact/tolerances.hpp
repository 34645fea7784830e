#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>
#include <limits>

// The tolerances of this room. Without another word they are shares of what they are compared with: of the
// size of the pair or of the curves, of a radian, of a unit of the coordinate (a radian, or the size).

namespace higherpair {

inline constexpr double kEps = std::numeric_limits<double>::epsilon();

// Where a follower's contact is at a limit.

/// ∂gap/∂q of a contact that may be at a limit or where branches cross, relative to its scale: the square
/// root of what rounding leaves of a gap.
inline constexpr double kGapQMayVanish = 1e-7;
/// ∂gap/∂q that is 0 to within rounding, relative to its scale.
inline constexpr double kGapQIsZero = 1e-12;
/// Of the distances from the pivots: between them are the radii of curvature that count in that scale.
inline constexpr double kLeastGapScale = 1e-3;
inline constexpr double kMostGapScale = 0.05;

// Steps along a motion.

/// The largest step of a turning driver [rad].
inline constexpr double kLargestTurn = kPi / 18;
/// The shortest step that a coordinate resolves, of its unit and of itself.
inline constexpr double kStepResolution = 1e-14;
/// Of a step: what is left of a path is taken at once, so that no remainder of rounding size is left.
inline constexpr double kAlmostThere = 1.001;
/// Largest difference between a step's solution and its prediction that is accepted, as a fraction of the
/// change in that step: beyond it the step may have jumped to another branch.
inline constexpr double kStepAgreement = 0.25;
/// The same where the branch changes, because branches cross within the step.
inline constexpr double kCrossingAgreement = 0.03;
/// The same of the walk from a contact to another one on its branch.
inline constexpr double kWalkAgreement = 0.1;
/// A difference that is rounding, whatever the change.
inline constexpr double kInnerMismatch = 1e-9;
/// The cosine of the angle by which a contact's normal may turn in one step: 30 degrees.
inline constexpr double kCosFarthestTurn = 0.866;
/// Turn of a follower that an inner step may turn out to be [rad].
inline constexpr double kFarthestInnerTurn = 3 * kLargestTurn;
/// Of the change of what is 0 where branches cross: how far it may be from what its rates say.
inline constexpr double kSmoothRise = 0.25;
// Of the driver's scale: steps that d²φ/du² and d³q/du³, and d³φ/du³, are taken from.
inline constexpr double kShortestForSecond = 1e-14;
inline constexpr double kShortestForThird = 1e-4;
inline constexpr double kFarthestReach = 1e3;  // of the step that they are from: what they serve to predict
inline constexpr double kShortTurn = 0.01;     // of the driver's scale: a short step

// The osculating iteration.
inline constexpr int kMaxPasses = 12;      // it converges quadratically, mostly within 4
inline constexpr double kLastTurn = 1e-8;  // largest last step [rad]: it leaves out what is of third order
inline constexpr double kLeftOut = kEps / 10;  // angle that the last step may leave out [rad]
inline constexpr double kLargestSlip = 0.01;   // along nearly straight curves, where the normal is rounding

// Distances of bodies and the search for a first touch.
inline constexpr double kTouching = 1e-9;   // nearer bodies touch: the last iteration starts from there
inline constexpr double kFineGap = 1e-12;   // precision of a distance that decides between touch and overlap
inline constexpr double kRoughGap = 0.1;    // of the distance itself, where only a safe step is asked for
inline constexpr double kSameTouch = 1e-2;  // of a unit: so near a touch leads to its own contact
// Of a unit: a start beyond a contact that is not the wanted one.
inline constexpr double kBesideTouch = 1e-6;
inline constexpr double kFreeOverlap = 1e-10;  // overlap of bodies that only touch, by rounding
inline constexpr double kFinestArc = 1e-15;    // [rad]: arcs of normals are not halved below it

// The extreme gap, by Newton's method: its steps below this fall quadratically.
inline constexpr double kExtremeQuadratic = 1e-7;

// A vector that is shorter than this share of what it is the difference of has no direction.
inline constexpr double kDirectionless = 1e-12;

// The algebra of tangency, in numbers of 100 digits: what the rounding of the doubles that go in makes of
// exact double roots and exact zeros. A double root is split by the square root of that rounding, 1e-8, a
// fourfold one by its fourth root, 1e-4.
inline constexpr double kSplitTangency = 1e-4;  // a root of the contact polynomial as near to a real position
inline constexpr double kSplitFoot = 1e-6;      // of the quartic of normals through a pivot
inline constexpr double kOnCurve = 1e-13;       // distance of a point from a curve on which it lies
inline constexpr double kAligned = 1e-5;        // sine of the angle between normals at a double root
inline constexpr double kTwoTangencies = 1e-4;  // squared distance of two that need no closer look
inline constexpr double kNotDefinite = 1e-13;   // eigenvalue of a semidefinite matrix
inline constexpr double kSameCurvature = 1e-7;  // difference of curvatures that conform
inline constexpr double kOnAxis = 1e-14;        // distance of a pivot from an axis, or of a foot from a pivot
inline constexpr double kFarthestNormal = 1e-12;  // how far from the end of an open curve's cone: sin² of it
// Points farther off than this are at infinity: curves that near their asymptotes touch 1e-14 rad away from
// where those are parallel, so that rounding of the numbers decides whether they do.
inline constexpr double kFarthestFinite = 1e7;
// The square of a size below 1e-50 is lost in the digits of the numbers here, and the curve is a point to
// them. One of 1e-40 of the length is not, and moves no contact in the digits of a double.
inline constexpr double kSmallestConic = 1e-40;
inline constexpr double kLongestRefinement = 1e-4;  // of a tangency that an equation has given roughly
inline constexpr double kNoRefinement = 1e-60;      // a step that is none
inline constexpr double kDoubleLine = 1e-5;         // size of the adjugate, of the matrix: of rank 1
inline constexpr double kExactTangency = 1e-18;     // distance from being one
inline constexpr double kSameTangency = 1e-36;      // squared distance of two that are one, found twice
inline constexpr double kNoiseOfZero = 1e-30;       // of the 100 digits those below are noise of an exact 0

// Roots of polynomials, in the same numbers.
inline constexpr long double kNegligibleCoefficient = 1e-80L;  // of the largest
inline constexpr long double kRoundingOfTerms = 1e-95L;        // of a sum of products, of their sizes
inline constexpr long double kRootRest = 1e-70L;  // of the sum of the coefficients: what a root leaves
// To where roots are asked for: those that others take to be there.
inline constexpr long double kNearbyRoots = 1e-3L;
// Squares of the relative corrections that end the iteration, in numbers of the machine and then in these:
// roots that are 1e-40 apart are two.
inline constexpr long double kRoughlyConvergedSquared = 1e-30L;
inline constexpr double kConvergedSquared = 1e-120;

// Certificates: rounding may exchange contacts, split double roots, or move triple ones, by this.
inline constexpr double kSameRoot = 1e-9;  // list and exact root mean the same contact
inline constexpr double kCrowded = 1e-12;
inline constexpr double kFragile = 1e-5;
inline constexpr double kFragileFourfold = 1e-4;
inline constexpr double kInputRounding = 0x1p-50;
inline constexpr double kTurnsRounding = 2e-16;  // of whole turns that are added to an angle

// tan² of half an angle below which four terms of the series are the arc tangent to within rounding.
inline constexpr double kArcTangentSeries = 1e-5;

// Conforming positions.
inline constexpr double kConformingRoot = 1e-6;  // of the size²: more is left where the condition jumps
inline constexpr double kSameConforming = 1e-7;  // mirror images meet at the edges of their arcs

// Boundaries.

/// A depth of two bodies in each other that is none, of the sizes of their boundaries together.
inline constexpr double kTouchingDepth = 1e-7;
inline constexpr double kBesideBody = 0.1;  // of the sizes: how far beside a body samples are looked at
// Of the size: so near a foot its depth is off by the square of that.
inline constexpr double kNearFoot = 1e-9;
// Near the center of curvature a whole step would go anywhere.
inline constexpr double kLeastFootStretch = 0.1;

// The iteration towards a contact.
inline constexpr double kLongestPass = 0.25;      // of the size of a pair: step of one pass
inline constexpr double kMostTurnOfPass = 0.5;    // of a follower or a corner's normal in one pass [rad]
inline constexpr double kNoiseOfClosure = 1e-13;  // of the extent: what an error may stall at
inline constexpr double kNoStepAtEnd = 1e-9;  // of the longest step of q: it stays at the end of a boundary
inline constexpr double kAtNormal = 1e-14;    // a place with the normal that is asked for [rad]

// All contacts, by samples or by pieces.
inline constexpr double kSameFound = 1e-7;       // of q [rad, or of the size]: two that are one
inline constexpr double kSameFoundPoint = 1e-5;  // and of their points
/// How far a curve may pass beside the straight part between two of its points, of the part's length.
inline constexpr double kSlackOfPart = 0.25;
inline constexpr double kSlackOfChord = 0.25;      // of a piece: how far its curve may leave the chord
inline constexpr double kSlackOfNormal = 0.5;      // the same of its normals
inline constexpr double kRoundingOfNormal = 1e-9;  // added to the chords of cones of normals that are opposed
// Of the length of a radian: a gap at a joint that is rounding.
inline constexpr double kSmoothJoint = 1e-12;
// Rounding of places of a boundary, of its size and their distance from the pivot, and of normals [rad].
inline constexpr double kErrorOfPoints = 8 * kEps;

// The enumeration, of the larger boundary's size:
inline constexpr double kFinestStretch = 1e-8;    // stretches that are not halved any more, ...
inline constexpr double kCoarsestStretch = 1e-3;  // ... where much has been left open before
inline constexpr double kFarthestAround = 0.25;   // how far from a contact it may be seen to be the only one
inline constexpr double kNearestAround = 1e-8;
inline constexpr double kOneOpen = 1e-6;  // contacts that merge, or what is left open, told as one [also rad]

// Places where boundaries are near each other.
inline constexpr double kSameNearPlace = 1e-7;      // of the sizes
inline constexpr double kSameNormalOfPlace = 1e-3;  // [rad]
inline constexpr double kAtFoot = 1e-15;            // of the size

// Of the distances of points from joints: how far out on open conics and faces contacts are looked for. Much
// farther out places have fewer digits than Newton's method asks for.
inline constexpr double kSupportReach = 100;

// Maps.
inline constexpr double kDefaultOverlap = 1e-9;  // of a contact that counts as free, where none is asked for
inline constexpr double kCutResolution = 1e-10;  // critical positions nearer than this are one cut
inline constexpr double kCrossingResolution = 1e-7;  // rounding makes two folds of a crossing, as far apart
inline constexpr double kSameEventNormal = 1e-6;
inline constexpr double kSameMapContact = 1e-6;   // a contact that is followed comes back to itself
inline constexpr double kNearMapCrossing = 1e-4;  // nearer to a crossing points are interpolated
inline constexpr double kMapEndMargin = 1e-9;     // a sample keeps this distance from the end of a branch
// How near to a cut it is looked where a branch ends: nearer until one end is nearest. kAtEnd from it in q
// and n is near enough to be sure, kSameEnd to be accepted at all.
inline constexpr std::array kNearEnd{1e-3, 1e-5, 1e-7, 1e-9, 1e-11};
inline constexpr double kAtEnd = 0.02;
inline constexpr double kSameEnd = 0.3;
// Of the follower's unit for one of the driver: slower is rounding of a follower at rest.
inline constexpr double kSlowestMotion = 1e-12;
inline constexpr double kSlowestOnBoundaries = 1e-11;  // the same, by the rates of spans
// Where intervals and cells are divided: off the middle, which symmetry may make special.
inline constexpr double kOffMiddle = 0.4713;
inline constexpr double kOffMiddleOfFace = 0.37;      // the same of the nodes of a part of a face
inline constexpr double kBisectedCoordinate = 1e-13;  // where a contact stops being free, of the coordinate

// Maps of boundaries.
// An event so little below the start belongs to the range [rad].
inline constexpr double kAtRangeStart = 1e-7;
inline constexpr double kShortestRest = 1e-4;  // of the driver's unit: a shorter rest is none
// [rad, of the size]: by which u may fall along a branch, by rounding.
inline constexpr double kBackwards = 1e-8;
inline constexpr double kNotConcave = 1e-9;  // of 1 per size: κ1 + κ2 below 0 by rounding

// Sheets of tangencies.
inline constexpr double kParallelSlides = 1e-12;  // sine between two slides that are parallel
// Of the size: above the rounding of F, below what changes its zeros.
inline constexpr double kGridLifted = 1e-12;
inline constexpr double kGridBeside = 1e-8;  // of a part: a zero that is moved so little stays the same
// Speed at one end of a part, of that at the other. Far parts of lines and open conics are halved: of even
// parts the last ones would be nearly all of them.
inline constexpr double kEvenSpeed = 4;
inline constexpr double kStraightSheetCurve = 0.85;  // cosine between a curve and its chord
inline constexpr double kNoChord = 1e-7;             // of a cell: a chord without a direction
inline constexpr double kMostSheetTurn = 0.3;        // of a body along a step [rad]

// Rolling: singular values of the Jacobian below this share are 0, as of discs about their centres.
inline constexpr double kRollingRank = 1e-9;
// Determinant of the normal equations, of their trace squared.
inline constexpr double kRollingFullRank = 1e-4;
inline constexpr double kRollingUlps = 8;          // of angles, that a step of Newton's may be off
inline constexpr double kRollingSettled = 1e-8;    // of a step of Newton's: its square is rounding
inline constexpr double kRollingQuadratic = 1e-2;  // of a step to the one before, where steps square
inline constexpr double kRollingLeast = 1e-15;     // a step that is none

}  // namespace higherpair
