#pragma once

#include "higherpair/contact/gap_scale.hpp"
#include "higherpair/geometry/newton.hpp"

#include <array>
#include <limits>

// The tolerances of this room. Without another word they are shares of what they are compared with: of the
// size of the pair or of the curves, of a radian, of a unit of the coordinate (a radian, or the size). Those
// of steps along a motion are beside the code that follows it.

namespace higherpair {

inline constexpr double kEps = std::numeric_limits<double>::epsilon();

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
inline constexpr double kBesideTouch =
    1e-6;  // of a unit: a start beyond a contact that is not the wanted one
inline constexpr double kFreeOverlap = 1e-10;  // overlap of bodies that only touch, by rounding
inline constexpr double kFinestArc = 1e-15;    // [rad]: arcs of normals are not halved below it

// A vector that is shorter than this share of what it is the difference of has no direction.
inline constexpr double kNoDirection = 1e-12;

// The algebra of tangency, in numbers of 100 digits: what the rounding of the doubles that go in makes of
// exact double roots and exact zeros. A double root is split by the square root of that rounding, 1e-8, a
// fourfold one by its fourth root, 1e-4.
inline constexpr double kSplitTangency = 1e-4;  // a root of the contact polynomial as near to a real position
inline constexpr double kSplitFoot = 1e-6;      // of the quartic of normals through a pivot
inline constexpr double kSplitCrossing = 1e-3;  // of the quartic of two conics' common points
inline constexpr double kOnCurve = 1e-13;       // distance of a point from a curve on which it lies
inline constexpr double kAligned = 1e-5;        // sine of the angle between normals at a double root
inline constexpr double kTwoTangencies = 1e-4;  // squared distance of two that need no closer look
inline constexpr double kTwoPoints = 1e-2;      // distance of two common points that need none
inline constexpr double kNotDefinite = 1e-13;   // eigenvalue of a semidefinite matrix
inline constexpr double kSameCurvature = 1e-7;  // difference of curvatures that conform
inline constexpr double kOnAxis = 1e-14;        // distance of a pivot from an axis, or of a foot from a pivot
inline constexpr double kFarthestNormal = 1e-12;  // how far from the end of an open curve's cone: sin² of it

// Certificates: rounding may exchange contacts, split double roots, or move triple ones, by this.
inline constexpr double kSameRoot = 1e-9;  // list and exact root mean the same contact
inline constexpr double kCrowded = 1e-12;
inline constexpr double kFragile = 1e-5;
inline constexpr double kFragileFourfold = 1e-4;
inline constexpr double kInputRounding = 0x1p-50;

// Conforming positions.
inline constexpr double kConformingRoot = 1e-6;  // of the size²: more is left where the condition jumps
inline constexpr double kSameConforming = 1e-7;  // mirror images meet at the edges of their arcs

// Maps.
inline constexpr double kCutResolution = 1e-10;      // critical positions nearer than this are one cut
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

// Rolling: singular values of the Jacobian below this share are 0, as of discs about their centres.
inline constexpr double kRollingRank = 1e-9;

}  // namespace higherpair
