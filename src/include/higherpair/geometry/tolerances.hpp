#pragma once

#include "higherpair/geometry/pose.hpp"

#include <limits>

// Tolerances of the geometry. Unless stated otherwise they are relative to what they are compared with: to
// the size of a curve or boundary, to a radian, or to the width of a span's parameter range.

namespace higherpair {

// Newton's method.

/// Longest step of Newton's method that is taken in full [rad, units of length]: beyond it curves differ from
/// their tangents.
inline constexpr double kNewtonTurn = 0.3;

// Angles and arcs.

/// Square of the largest angle, or sine, for which the series in known_rotation.hpp are used: they leave out
/// at most 2e-17.
inline constexpr double kSmallTurn2 = 1e-3;
/// Arc length of a conic: arguments of the elliptic integrals that differ by no more than this fraction are
/// passed to series, which then leave out less than 1e-16.
inline constexpr double kNearlyEqualRoots = 0.01;
/// Relative precision of an arc length found by quadrature.
inline constexpr double kArcPrecision = 1e-13;

// Conics.

/// Rounding error of the coefficients of a conic's axis form, relative to the terms from which they are
/// computed: the effect of rounding its six general coefficients.
inline constexpr double kConicNoise = 8 * std::numeric_limits<double>::epsilon();
/// Deviation of an axis from unit length that is rounding.
inline constexpr double kUnitAxis = 8 * std::numeric_limits<double>::epsilon();
/// Distance of a curve's centre from a point about which it counts as centred.
inline constexpr double kCentered = 1e-14;
/// Sine of the angle between a line and a sliding direction that moves it along itself.
inline constexpr double kAlongItself = 1e-14;

// The foot of a point on a conic.

// Largest Lagrange multiplier considered, relative to 1 / (largest coefficient).
inline constexpr double kFarthestMultiplier = 1e18;
// Value of the form at a foot, relative to its terms, beyond which the multiplier does not determine the
// foot: it lies on an axis.
inline constexpr double kFootOffConic = 1e-6;
inline constexpr double kMultiplierSettled = 1e-16;  // last step of the multiplier, relative to it

// Spans and boundaries.

/// Widening of the bounds of a radius or speed that are values at points, relative to them.
inline constexpr double kSpanBoundRounding = 1e-12;
/// Rounding error of a derivative, relative to the sum of its terms' sizes.
inline constexpr double kCoefficientRounding = 1e-13;
/// Largest turn of one part of a span of polynomials [rad].
inline constexpr double kLargestPartTurn = 0.1;

/// Normals at a joint that differ by no more are equal [rad]: less than the digits of a drawing resolve.
inline constexpr double kSameJointDirection = 1e-7;
/// Curvatures at a joint that differ by no more are equal: relative to them, or to 1 / size of the boundary.
inline constexpr double kSameJointCurvature = 1e-9;
/// Largest slope of the normal of a local parabola against its axis, by which it loses digits; beyond it the
/// boundary is described by its height over its tangent.
inline constexpr double kSteepestParabola = 1e3;
/// Distance, relative to the reach, of ends of support function pieces that meet.
inline constexpr double kSameSupportEnd = 1e-12;

/// How far the normal turns further on the edge at an end of an open boundary [rad]: the body is taken to be
/// cut off square, like a face that ends at the side of a block. A contact that turns further has slipped
/// off. A quarter turn less an angle that moves a contact by only some 1e-16 of the driver: a follower that
/// slides across its face has a limit position at the quarter turn itself, and rounding would decide which of
/// the two is met first.
inline constexpr double kEdgeTurn = kPi / 2 - 1e-8;

/// How far a curve may deviate from the chord between two neighbouring samples, relative to the chord.
inline constexpr double kSlackOfPart = 0.25;
inline constexpr double kSlackOfNormals = 0.5;  ///< the same for its normals
/// Added to the chords of two cones of normals that are tested for being opposed.
inline constexpr double kRoundingOfNormal = 1e-9;

// A boundary that crosses itself.

// Fraction of a chord by which a crossing may lie beyond its ends.
inline constexpr double kChordEndRounding = 1e-9;
// Fraction of a span within which two places are the same, or a place is the span's end.
inline constexpr double kSameCrossingPlace = 1e-6;
inline constexpr double kCrossingSettled = 1e-9;  // last step, as a fraction of a part of a span
// Largest distance of a crossing of the curves from the middle of a chord, in lengths of the chord.
inline constexpr double kBesideChord = 1.5;

/// Least width of the cells in which ends of a contour are looked up, relative to the largest coordinate:
/// keeps cell numbers exact.
inline constexpr double kNarrowestCell = 1e-15;

// Splines through points.
inline constexpr double kSharpestSplineTurn = 150 * kPi / 180;  // beyond it the path turns back
// Largest distance from the last point of a closed curve to the first, relative to the longest other step.
inline constexpr double kWidestClosingStep = 3;
// Distance of points that coincide, relative to the extent of all points.
inline constexpr double kSameSplinePoint = 1e-12;
// Least speed, relative to the speed that the parameter implies.
inline constexpr double kSlowestSpline = 0.05;

// Drawings with rounded numbers.
// Largest distance between two places of one point, and change of a piece's direction times its length, in
// steps of the coordinates.
inline constexpr double kRoundingAtEnds = 3;
inline constexpr double kShortPiece = 100;           // length in such steps below which a direction is lost
inline constexpr double kFarMoved = 10;              // move of a point, in such steps, that is no rounding
inline constexpr double kMostTurnByRounding = 1e-3;  // a larger turn is meant to be a corner [rad]
inline constexpr double kSmoothAgain = 1e-15;        // turn at a smooth joint [rad]

// Fillets and offsets.
inline constexpr double kNoTurn = 1e-7;          // smaller turns count as straight [rad]
inline constexpr double kTurnBack = kPi - 1e-6;  // larger turns count as reversals [rad]
// Fraction of a piece's length: a fillet that leaves less uses the piece up.
inline constexpr double kLengthRounding = 1e-9;
// Offset radius, relative to the radius, that counts as 0: the arc shrinks to its centre.
inline constexpr double kVanishedRadius = 1e-9;
// Least offset radius, relative to the radius: below it the offset has a cusp.
inline constexpr double kLeastOffsetRadius = 1e-6;

// Approximation of a boundary by arcs and lines.

/// Finest tolerance that may be asked for, relative to the boundary's size.
inline constexpr double kFinestTolerance = 1e-9;
/// The same relative to its largest coordinate, 64 roundings of it: vertices are not placed better than that.
inline constexpr double kFinestPlace = 1.5e-14;
/// The same [m]: squares of smaller lengths are no normal numbers.
inline constexpr double kFinestLength = 1e-140;
/// Coarsest tolerance at which a boundary keeps its shape, relative to its size.
inline constexpr double kCoarsestShape = 1e-2;
// Relative to the size: a span this close to an arc is replaced by that arc, ...
inline constexpr double kSameSpanArc = 1e-12;
inline constexpr double kSameTangent = 1e-9;    // ... if their tangents at the end agree [rad]
inline constexpr double kStraightBulge = 2e-8;  // smaller bulges are lines: no program resolves the turn
// Of one arc, and of a stretch that a biarc is tried on [rad].
inline constexpr double kLongestArcTurn = kPi / 2;
inline constexpr double kWholeParts = 1e-9;  // rounding allowed when such turns are counted
// Fraction of the tolerance that the error at the probes may take up: allows for what lies between them.
inline constexpr double kSureShare = 0.95;

// Curves through measured points, normalised to size 1.
inline constexpr double kFitRounding = 1e-15;  // rounding error of a distance
// Least over greatest spread of the points: below the first the points lie on a line; above the second no
// direction is the longer one.
inline constexpr double kSpreadOfLine = 1e-13;
inline constexpr double kSpreadAllAround = 1 - 1e-9;
inline constexpr double kSpreadNearLine = 1e-7;         // below it a conic through the points is meaningless
inline constexpr double kCoefficientDifference = 1e-6;  // difference step of coefficients of size 1
// Relative to the size of the points: centres and axes beyond this, and axes below its reciprocal, are
// rejected.
inline constexpr double kFarPoint = 1e6;
// Pivots below these fractions of the largest count as 0: of slopes, of the linear monomials, of a parabola.
inline constexpr double kSlopesRank = 1e-14;
inline constexpr double kLinearRank = 1e-13;
inline constexpr double kParabolaRank = 1e-12;
// Least residual, relative to the largest: that of points on an ellipse is 0.
inline constexpr double kLeastEllipseResidue = 1e-15;

// Gears.
inline constexpr double kWholeTooth = 1e-6;        // deviation from a whole number of teeth
inline constexpr double kInvoluteSettled = 1e-16;  // last step of the inverse involute, relative to the angle

}  // namespace higherpair
