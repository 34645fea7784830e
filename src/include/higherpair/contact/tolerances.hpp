#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>
#include <limits>

// Tolerances of contact analysis. Unless stated otherwise they are relative to what they are compared with:
// to the size of the pair or of the curves, to a radian, or to the unit of a coordinate (a radian, or the
// size). The coordinate of the driver is u, that of the follower q; n is the common normal of the two curves
// and φ its angle.

namespace higherpair {

inline constexpr double kEps = std::numeric_limits<double>::epsilon();

// Limit positions of a follower.

/// If |∂gap/∂q|, relative to its scale, is below this, the contact may be at a limit position or a change
/// point: the square root of the rounding error of a gap.
inline constexpr double kGapQMayVanish = 1e-7;
/// Values of |∂gap/∂q| below this, relative to its scale, are 0 to within rounding.
inline constexpr double kGapQIsZero = 1e-12;
/// That scale is made of the distances of the contact from the pivots and of the radii of curvature. Bounds
/// of the latter, as fractions of those distances.
inline constexpr double kLeastGapScale = 1e-3;
inline constexpr double kMostGapScale = 0.05;

// Steps along a motion.

/// Largest step of a turning driver [rad].
inline constexpr double kLargestTurn = kPi / 18;
/// Shortest step that changes a coordinate by more than rounding, relative to the sum of its unit and its
/// value.
inline constexpr double kStepResolution = 1e-14;
/// The rest of the path is taken in one step if it is at most this many steps long; avoids a remainder of
/// rounding size.
inline constexpr double kAlmostThere = 1.001;
/// Largest difference between a step's solution and its prediction, as a fraction of the change in that step,
/// where branches cross: with more, the step may have jumped to another branch.
inline constexpr double kCrossingAgreement = 0.03;
/// The same when one contact is followed to another on the same branch.
inline constexpr double kWalkAgreement = 0.1;
/// A difference up to this is always accepted: rounding.
inline constexpr double kInnerMismatch = 1e-9;
/// Cosine of the largest angle by which a contact's normal may turn in one step: 30 degrees.
inline constexpr double kCosFarthestTurn = 0.866;
/// Largest turn of a follower in one inner step [rad].
inline constexpr double kFarthestInnerTurn = 3 * kLargestTurn;
/// The measure that vanishes at a change point must change in a step as its rates predict, to within this
/// fraction of the change: else it has turned back, and the branch does not cross another one.
inline constexpr double kSmoothRise = 0.25;
// Shortest steps, relative to the driver's unit, from which the higher derivatives for a prediction are
// estimated: kShortestForSecond for d²φ/du² and d³q/du³, kShortestForThird for d³φ/du³.
inline constexpr double kShortestForSecond = 1e-14;
inline constexpr double kShortestForThird = 1e-4;
// Longest step that is predicted by such derivatives, relative to the step from which they were estimated.
inline constexpr double kFarthestReach = 1e3;
// Longest step, relative to the driver's unit, whose prediction includes d³φ/du³; with it, a jump of the
// normal in a longer step could seem to agree.
inline constexpr double kShortTurn = 0.01;

// The osculating iteration.
inline constexpr int kMaxPasses = 12;  // it converges quadratically, mostly within 4
// Largest turn in the last pass [rad]: its error is of third order.
inline constexpr double kLastTurn = 1e-8;
// Largest error that the last pass may leave [rad].
inline constexpr double kLeftOut = kEps / 10;
// Largest tangential distance in a closed contact of nearly straight curves, where rounding of the normal
// moves the points.
inline constexpr double kLargestSlip = 0.01;

// Distances of bodies and the search for a first touch.
inline constexpr double kTouching = 1e-9;  // closer bodies touch: their contact is then solved for
// Least distance by which a step of the search approaches or leaves the other body, so that the search gets
// to kTouching in a few steps although each step is safe.
inline constexpr double kLeastApproach = 0.1 * kTouching;
// Distance of the bodies in a contact found from there: with more, or with a deeper overlap, they overlap at
// another place.
inline constexpr double kStillTouching = 10 * kTouching;
// Precision of a distance that decides between touching and overlapping.
inline constexpr double kFineGap = 1e-12;
// Precision of a distance that only serves to find a safe step, relative to the distance itself.
inline constexpr double kRoughGap = 0.1;
// Largest displacement, in units of the follower, from a position in which the bodies nearly touch to the
// contact that belongs to it.
inline constexpr double kSameTouch = 1e-2;
// Where a contact is not the wanted one, the search continues from this far beyond it, in units of the
// follower.
inline constexpr double kBesideTouch = 1e-6;
inline constexpr double kFreeOverlap = 1e-10;  // overlap, by rounding, of bodies that only touch
inline constexpr double kFinestArc = 1e-15;    // [rad]: shorter arcs of normals are not halved
// Arcs of normals up to this are taken to have no narrower part if the slope of the gap seems to rise
// throughout [rad].
inline constexpr double kNarrowArc = 1e-4;
// Rounding error of that slope, as a fraction of the distances of the two points from the origin.
inline constexpr double kRoundingOfSlope = 8 * kEps;

// Newton's method for the extreme gap: once steps are shorter than this, they are expected to converge
// quadratically; when they no longer do, what is left is rounding.
inline constexpr double kExtremeQuadratic = 1e-7;

// A difference of vectors shorter than this fraction of them has no direction.
inline constexpr double kDirectionless = 1e-12;

// Algebra of tangency, in 100-digit numbers: the computation itself has no rounding to speak of, but the
// input numbers are rounded to doubles, 1e-16. That turns exact zeros into small numbers and moves the parts
// of a double root apart by its square root, 1e-8, those of a fourfold root by its fourth root, 1e-4.

// Largest distance of a complex root of the contact polynomial from a real position, for it to be a split
// root at that position.
inline constexpr double kSplitTangency = 1e-4;
inline constexpr double kSplitFoot = 1e-6;  // the same for the quartic of the normals through a pivot
inline constexpr double kOnCurve = 1e-13;   // distance of a point from a curve on which it lies
inline constexpr double kAligned = 1e-5;    // sine of the angle between normals at a double root
// Squared distance beyond which two tangencies are distinct without a closer look.
inline constexpr double kTwoTangencies = 1e-4;
inline constexpr double kNotDefinite = 1e-13;   // negative eigenvalue, by rounding, of a semidefinite matrix
inline constexpr double kSameCurvature = 1e-7;  // largest difference of two curvatures that count as equal
// Distance of a pivot from an axis, or of a foot from a pivot, that counts as zero.
inline constexpr double kOnAxis = 1e-14;
// Distance that normals keep from the end of the cone of normals of an open curve, its asymptote, as sin² of
// the angle.
inline constexpr double kFarthestNormal = 1e-12;
// Points beyond this distance count as points at infinity. Curves that approach their asymptotes touch there
// within 1e-14 rad of the position in which the asymptotes are parallel: rounding of the input decides
// whether they do.
inline constexpr double kFarthestFinite = 1e7;
// Least size of a conic, relative to the length of the problem. The square of a size below 1e-50 is lost in
// the 100 digits, and the curve becomes a point; enlarging a curve to 1e-40 moves no contact by a digit of a
// double.
inline constexpr double kSmallestConic = 1e-40;
// Longest step in refining a tangency that an equation gives roughly.
inline constexpr double kLongestRefinement = 1e-4;
inline constexpr double kNoRefinement = 1e-60;  // shorter refining steps count as zero
// A conic's matrix whose adjugate is smaller than this, relative to the matrix, is a double line (rank 1).
inline constexpr double kDoubleLine = 1e-5;
// Distance below which a point that has been refined is an exact tangency.
inline constexpr double kExactTangency = 1e-18;
// Squared distance below which two tangencies are the same one, found twice.
inline constexpr double kSameTangency = 1e-36;
// Smaller results of the 100-digit arithmetic are noise of an exact 0.
inline constexpr double kNoiseOfZero = 1e-30;

// Roots of polynomials, in the same numbers.

// Coefficients below this fraction of the largest count as 0.
inline constexpr long double kNegligibleCoefficient = 1e-80L;
// Rounding error of a sum of products, relative to the sum of their sizes.
inline constexpr long double kRoundingOfTerms = 1e-95L;
// The same in long double, and the largest radius of a disc about a root found in it that is good enough.
inline constexpr long double kRoughRounding = 2e-17L;
inline constexpr long double kSharpRoot = 1e-12L;
// Largest remainder after dividing by a root, relative to the sum of the coefficients.
inline constexpr long double kRootRest = 1e-70L;
// Distance from the real axis or the unit circle, where roots are asked for, within which a root is refined:
// more than callers accept.
inline constexpr long double kNearbyRoots = 1e-3L;
// Squares of the relative corrections that end the iteration, first in long double, then in 100 digits: roots
// 1e-40 apart are distinct.
inline constexpr long double kRoughlyConvergedSquared = 1e-30L;
inline constexpr double kConvergedSquared = 1e-120;

// Free contacts from rough roots. At a root the bodies touch, or are clearly apart or overlap, by this
// fraction of the size of their curves: next to an asymptote, where normals end early (kFarthestNormal),
// their distance is known to 1e-3 of it only.
inline constexpr double kClearGap = 1e-2;
inline constexpr double kClearTurn = 1e-4;     // by so much asymptotes cross that clearly cross [rad]
inline constexpr double kClearlyMoves = 1e-3;  // least |∂gap/∂q| of such a contact, relative to the lever
inline constexpr double kClearlyFinite = 1e6;  // its farthest point, in units of the problem

// Certificates: a list of contacts is compared with the exact roots of the contact polynomial. Rounding may
// shift contacts, exchange close ones, and split double and fourfold roots.
inline constexpr double kSameRoot = 1e-9;  // a contact of the list and an exact root this close are the same
// Next to another contact this close, rounding decides which of the two is free.
inline constexpr double kCrowded = 1e-12;
// Exact roots within this distance from a contact at a limit need no contact of their own: they may be parts
// of its split root. The second is for fourfold roots.
inline constexpr double kFragile = 1e-5;
inline constexpr double kFragileFourfold = 1e-4;
// Relative rounding of each number of the pair.
inline constexpr double kInputRounding = 0x1p-50;
// Rounding error per radian of the whole turns added to an angle.
inline constexpr double kTurnsRounding = 2e-16;

// tan² of half an angle below which four terms of the arctangent series are exact to within rounding.
inline constexpr double kArcTangentSeries = 1e-5;

// Conforming positions.

// Largest residual of the condition at a root, relative to size²: with more, the condition does not vanish
// but jumps.
inline constexpr double kConformingRoot = 1e-6;
// Positions closer than this are the same: each is found once for an arc and once for its mirror image if it
// is at the edge of both.
inline constexpr double kSameConforming = 1e-7;

// Boundaries.

/// Depth of overlap up to which two bodies still only touch, relative to the sum of the sizes of their
/// boundaries.
inline constexpr double kTouchingDepth = 1e-7;
// How far beside a body, relative to the sizes of both, samples of the other one are examined.
inline constexpr double kBesideBody = 0.1;
// The search for the foot of a point on a boundary ends this close to it, relative to the size: the error of
// the depth is of second order in this.
inline constexpr double kNearFoot = 1e-9;
// Newton's steps towards the foot are taken in full if 1 + κ·(distance from the foot) is above this: near the
// centre of curvature, where it is 0, they would lead anywhere.
inline constexpr double kLeastFootStretch = 0.1;

// The iteration towards a contact.
inline constexpr double kLongestPass = 0.25;  // longest step of one pass, relative to the size of the pair
// How far a turn moves the contact along two flat parts [sizes per rad]: it would be infinite, so that any
// turn moves it as far as one pass may.
inline constexpr double kSlideOfFlats = 1e12;
/// Two flats at a smaller angle are parallel [rad]: what rounding leaves of the angle of two normals.
inline constexpr double kParallelFlats = 8 * kEps;
// Largest turn of the follower, or of the normal at a corner, in one pass [rad].
inline constexpr double kMostTurnOfPass = 0.5;
// An iteration that no longer converges has succeeded if its error is below this, relative to the extent.
inline constexpr double kNoiseOfClosure = 1e-13;
// An iteration that rests at the end of a boundary finds no contact if the follower's step is below this,
// relative to the longest.
inline constexpr double kNoStepAtEnd = 1e-9;
inline constexpr double kAtNormal = 1e-14;  // a point has the wanted normal to within this [rad]

// All contacts, by samples.

// Difference of q [rad, or relative to the size] up to which two contacts are the same ...
inline constexpr double kSameFound = 1e-7;
inline constexpr double kSameFoundPoint = 1e-5;  // ... if their points are as close as this
// Gaps between spans at a joint up to this are rounding, relative to the length that corresponds to a radian.
inline constexpr double kSmoothJoint = 1e-12;
// Rounding error of points of a boundary, relative to its size plus their distance from the pivot, and of
// normals [rad].
inline constexpr double kErrorOfPoints = 8 * kEps;

// Enumeration, relative to the size of the larger boundary.
inline constexpr double kFinestStretch = 1e-8;  // stretches of boundaries are halved down to this length, ...
inline constexpr double kCoarsestStretch = 1e-3;  // ... or only to this where many pairs remain undecided
// Largest and smallest distance around a contact within which it is tried to prove that there is no other.
inline constexpr double kFarthestAround = 0.25;
inline constexpr double kNearestAround = 1e-8;
// Undecided pairs of stretches closer than this are reported as one [also rad].
inline constexpr double kOneOpen = 1e-6;

// Places where boundaries are close to each other.
inline constexpr double kSameNearPlace = 1e-7;      // relative to the sizes of both boundaries
inline constexpr double kSameNormalOfPlace = 1e-3;  // [rad]
inline constexpr double kAtFoot = 1e-15;            // relative to the size: a foot is reached

// How far out on open conics and faces contacts are searched for, relative to the sizes of the curves and
// their distances from the joints. Points much farther out have fewer digits than Newton's method needs.
inline constexpr double kSupportReach = 100;

// Maps.

// Default overlap, relative to the bodies' size, up to which a contact counts as free.
inline constexpr double kDefaultOverlap = 1e-9;
inline constexpr double kCutResolution = 1e-10;  // critical positions closer than this are one cut
// Critical positions up to this far apart may be one: rounding splits a crossing into two folds (limits).
inline constexpr double kCrossingResolution = 1e-7;
inline constexpr double kSameEventNormal = 1e-6;
// A contact that has been followed to the middle of another interval is that contact listed there with which
// it agrees to within this.
inline constexpr double kSameMapContact = 1e-6;
inline constexpr double kNearMapCrossing = 1e-4;  // points closer to a crossing are interpolated
inline constexpr double kMapEndMargin = 1e-9;     // distance of a sample from the end of a branch
// A branch that ends at a critical position is followed to these distances from it, one after another, until
// its contact is clearly nearest to one of the events there: it differs in q and n by less than kAtEnd. At
// the last distance kSameEnd is enough.
inline constexpr std::array kNearEnd{1e-3, 1e-5, 1e-7, 1e-9, 1e-11};
inline constexpr double kAtEnd = 0.02;
inline constexpr double kSameEnd = 0.3;
// Below this speed, in its units per unit of the driver, the follower is at rest.
inline constexpr double kSlowestMotion = 1e-12;
inline constexpr double kSlowestOnBoundaries = 1e-11;  // the same for boundaries, whose rates come from spans
// Intervals and cells are divided at this fraction, not in the middle, where symmetric curves often have
// special positions.
inline constexpr double kOffMiddle = 0.4713;
inline constexpr double kOffMiddleOfFace = 0.37;  // the same for the nodes of a part of a face
// Relative precision of the coordinate at which a contact ceases to be free.
inline constexpr double kBisectedCoordinate = 1e-13;

// Maps of boundaries.
// An event less than this below the start of the range belongs to the start [rad].
inline constexpr double kAtRangeStart = 1e-7;
inline constexpr double kShortestRest = 1e-4;  // shorter dwells are ignored; in units of the driver
// u increases along a branch; rounding may let it decrease by up to this [rad, or relative to the size].
inline constexpr double kBackwards = 1e-8;
// Opposed curves with κ1 + κ2 below minus this, relative to 1 / size, overlap beside their contact.
inline constexpr double kNotConcave = 1e-9;

// The surface F = 0 of all tangencies of two boundaries (TangencySheet), on a grid of cells.

// Sine of the angle between two slides that count as parallel.
inline constexpr double kParallelSlides = 1e-12;
// Added to F at the nodes of the grid, relative to the size, so that no node is exactly on the surface: above
// the rounding of F, too small to change its zeros.
inline constexpr double kGridLifted = 1e-12;
// A zero of F itself, found from that of F with the offset, is used if it is no farther away than this
// fraction of a part of the grid.
inline constexpr double kGridBeside = 1e-8;
// A part is halved if the speeds (arc length per parameter) at its ends differ by more than this factor. With
// parts of equal parameter the last part of a line or open conic would be nearly all of its length.
inline constexpr double kEvenSpeed = 4;
// Least cosine of the angle between a curve and its chord.
inline constexpr double kStraightSheetCurve = 0.85;
// Chords shorter than this fraction of a cell have no direction.
inline constexpr double kNoChord = 1e-7;
inline constexpr double kMostSheetTurn = 0.3;  // largest turn of a body along a step [rad]

// Rolling.

// Singular values of the Jacobian below this fraction of the largest are 0: those of discs that turn about
// their centres, whose contact stays where it is.
inline constexpr double kRollingRank = 1e-9;
// Determinant of the normal equations, relative to their trace squared, above which they have full rank.
inline constexpr double kRollingFullRank = 1e-4;
// Rounding error of a Newton step, in units in the last place of the angles.
inline constexpr double kRollingUlps = 8;
// The iteration ends with a step below this, after which only rounding is left, as the next one is of the
// order of its square ...
inline constexpr double kRollingSettled = 1e-8;
// ... provided that the last step shrank by at least this factor, as in quadratic convergence.
inline constexpr double kRollingQuadratic = 1e-2;
inline constexpr double kRollingLeast = 1e-15;  // steps up to this count as zero

}  // namespace higherpair
