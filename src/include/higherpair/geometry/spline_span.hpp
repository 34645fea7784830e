#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <optional>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// How the parameter of a spline grows from one point to the next.
enum class SplineParameter {
  kArc,  ///< by the length of the curve between them: the speed is 1 to within a few parts in a million
  kCentripetal,  ///< by the square root of their distance: calmer where a short distance follows a long one
};

struct SplineOptions {
  int degree = 5;  ///< 5: curvature and its first two derivatives are continuous; 3: curvature only
  bool closed = false;
  /// Largest distance of a point from the (smoothest possible) spline [m]; 0: through all points.
  double smoothing = 0;
  SplineParameter parameter = SplineParameter::kArc;
  /// Directions at the ends of an open interpolating spline; none: free.
  std::optional<Vector2d> first_tangent;
  std::optional<Vector2d> last_tangent;
};

/// Why there is no spline through points.
struct SplineFault {
  enum class Kind {
    kTooFew,     ///< fewer than degree + 1
    kRepeated,   ///< points `first` and `second` coincide
    kTurnsBack,  ///< at point `first` the path turns by more than 150°: a cusp, or points in the wrong order
    kOpen,  ///< closed, but the last point is `distance` [m] from the first: `factor` times the largest step
    kCusp,  ///< after point `first` the spline stops or turns back
  } kind = Kind::kTooFew;
  int first = 0;
  int second = 0;
  double distance = 0;
  double factor = 0;
};

/// A spline through (or near) points in their order, the material on the left; it has a knot at every point.
/// In a closed one the last point may repeat the first. The error falls with the 6th power of the spacing of
/// the points (4th with degree 3); `at` costs the same for any number of points.
/// \pre degree 3 or 5; smoothing >= 0; end tangents only of an open spline without smoothing; points finite
[[nodiscard]] tl::expected<SpanPtr, SplineFault> spline_span(const std::vector<Vector2d>& points,
                                                             const SplineOptions& options = {});

/// A (rational) B-spline as in drawings. It is split where its curvature may jump.
struct NurbsCurve {
  int degree = 3;
  std::vector<double> knots;  ///< non-decreasing; number of control points + degree + 1
  std::vector<Vector2d> control;
  std::vector<double> weights;  ///< > 0, or none
};

/// The spans of the part of the curve that its knots define; those of degree 1 are straight. Parts of length
/// 0 are left out. \pre degree 1 to kHighestNurbsDegree, at least degree + 1 control points, and as above
[[nodiscard]] std::vector<SpanPtr> nurbs_spans(const NurbsCurve& curve);

inline constexpr int kHighestNurbsDegree = 7;

}  // namespace higherpair
