#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>
#include <limits>

// Tolerances of contact analysis. Unless stated otherwise they are relative to what they are compared with:
// to the size of the pair or of the curves, to a radian, or to the unit of a coordinate (a radian, or the
// size).

namespace higherpair {

inline constexpr double kEps = std::numeric_limits<double>::epsilon();

// Limit positions of a follower.

/// Below this, relative to its scale, ∂gap/∂q may belong to a limit position or a change point: the square
/// root of the rounding error of a gap.
inline constexpr double kGapQMayVanish = 1e-7;
/// Below this, relative to its scale, ∂gap/∂q is 0 to within rounding.
inline constexpr double kGapQIsZero = 1e-12;
/// Bounds of the radii of curvature that enter that scale, as fractions of the distances from the pivots.
inline constexpr double kLeastGapScale = 1e-3;
inline constexpr double kMostGapScale = 0.05;

// Steps along a motion.

/// Largest step of a turning driver [rad].
inline constexpr double kLargestTurn = kPi / 18;
/// Shortest step that a coordinate resolves, relative to the sum of its unit and its value.
inline constexpr double kStepResolution = 1e-14;
/// The rest of the path is taken in one step if it is at most this many steps long; avoids a remainder of
/// rounding size.
inline constexpr double kAlmostThere = 1.001;
/// Largest difference between a step's solution and its prediction that is accepted where branches cross and
/// the branch changes, as a fraction of the change in that step: beyond it the step may have jumped to
/// another branch.
inline constexpr double kCrossingAgreement = 0.03;
/// The same for the walk from one contact to another on the same branch.
inline constexpr double kWalkAgreement = 0.1;
/// A difference up to this is always accepted: rounding.
inline constexpr double kInnerMismatch = 1e-9;
/// Cosine of the largest angle by which a contact's normal may turn in one step: 30 degrees.
inline constexpr double kCosFarthestTurn = 0.866;
/// Largest turn of a follower in one inner step [rad].
inline constexpr double kFarthestInnerTurn = 3 * kLargestTurn;
/// Largest deviation, as a fraction of its change, of the measure that vanishes at a change point from the
/// change that its rates predict.
inline constexpr double kSmoothRise = 0.25;
// Shortest steps, relative to the driver's unit, from which the higher derivatives of a prediction are
// estimated: d²φ/du² and d³q/du³; d³φ/du³.
inline constexpr double kShortestForSecond = 1e-14;
inline constexpr double kShortestForThird = 1e-4;
// Longest step that such derivatives serve to predict, relative to the step they were estimated over.
inline constexpr double kFarthestReach = 1e3;
// Largest step that counts as short, relative to the driver's unit.
inline constexpr double kShortTurn = 0.01;

// The osculating iteration.
inline constexpr int kMaxPasses = 12;  // it converges quadratically, mostly within 4
// Largest last step [rad]: what it leaves out is of third order.
inline constexpr double kLastTurn = 1e-8;
// Largest angle that the last step may leave out [rad].
inline constexpr double kLeftOut = kEps / 10;
// Largest tangential distance in a closed contact of nearly straight curves, where rounding of the normal
// moves the points.
inline constexpr double kLargestSlip = 0.01;

// Distances of bodies and the search for a first touch.
inline constexpr double kTouching = 1e-9;  // closer bodies touch: the last iteration starts from there
// Precision of a distance that decides between touching and overlapping.
inline constexpr double kFineGap = 1e-12;
// Precision of a distance that only serves to find a safe step, relative to the distance itself.
inline constexpr double kRoughGap = 0.1;
// Largest displacement, in units of the follower, from a position of near touch to its own contact.
inline constexpr double kSameTouch = 1e-2;
// Displacement, in units of the follower, beyond a contact that is not the wanted one, to search on from
// there.
inline constexpr double kBesideTouch = 1e-6;
inline constexpr double kFreeOverlap = 1e-10;  // overlap, by rounding, of bodies that only touch
inline constexpr double kFinestArc = 1e-15;    // [rad]: shorter arcs of normals are not halved

// Newton's method for the extreme gap: its steps are expected to converge quadratically below this.
inline constexpr double kExtremeQuadratic = 1e-7;

// A difference of vectors shorter than this fraction of them has no direction.
inline constexpr double kDirectionless = 1e-12;

// Algebra of tangency, in 100-digit numbers: these tolerances cover what rounding of the input doubles does
// to exact double roots and exact zeros. It splits a double root by its square root, 1e-8, and a fourfold one
// by its fourth root, 1e-4.

// Largest distance of a root of the contact polynomial from the real position it stands for.
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
// Distance kept from the end of the cone of normals of an open curve, as sin² of the angle.
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
// Size of the adjugate of a matrix, relative to the matrix: below, the matrix is a double line (rank 1).
inline constexpr double kDoubleLine = 1e-5;
// Distance from a tangency below which a point is an exact one.
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
// Largest remainder after dividing by a root, relative to the sum of the coefficients.
inline constexpr long double kRootRest = 1e-70L;
// Distance from the real axis or the unit circle, where roots are asked for, within which a root is refined:
// more than callers accept.
inline constexpr long double kNearbyRoots = 1e-3L;
// Squares of the relative corrections that end the iteration, first in long double, then in 100 digits: roots
// 1e-40 apart are distinct.
inline constexpr long double kRoughlyConvergedSquared = 1e-30L;
inline constexpr double kConvergedSquared = 1e-120;

// Certificates: how far rounding may shift a contact or let contacts change places; how far it splits double
// or fourfold roots.
inline constexpr double kSameRoot = 1e-9;  // a contact of the list and an exact root this close are the same
// Next to another contact this close, rounding decides which of the two is free.
inline constexpr double kCrowded = 1e-12;
// Distance from a contact at a limit within which its root need not be matched; of fourfold roots below.
inline constexpr double kFragile = 1e-5;
inline constexpr double kFragileFourfold = 1e-4;
// Relative rounding of each number of the pair.
inline constexpr double kInputRounding = 0x1p-50;
// Rounding error per radian of the whole turns added to an angle.
inline constexpr double kTurnsRounding = 2e-16;

// tan² of half an angle below which four terms of the arctangent series are exact to within rounding.
inline constexpr double kArcTangentSeries = 1e-5;

// Conforming positions.

// Residual of the condition at a root, relative to size²: larger ones occur where the condition jumps.
inline constexpr double kConformingRoot = 1e-6;
// Positions closer than this are the same: mirror images meet at the edges of their arcs.
inline constexpr double kSameConforming = 1e-7;

// Boundaries.

/// Depth of overlap up to which two bodies still only touch, relative to the sum of the sizes of their
/// boundaries.
inline constexpr double kTouchingDepth = 1e-7;
// How far beside a body, relative to the sizes of both, samples of the other one are examined.
inline constexpr double kBesideBody = 0.1;
// Distance from the foot, relative to the size, at which the search for it ends: the error of the depth is of
// second order in it.
inline constexpr double kNearFoot = 1e-9;
// Least 1 + κ·(distance from the foot) for a whole Newton step: close to the centre of curvature one would
// lead anywhere.
inline constexpr double kLeastFootStretch = 0.1;

// The iteration towards a contact.
inline constexpr double kLongestPass = 0.25;  // longest step of one pass, relative to the size of the pair
// How far a turn takes the contact of two flat parts [sizes per rad]: as far as one pass may go.
inline constexpr double kSlideOfFlats = 1e12;
// Largest turn of the follower, or of the normal at a corner, in one pass [rad].
inline constexpr double kMostTurnOfPass = 0.5;
// Error, relative to the extent, at which the iteration may stall.
inline constexpr double kNoiseOfClosure = 1e-13;
// Follower step, relative to the longest, below which an iteration at the end of a boundary stays there.
inline constexpr double kNoStepAtEnd = 1e-9;
inline constexpr double kAtNormal = 1e-14;  // a point has the wanted normal to within this [rad]

// All contacts, by samples.

// Difference of q [rad, or relative to the size] up to which two contacts are the same ...
inline constexpr double kSameFound = 1e-7;
inline constexpr double kSameFoundPoint = 1e-5;  // ... if their points are as close as this
// A gap at a joint of spans up to this is rounding, relative to the length that stands for a radian.
inline constexpr double kSmoothJoint = 1e-12;
// Rounding error of points of a boundary, relative to its size plus their distance from the pivot, and of
// normals [rad].
inline constexpr double kErrorOfPoints = 8 * kEps;

// Enumeration, relative to the size of the larger boundary.
inline constexpr double kFinestStretch = 1e-8;    // shortest stretch that is halved further, ...
inline constexpr double kCoarsestStretch = 1e-3;  // ... its upper limit where many pairs have been left open
// Largest and smallest distance within which a contact is shown to be the only one.
inline constexpr double kFarthestAround = 0.25;
inline constexpr double kNearestAround = 1e-8;
// Contacts, or undecided ranges, closer than this are reported as one [also rad].
inline constexpr double kOneOpen = 1e-6;

// Places where boundaries are close to each other.
inline constexpr double kSameNearPlace = 1e-7;      // relative to the sizes of both boundaries
inline constexpr double kSameNormalOfPlace = 1e-3;  // [rad]
inline constexpr double kAtFoot = 1e-15;            // relative to the size: a foot is reached

// How far out on open conics and faces contacts are searched for, relative to the distances of points from
// joints. Points much farther out have fewer digits than Newton's method needs.
inline constexpr double kSupportReach = 100;

// Maps.

// Default overlap, relative to the bodies' size, up to which a contact counts as free.
inline constexpr double kDefaultOverlap = 1e-9;
inline constexpr double kCutResolution = 1e-10;  // critical positions closer than this are one cut
// Rounding splits a crossing into two folds as far apart as this.
inline constexpr double kCrossingResolution = 1e-7;
inline constexpr double kSameEventNormal = 1e-6;
// A contact followed back agrees with its start to within this.
inline constexpr double kSameMapContact = 1e-6;
inline constexpr double kNearMapCrossing = 1e-4;  // points closer to a crossing are interpolated
inline constexpr double kMapEndMargin = 1e-9;     // distance of a sample from the end of a branch
// Where a branch ends at a cut, its contact is compared with the events there from these distances, ever
// closer until one event is clearly the nearest. A difference in q and n below kAtEnd is certain, one below
// kSameEnd is accepted at the last distance.
inline constexpr std::array kNearEnd{1e-3, 1e-5, 1e-7, 1e-9, 1e-11};
inline constexpr double kAtEnd = 0.02;
inline constexpr double kSameEnd = 0.3;
// Speed of the follower, in its units per unit of the driver, below which it is at rest but for rounding.
inline constexpr double kSlowestMotion = 1e-12;
inline constexpr double kSlowestOnBoundaries = 1e-11;  // the same for boundaries, whose rates come from spans
// Where intervals and cells are divided, as a fraction: off the middle, which symmetry may make special.
inline constexpr double kOffMiddle = 0.4713;
inline constexpr double kOffMiddleOfFace = 0.37;  // the same for the nodes of a part of a face
// Relative precision of the coordinate at which a contact ceases to be free.
inline constexpr double kBisectedCoordinate = 1e-13;

// Maps of boundaries.
// An event this little below the start of the range belongs to its beginning [rad].
inline constexpr double kAtRangeStart = 1e-7;
inline constexpr double kShortestRest = 1e-4;  // shorter dwells are ignored; in units of the driver
// How far rounding may let u fall along a branch [rad, or relative to the size].
inline constexpr double kBackwards = 1e-8;
// Least κ1 + κ2 that may be 0 but for rounding, relative to 1 / size.
inline constexpr double kNotConcave = 1e-9;

// The surface of all tangencies (TangencySheet).

// Sine of the angle between two slides that count as parallel.
inline constexpr double kParallelSlides = 1e-12;
// Offset of F on the grid, relative to the size: above the rounding of F, too small to change its zeros.
inline constexpr double kGridLifted = 1e-12;
// Largest distance, as a fraction of a part, between the zeros of F with and without that offset for the
// latter to be used.
inline constexpr double kGridBeside = 1e-8;
// Ratio of the speeds at both ends of a part beyond which it is halved. Without that, the last part of a line
// or open conic with an even division would take up nearly all of its length.
inline constexpr double kEvenSpeed = 4;
// Least cosine of the angle between a curve and its chord.
inline constexpr double kStraightSheetCurve = 0.85;
// Chords shorter than this fraction of a cell have no direction.
inline constexpr double kNoChord = 1e-7;
inline constexpr double kMostSheetTurn = 0.3;  // largest turn of a body along a step [rad]

// Rolling: singular values of the Jacobian below this fraction of the largest are 0, as for discs about their
// centres.
inline constexpr double kRollingRank = 1e-9;
// Determinant of the normal equations, relative to their trace squared, above which they have full rank.
inline constexpr double kRollingFullRank = 1e-4;
// Units in the last place of the angles by which a Newton step may be off.
inline constexpr double kRollingUlps = 8;
// Newton steps below this leave only rounding when squared ...
inline constexpr double kRollingSettled = 1e-8;
// ... provided that they shrink at least by this factor, as quadratic steps do.
inline constexpr double kRollingQuadratic = 1e-2;
inline constexpr double kRollingLeast = 1e-15;  // steps up to this count as zero

}  // namespace higherpair
