#pragma once

#include "higherpair/geometry/curve.hpp"

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <tl/expected.hpp>

namespace higherpair {

/// \name Curves through measured points of a boundary
/// Each fit minimises the sum of squared distances of the points from the curve: orthogonal distances, not
/// algebraic ones. Points are first moved to their centroid and scaled to size 1, so that position and unit
/// have no effect: moved, turned and scaled points give the curve moved, turned and scaled.
/// @{

/// The form required of a conic.
enum class ConicForm { kAny, kEllipse, kParabola, kHyperbola };

enum class BoundaryFitError {
  kTooFew,        ///< fewer points than the curve has parameters
  kNotFinite,     ///< a NaN or an infinity, or a spread beyond 1e±100
  kOnePlace,      ///< all points coincide within rounding
  kOneLine,       ///< all points lie on one line
  kNoDirection,   ///< fit of a line: the points are spread alike in all directions
  kOtherForm,     ///< the nearest conic is of another form than asked for
  kDegenerate,    ///< the nearest conic is a pair of lines, a point, or too near to one
  kNotConverged,  ///< the sum of squares did not settle
};

/// What the error means, as the end of a sentence: "the points ...".
[[nodiscard]] std::string_view describe(BoundaryFitError error);

/// A fitted curve.
struct BoundaryFit {
  Curve curve;
  /// Its natural parameters, in the order of the functions below; angles [rad], lengths as the points.
  std::vector<double> parameters;
  /// Covariance of the parameters, to first order, for points with independent errors of `noise`, alike in
  /// all directions. NaN where there are no more points than parameters.
  Eigen::MatrixXd covariance;
  /// Signed distance of each point from the curve: > 0 outside; for a line on the side of its normal.
  std::vector<double> distances;
  double rms = 0;    ///< √(mean of squared distances)
  double noise = 0;  ///< the same per degree of freedom: an estimate of one point's standard error
};

using BoundaryFitResult = tl::expected<BoundaryFit, BoundaryFitError>;

/// The line of total least squares: {x, y of the centroid, angle of the normal in (-π/2, π/2]}. Only the
/// component of the centroid's variance along the normal belongs to the line. At least 2 points.
[[nodiscard]] BoundaryFitResult fit_line(std::span<const Vector2d> points);

/// {x, y of the centre, radius}. At least 3 points. Taubin's circle, then Gauss-Newton on the distances in
/// Pratt's parameters, which stay well conditioned for short arcs of large circles.
/// Taubin, Estimation of planar curves, 1991; Chernov and Lesort, Least squares fitting of circles, 2005.
[[nodiscard]] BoundaryFitResult fit_circle(std::span<const Vector2d> points);

/// Ellipse: {x, y of the centre, a, b, angle of a in (-π/2, π/2]}, a >= b. Hyperbola: {x, y, a, b, direction
/// in which the branch opens on which most points lie}; its points may lie on both. Parabola: {x, y of the
/// vertex, focal length, direction to the focus}. At least 5 points (parabola: 4).
/// The algebraic start is Taubin's conic, or the direct ellipse of Halir and Flusser where an ellipse is
/// wanted; then Gauss-Newton on the distances, whose derivative by a coefficient of F is the monomial at the
/// foot over |∇F| there.
/// Taubin, as above; Halir and Flusser, Numerically stable direct least squares fitting of ellipses, 1998.
[[nodiscard]] BoundaryFitResult fit_conic(std::span<const Vector2d> points, ConicForm form = ConicForm::kAny);

/// The point of the conic A x² + B y² + C x y + D x + E y + F = 0 that is nearest to p; one of them where
/// there are several. \pre the conic has real points and p is finite
[[nodiscard]] Vector2d nearest_on_conic(const std::array<double, 6>& coefficients, const Vector2d& p);
/// @}

}  // namespace higherpair
