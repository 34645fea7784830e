// Fits of lines and circles, and what all fits share.
#include "boundary_fit.hpp"

#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/tolerances.hpp"
#include "numeric/least_squares.hpp"
#include "numeric/singular_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace boundary_fit {

tl::expected<Normalised, BoundaryFitError> normalised(std::span<const Vector2d> points, std::size_t least) {
  constexpr double kLargest = 1e100;
  if (points.size() < least) {
    return tl::unexpected(BoundaryFitError::kTooFew);
  }
  if (!std::all_of(points.begin(), points.end(), [](const Vector2d& p) { return p.allFinite(); })) {
    return tl::unexpected(BoundaryFitError::kNotFinite);
  }
  const auto count = static_cast<double>(points.size());
  Normalised result;
  // Relative to the first point, so that summing positions far from 0 does not round away their differences.
  for (const Vector2d& p : points) result.center += (p - points.front()) / count;
  result.center += points.front();
  double largest = 0;
  double square = 0;
  for (const Vector2d& p : points) largest = std::max(largest, (p - result.center).cwiseAbs().maxCoeff());
  for (const Vector2d& p : points) square += ((p - result.center) / largest).squaredNorm() / count;
  const double place = std::max(largest, result.center.cwiseAbs().maxCoeff());
  if (!(place <= kLargest) || (largest > 0 && largest < 1 / kLargest)) {
    return tl::unexpected(BoundaryFitError::kNotFinite);
  }
  if (largest <= 4 * std::numeric_limits<double>::epsilon() * place) {
    return tl::unexpected(BoundaryFitError::kOnePlace);
  }
  result.size = largest * std::sqrt(square);
  for (const Vector2d& p : points) result.points.emplace_back((p - result.center) / result.size);
  return result;
}

void to_own_frame(const Normalised& from, std::span<const double> distances, std::size_t freedoms,
                  const std::vector<bool>& lengths, BoundaryFit& fit) {
  double square = 0;
  for (const double distance : distances) {
    fit.distances.push_back(from.size * distance);
    square += distance * distance;
  }
  const auto count = static_cast<double>(distances.size());
  const double variance =
      distances.size() > freedoms ? square / (count - static_cast<double>(freedoms)) : kNoValue;
  fit.rms = from.size * std::sqrt(square / count);
  fit.noise = from.size * std::sqrt(variance);
  fit.covariance *= variance;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (!lengths[i]) continue;
    const auto k = static_cast<Eigen::Index>(i);
    fit.parameters[i] *= from.size;
    fit.covariance.row(k) *= from.size;
    fit.covariance.col(k) *= from.size;
  }
  fit.parameters[0] += from.center.x();
  fit.parameters[1] += from.center.y();
}

Eigen::MatrixXd inverse_of_square(const Eigen::MatrixXd& J) {
  const SingularValues svd = singular_values(triangular_factor(J));
  const double least = svd.values(svd.values.size() - 1);
  if (J.rows() < J.cols() || !(least > 0)) {
    return Eigen::MatrixXd::Constant(J.cols(), J.cols(), kNoValue);
  }
  const Eigen::MatrixXd root = svd.V * svd.values.cwiseInverse().asDiagonal();
  return root * root.transpose();
}

SingularValues spread_of(const std::vector<Vector2d>& points) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), 2);
  for (std::size_t i = 0; i < points.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = points[i];
  return singular_values(triangular_factor(rows));
}

}  // namespace boundary_fit

namespace {

using boundary_fit::Normalised;
using boundary_fit::spread_of;
using boundary_fit::to_own_frame;

// How far rounding of their coordinates may move points off a line that they are on.
double place_rounding(const Normalised& points) {
  return std::numeric_limits<double>::epsilon() * points.center.cwiseAbs().maxCoeff() / points.size;
}

// A circle in Pratt's parameters, A (x² + y²) + B x + C y + D = 0 with (B, C) = √(1 + 4 A D) (cos t, sin t),
// which includes lines: A = 0. The distance d of a point at which the left side is P satisfies P = d + A d².
struct PrattCircle {
  double A, D, t;

  [[nodiscard]] double root() const { return std::sqrt(std::max(0.0, 1 + 4 * A * D)); }
  [[nodiscard]] double value(const Vector2d& p) const {
    return A * p.squaredNorm() + root() * unit_vector(t).dot(p) + D;
  }
  [[nodiscard]] double distance(const Vector2d& p) const {
    const double P = value(p);
    return 2 * P / (1 + std::sqrt(1 + 4 * A * P));
  }
  [[nodiscard]] Eigen::RowVector3d distance_derivatives(const Vector2d& p) const {
    const double along = unit_vector(t).dot(p);
    const double d = distance(p);
    return Eigen::RowVector3d(p.squaredNorm() + 2 * D / root() * along - d * d, 1 + 2 * A / root() * along,
                              root() * perp(unit_vector(t)).dot(p)) /
           (1 + 2 * A * d);
  }
  [[nodiscard]] Vector2d center() const { return -root() / (2 * A) * unit_vector(t); }
  /// Its point nearest to the origin.
  [[nodiscard]] Vector2d foot() const { return -2 * D / (1 + root()) * unit_vector(t); }
};

// Minimises the mean of (A |p|² + B x + C y + D)² relative to that of |∇|² = 4 A² 〈|p|²〉 + B² + C²; here
// 〈|p|²〉 = 1, and the points are about their centroid.
PrattCircle taubin_circle(const std::vector<Vector2d>& points) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) << (points[i].squaredNorm() - 1) / 2, points[i].x(), points[i].y();
  }
  const Eigen::Vector3d least = singular_values(triangular_factor(rows)).V.col(2);
  const double A = least(0) / 2;
  const double norm = std::sqrt(std::max(least.tail<2>().squaredNorm() + 4 * A * A, kNeverZero));
  return {A / norm, -A / norm, std::atan2(least(2), least(1))};
}

PrattCircle circle_of(const Eigen::VectorXd& x) {
  return {x(0), x(1), x(2)};
}

// The circle of least distances from the points.
LeastSquaresFit nearest_circle(const std::vector<Vector2d>& places, const PrattCircle& start) {
  LeastSquaresProblem problem;
  problem.residuals = [&](const Eigen::VectorXd& x, Eigen::VectorXd& r) {
    const PrattCircle circle = circle_of(x);
    r.resize(static_cast<Eigen::Index>(places.size()));
    for (Eigen::Index i = 0; i < r.size(); ++i) {
      r(i) = circle.distance(places[i]);
    }
    return r.allFinite();
  };
  problem.jacobian = [&](const Eigen::VectorXd& x, Eigen::MatrixXd& J) {
    const PrattCircle circle = circle_of(x);
    J.resize(static_cast<Eigen::Index>(places.size()), 3);
    for (Eigen::Index i = 0; i < J.rows(); ++i) {
      J.row(i) = circle.distance_derivatives(places[i]);
    }
    return true;
  };
  LeastSquaresOptions options;
  options.rounding = kFitRounding;
  return least_squares(problem, Eigen::Vector3d(start.A, 0, start.t), options);
}

}  // namespace

std::string_view describe(BoundaryFitError error) {
  switch (error) {
    case BoundaryFitError::kTooFew:
      return "are fewer than the curve has parameters";
    case BoundaryFitError::kNotFinite:
      return "are too large or too small, or no numbers";
    case BoundaryFitError::kOnePlace:
      return "are all one point";
    case BoundaryFitError::kOneLine:
      return "lie on one line";
    case BoundaryFitError::kNoDirection:
      return "are spread alike in all directions, so that no line is nearest";
    case BoundaryFitError::kOtherForm:
      return "are nearest to a conic of another form";
    case BoundaryFitError::kDegenerate:
      return "are nearest to a pair of lines, or to no curve at all";
    case BoundaryFitError::kNotConverged:
      break;
  }
  return "have no nearest curve that could be found";
}

BoundaryFitResult fit_line(std::span<const Vector2d> points) {
  const auto from = boundary_fit::normalised(points, 2);
  if (!from) {
    return tl::unexpected(from.error());
  }
  const SingularValues spread = spread_of(from->points);
  if (spread.values(1) >= kSpreadAllAround * spread.values(0)) {
    return tl::unexpected(BoundaryFitError::kNoDirection);
  }
  Vector2d normal = spread.V.col(1);
  if (normal.x() < 0 || (normal.x() == 0 && normal.y() < 0)) normal = -normal;
  std::vector<double> distances;
  for (const Vector2d& p : from->points) distances.push_back(normal.dot(p));
  BoundaryFit fit;
  fit.parameters = {0, 0, angle_of(normal)};
  fit.covariance.setZero(3, 3);
  fit.covariance.topLeftCorner<2, 2>() = normal * normal.transpose() / static_cast<double>(distances.size());
  fit.covariance(2, 2) = 1 / (spread.values(0) * spread.values(0));
  to_own_frame(*from, distances, 2, {true, true, false}, fit);
  const auto curve = make_line({fit.parameters[0], fit.parameters[1]}, normal);
  if (!curve) {
    return tl::unexpected(BoundaryFitError::kNotFinite);
  }
  fit.curve = *curve;
  return fit;
}

BoundaryFitResult fit_circle(std::span<const Vector2d> points) {
  const auto from = boundary_fit::normalised(points, 3);
  if (!from) {
    return tl::unexpected(from.error());
  }
  const SingularValues spread = spread_of(from->points);
  if (spread.values(1) <= (kSpreadOfLine + 4 * place_rounding(*from)) * spread.values(0)) {
    return tl::unexpected(BoundaryFitError::kOneLine);
  }
  // About a point of the circle: about its centre the angle t would be undefined.
  const PrattCircle start = taubin_circle(from->points);
  const Vector2d origin = start.foot();
  std::vector<Vector2d> places;
  for (const Vector2d& p : from->points) places.emplace_back(p - origin);
  const LeastSquaresFit found = nearest_circle(places, start);
  const PrattCircle circle = circle_of(found.x);
  if (found.end != LeastSquaresEnd::kConverged || circle.A == 0) {
    return tl::unexpected(circle.A == 0 ? BoundaryFitError::kOneLine : BoundaryFitError::kNotConverged);
  }
  BoundaryFit fit;
  const double radius = 1 / (2 * std::abs(circle.A));
  const Vector2d center = origin + circle.center();
  fit.parameters = {center.x(), center.y(), radius};
  // By centre and radius, a distance is ±(|p - c| - r).
  Eigen::MatrixXd J(found.r.size(), 3);
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < J.rows(); ++i) {
    const Vector2d& p = from->points[i];
    J.row(i) << (center - p).normalized().transpose(), -1;
    distances.push_back(circle.A > 0 ? found.r(i) : -found.r(i));
  }
  fit.covariance = boundary_fit::inverse_of_square(J);
  to_own_frame(*from, distances, 3, {true, true, true}, fit);
  const auto curve = make_circle({fit.parameters[0], fit.parameters[1]}, fit.parameters[2]);
  if (!curve) {
    return tl::unexpected(BoundaryFitError::kOneLine);
  }
  fit.curve = *curve;
  return fit;
}

}  // namespace higherpair
