#pragma once

#include "higherpair/geometry/pose.hpp"

#include <limits>

// Tolerances of the geometry. Unless stated otherwise they are relative to what they are compared with: to
// the size of a curve or boundary, to a radian, or to the width of a span's parameter range.

namespace higherpair {

// Newton's method.

/// Longest step of Newton's method that is taken in full [rad, in units of the size]: farther away a curve
/// differs too much from its tangent.
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

/// An arc that turns through less is a line [rad]. Its height over the chord, sweep / 8 of its length, is
/// then less than the rounding of its radius, 2e-16 / sweep of its length.
inline constexpr double kStraightSweep = 4e-8;

// Conics.

/// Rounding error of the coefficients of a conic's axis form, relative to the terms from which they are
/// computed: the effect of rounding its six general coefficients.
inline constexpr double kConicNoise = 8 * std::numeric_limits<double>::epsilon();
/// Deviation of an axis from unit length that is rounding.
inline constexpr double kUnitAxis = 8 * std::numeric_limits<double>::epsilon();
/// A curve counts as centred about a point if its centre is closer to it than this.
inline constexpr double kCentered = 1e-14;
/// A sliding direction moves a line along itself if the sine of the angle between them is below this.
inline constexpr double kAlongItself = 1e-14;

// The foot of a point on a conic.

// Largest Lagrange multiplier considered, relative to 1 / (largest coefficient).
inline constexpr double kFarthestMultiplier = 1e18;
// If the conic's equation at a foot leaves more than this, relative to its terms, the multiplier does not
// determine the foot: the foot is on an axis.
inline constexpr double kFootOffConic = 1e-6;
inline constexpr double kMultiplierSettled = 1e-16;  // last step of the multiplier, relative to it

// Spans and boundaries.

/// By how much bounds of a radius or speed that were found at points are widened, relative to them: rounding.
inline constexpr double kSpanBoundRounding = 1e-12;
/// Rounding error of a derivative, relative to the sum of its terms' sizes.
inline constexpr double kCoefficientRounding = 1e-13;
/// Largest turn of one part of a span of polynomials [rad].
inline constexpr double kLargestPartTurn = 0.1;

/// Normals at a joint of two spans that differ by no more are equal [rad]: less than the digits of a drawing
/// resolve.
inline constexpr double kSameJointDirection = 1e-7;
/// Curvatures at a joint that differ by no more are equal: relative to them, or to 1 / size of the boundary.
inline constexpr double kSameJointCurvature = 1e-9;
/// A boundary is described near a point by a parabola, unless the normal is steeper against the parabola's
/// axis than this slope, which costs as many digits: then by its height over the tangent.
inline constexpr double kSteepestParabola = 1e3;
/// Ends of pieces of a support function that are closer than this, relative to the reach, meet.
inline constexpr double kSameSupportEnd = 1e-12;

/// How far the normal turns on the edge at an end of an open boundary [rad]: the body is taken to be cut off
/// square, like a face that ends at the side of a block. A contact whose normal turns further has slipped
/// off. It is a little less than a quarter turn, at which a follower that slides across its face has a limit
/// position: else rounding would decide which of the two comes first. The difference shifts a contact by only
/// some 1e-16 of the driver.
inline constexpr double kEdgeTurn = kPi / 2 - 1e-8;

/// Bound of how far a curve deviates from the chord between two neighbouring samples, relative to the chord.
inline constexpr double kSlackOfPart = 0.25;
inline constexpr double kSlackOfNormals = 0.5;  ///< the same for its normals on the unit circle
/// Widening, for rounding, of two cones of normals that are tested for being opposed.
inline constexpr double kRoundingOfNormal = 1e-9;

// A boundary that crosses itself.

// Chords that meet no farther beyond their ends than this fraction of their lengths meet at the ends.
inline constexpr double kChordEndRounding = 1e-9;
// Two places closer than this fraction of a span are the same; also a place and the span's end.
inline constexpr double kSameCrossingPlace = 1e-6;
inline constexpr double kCrossingSettled = 1e-9;  // last step, as a fraction of a part of a span
// A crossing of two curves belongs to the crossing of their chords if it is no farther from the middle of a
// chord than this, in lengths of the chord.
inline constexpr double kBesideChord = 1.5;

/// Least width of the cells in which ends of a contour are looked up, relative to the largest coordinate:
/// keeps cell numbers exact.
inline constexpr double kNarrowestCell = 1e-15;

// Splines through points.
// A larger turn at a point [rad] means that the points are out of order: the path turns back.
inline constexpr double kSharpestSplineTurn = 150 * kPi / 180;
// Largest distance from the last point of a closed curve to the first, relative to the longest other distance
// of neighbouring points: beyond it the curve was not meant to be closed.
inline constexpr double kWidestClosingStep = 3;
// Points closer than this, relative to the extent of all points, coincide.
inline constexpr double kSameSplinePoint = 1e-12;
// Least speed along the spline, relative to that of equal progress over its parameter: slower, it has a cusp
// or a loop.
inline constexpr double kSlowestSpline = 0.05;

// Drawings with rounded numbers.
// Rounding, in steps of the last decimal of the coordinates: distance between two places of one point, and
// change of a piece's direction times its length.
inline constexpr double kRoundingAtEnds = 3;
inline constexpr double kShortPiece = 100;           // shorter pieces, in such steps, have no sure direction
inline constexpr double kFarMoved = 10;              // a point that moves by more such steps is not rounded
inline constexpr double kMostTurnByRounding = 1e-3;  // a larger turn is meant to be a corner [rad]
inline constexpr double kSmoothAgain = 1e-15;        // turn at a smooth joint [rad]

// Fillets and offsets.
inline constexpr double kNoTurn = 1e-7;          // smaller turns count as straight [rad]
inline constexpr double kTurnBack = kPi - 1e-6;  // larger turns count as reversals [rad]
// A fillet that leaves less than this fraction of a piece's length uses up the whole piece.
inline constexpr double kLengthRounding = 1e-9;
// An offset radius below this, relative to the radius, counts as 0: the arc shrinks to its centre.
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
// Largest turn of one arc, and of a stretch for which a biarc is tried [rad].
inline constexpr double kLongestArcTurn = kPi / 2;
inline constexpr double kWholeParts = 1e-9;  // rounding allowed when such turns are counted
// Fraction of the tolerance that the error at the sampled points may reach: between them it may be larger.
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
// Pivots below these fractions of the largest count as 0: in the equations for the slopes of a fit, for its
// linear monomials, for a parabola.
inline constexpr double kSlopesRank = 1e-14;
inline constexpr double kLinearRank = 1e-13;
inline constexpr double kParabolaRank = 1e-12;
// Lower bound of residuals that are divided by, relative to the largest: those of points on an ellipse are 0.
inline constexpr double kLeastEllipseResidue = 1e-15;

// Gears.
inline constexpr double kWholeTooth = 1e-6;        // deviation from a whole number of teeth
inline constexpr double kInvoluteSettled = 1e-16;  // last step of the inverse involute, relative to the angle

}  // namespace higherpair
