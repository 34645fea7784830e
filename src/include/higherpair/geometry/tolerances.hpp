#pragma once

#include "higherpair/geometry/pose.hpp"

#include <limits>

// The tolerances of this room. Without another word they are shares of what they are compared with: of the
// size of a curve or boundary, of a radian, of the width of a span's parameter.

namespace higherpair {

// Newton's method.

/// Steps below this fall quadratically, in radians and units of length.
inline constexpr double kNewtonQuadratic = 1e-9;
/// Longest step that is taken whole [rad, units of length]: beyond, curves differ from their tangents.
inline constexpr double kNewtonTurn = 0.3;
/// Steps up to this are none, in the same units.
inline constexpr double kNewtonLeast = 1e-17;

/// The root of a function in an interval, of its width: steps below this fall quadratically, or are rounding.
inline constexpr double kNewtonRootNear = 1e-9;
/// How far short of the root it is approached where the function jumps, of the step: more than rounding, and
/// at most.
inline constexpr double kLeastShortOfRoot = 1e-6;
inline constexpr double kMostShortOfRoot = 0.1;

// Angles and arcs.

/// Square of the largest angle, and sine, for which the series in known_rotation.hpp leave out no more than
/// 2e-17.
inline constexpr double kSmallTurn2 = 1e-3;
/// Arc length of a conic: square roots that differ by no more are taken further by series, which leave out
/// less than 1e-16 then.
inline constexpr double kNearlyEqualRoots = 0.01;
/// Of an arc, by quadrature.
inline constexpr double kArcPrecision = 1e-13;

// Conics.

/// What rounding of the six coefficients moves q and d of the form by, of what they consist of.
inline constexpr double kConicNoise = 8 * std::numeric_limits<double>::epsilon();
/// The same of an axis that is given as a unit vector, of its length.
inline constexpr double kUnitAxis = 8 * std::numeric_limits<double>::epsilon();
/// Distance of a centre from a point at which the curve is centred.
inline constexpr double kCentered = 1e-14;
/// Sine between a line and the direction in which it slides along itself.
inline constexpr double kAlongItself = 1e-14;

// The foot of a point on a conic.
inline constexpr double kFarthestMultiplier = 1e18;  // of Lagrange's, of 1 per coefficient
inline constexpr double kFootOffConic = 1e-6;        // value there: on an axis the multiplier does not tell
inline constexpr double kMultiplierSettled = 1e-16;  // last step of it

// Spans and boundaries.

/// Of a radius or a speed, where its bounds are values at places.
inline constexpr double kSpanBoundRounding = 1e-12;
/// Of a derivative, of the sum of its terms' sizes.
inline constexpr double kCoefficientRounding = 1e-13;
/// A part of a span of polynomials turns by no more [rad].
inline constexpr double kLargestPartTurn = 0.1;

/// Between normals at a joint that are one: below what a drawing's digits give [rad].
inline constexpr double kSameJointDirection = 1e-7;
/// Curvatures at a joint that are one: of the curvature, or of 1 per size of the boundary.
inline constexpr double kSameJointCurvature = 1e-9;
/// Of a local parabola: slope of its normal against the axis.
inline constexpr double kSteepestParabola = 1e6;
/// Ends of pieces of a support function that meet, of the reach.
inline constexpr double kSameSupportEnd = 1e-12;

/// How far the normal turns on the edge at an end of an open boundary, away from that of the curve there
/// [rad]: the body is taken to be cut off square, as a face ends at the side of a block. A contact that turns
/// further has slipped off. Less than a quarter turn by what costs a contact some 1e-16 of the driver: for a
/// follower that slides across its face a limit position lies there, and rounding would choose between both.
inline constexpr double kEdgeTurn = kPi / 2 - 1e-8;

// A boundary that crosses itself.
inline constexpr double kChordEndRounding = 1e-9;   // of a chord: its ends belong to it
inline constexpr double kSameCrossingPlace = 1e-6;  // of a span: places that are one, or the end
inline constexpr double kCrossingSettled = 1e-9;    // of a part of a span: last step
inline constexpr double kBesideChord = 1.5;  // of a chord, from its middle: how far the curves may cross

/// Of the largest coordinate: cells in which ends of a contour are looked up are wider, so that their numbers
/// are exact.
inline constexpr double kNarrowestCell = 1e-15;

// Splines through points.
inline constexpr double kSharpestSplineTurn = 150 * kPi / 180;  // beyond which the points go back
// From the last point of a closed curve to the first, in largest other steps.
inline constexpr double kWidestClosingStep = 3;
inline constexpr double kSameSplinePoint = 1e-12;  // distance of points that coincide, of the size of all
inline constexpr double kSlowestSpline = 0.05;     // speed, of what its parameter wants

// Fillets and offsets.
inline constexpr double kNoTurn = 1e-7;             // a turn that is none [rad]
inline constexpr double kTurnBack = kPi - 1e-6;     // a turn back [rad]
inline constexpr double kLengthRounding = 1e-9;     // of a piece's length: a rounding may use it up
inline constexpr double kVanishedRadius = 1e-9;     // of the radius: an arc about its own centre is a point
inline constexpr double kLeastOffsetRadius = 1e-6;  // of the radius: what is left is a cusp

// Arcs and lines in place of a boundary.

/// Of the boundary's size: the least tolerance that may be asked for.
inline constexpr double kFinestTolerance = 1e-9;
inline constexpr double kSameSpanArc = 1e-12;       // of the size: a span this near to an arc is that arc
inline constexpr double kSameTangent = 1e-9;        // and its tangent at the end [rad]
inline constexpr double kStraightBulge = 2e-8;      // smaller bulges are lines: no program sees the turn
inline constexpr double kLongestArcTurn = kPi / 2;  // of one arc, and of what a biarc is tried on [rad]
inline constexpr double kWholeParts = 1e-9;         // of such a turn: a count of them that is whole
inline constexpr double kSureShare = 0.95;          // of the tolerance: what lies between the probes

// Curves through measured points, normalised to size 1.
inline constexpr double kFitRounding = 1e-15;  // of a distance
// Of the two directions in which points spread, as shares: below, it is rounding; above, none is the longer.
inline constexpr double kSpreadOfLine = 1e-13;
inline constexpr double kSpreadAllAround = 1 - 1e-9;
inline constexpr double kSpreadNearLine = 1e-7;         // below it a conic through points means nothing
inline constexpr double kCoefficientDifference = 1e-6;  // step of coefficients of size 1
// Of the points' size: beyond are no centre and no axes; below 1 over it, too.
inline constexpr double kFarPoint = 1e6;
// Pivots, of the largest, that are none: of slopes, of the linear monomials, of a parabola.
inline constexpr double kSlopesRank = 1e-14;
inline constexpr double kLinearRank = 1e-13;
inline constexpr double kParabolaRank = 1e-12;
inline constexpr double kLeastEllipseResidue = 1e-15;  // of the largest: points on an ellipse leave nothing

// Gears.
inline constexpr double kWholeTooth = 1e-6;        // of a tooth: a number of teeth that is whole
inline constexpr double kInvoluteSettled = 1e-16;  // of the angle: last step to the inverse of the involute

}  // namespace higherpair
