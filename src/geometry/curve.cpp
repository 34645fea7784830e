#include "higherpair/geometry/curve.hpp"

#include "general_conic.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

// Takes that vertex of a circle or ellipse which is nearer to the body's origin: it has the smaller rounding
// error.
CurveResult vertex_form_of_ellipse(const Vector2d& center_B, double a, double b, Vector2d axis_B, Side side) {
  const double distance = center_B.stableNorm();
  if (a == b && distance >= std::numeric_limits<double>::min()) {
    axis_B = center_B / distance;
  }
  if (center_B.dot(axis_B) < 0) {
    axis_B = -axis_B;
  }
  const double ratio = b / a;
  return if_in_range({a == b ? CurveKind::kCircle : CurveKind::kEllipse, side, center_B - a * axis_B, axis_B,
                      b * ratio, ratio * ratio});
}

bool all_finite(const std::array<double, 6>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

// What is wrong with the numbers of a conic.
std::optional<CurveError> fault_of(const Vector2d& at_B, const std::array<double, 2>& lengths,
                                   double rotation = 0) {
  const auto [a, b] = lengths;
  if (!at_B.allFinite() || !std::isfinite(a) || !std::isfinite(b) || !std::isfinite(rotation)) {
    return CurveError::kNotFinite;
  }
  return a <= 0 || b <= 0 ? std::optional(CurveError::kNotPositive) : std::nullopt;
}

}  // namespace

std::string_view describe(CurveError error) {
  switch (error) {
    case CurveError::kNotFinite:
      return "must consist of finite numbers";
    case CurveError::kNotPositive:
      return "must be > 0";
    case CurveError::kZeroNormal:
      return "must not be the zero vector";
    case CurveError::kNoQuadraticPart:
      return "is no conic: A, B and C are all 0 (use type \"line\" for a flat face)";
    case CurveError::kImaginary:
      return "has no real point (imaginary conic)";
    case CurveError::kSinglePoint:
      return "is a single point (use type \"point\" for a knife edge)";
    case CurveError::kLines:
      return "is degenerate: a pair of lines (use type \"line\" for a flat face)";
    case CurveError::kOutOfRange:
      return "has numbers too large or too small to compute with";
    case CurveError::kBranchNeeded:
      return "is a hyperbola: near = [x, y] must say which branch is meant";
    case CurveError::kBranchUnclear:
      return "is a hyperbola and `near` lies between its branches";
  }
  return "is not valid";
}

CurveResult make_circle(const Vector2d& center_B, double radius, Side side) {
  if (const auto fault = fault_of(center_B, {radius, radius})) {
    return tl::unexpected(*fault);
  }
  return vertex_form_of_ellipse(center_B, radius, radius, Vector2d::UnitX(), side);
}

CurveResult make_ellipse(const Vector2d& center_B, const std::array<double, 2>& semi_axes, double rotation,
                         Side side) {
  const auto [a, b] = semi_axes;
  if (const auto fault = fault_of(center_B, semi_axes, rotation)) {
    return tl::unexpected(*fault);
  }
  const Vector2d first_axis = unit_vector(rotation);
  if (a >= b) {
    return vertex_form_of_ellipse(center_B, a, b, first_axis, side);
  }
  return vertex_form_of_ellipse(center_B, b, a, perp(first_axis), side);
}

CurveResult make_parabola(const Vector2d& vertex_B, double focal_length, double rotation, Side side) {
  if (const auto fault = fault_of(vertex_B, {focal_length, focal_length}, rotation)) {
    return tl::unexpected(*fault);
  }
  return if_in_range({CurveKind::kParabola, side, vertex_B, unit_vector(rotation), 2 * focal_length, 0});
}

CurveResult make_hyperbola(const Vector2d& center_B, const std::array<double, 2>& semi_axes, double rotation,
                           Side side) {
  const auto [a, b] = semi_axes;
  if (const auto fault = fault_of(center_B, semi_axes, rotation)) {
    return tl::unexpected(*fault);
  }
  const Vector2d axis_B = unit_vector(rotation);
  const double ratio = b / a;
  return if_in_range({CurveKind::kHyperbola, side, center_B + a * axis_B, axis_B, b * ratio, -ratio * ratio});
}

CurveResult make_line(const Vector2d& point_B, const Vector2d& normal_B) {
  if (!point_B.allFinite() || !normal_B.allFinite()) {
    return tl::unexpected(CurveError::kNotFinite);
  }
  const double largest = normal_B.cwiseAbs().maxCoeff();
  if (largest == 0) {
    return tl::unexpected(CurveError::kZeroNormal);
  }
  return Curve{CurveKind::kLine, Side::kInside, point_B, -(normal_B / largest).normalized(), 0, 1};
}

CurveResult make_point(const Vector2d& at_B) {
  if (!at_B.allFinite()) {
    return tl::unexpected(CurveError::kNotFinite);
  }
  return Curve{CurveKind::kPoint, Side::kInside, at_B, Vector2d::UnitX(), 0, 1};
}

CurveResult make_conic(const std::array<double, 6>& coefficients, Side side,
                       const std::optional<Vector2d>& near_B) {
  if (!all_finite(coefficients)) {
    return tl::unexpected(CurveError::kNotFinite);
  }
  std::array<double, 6> k = coefficients;
  const double largest = std::max({std::abs(k[0]), std::abs(k[1]), std::abs(k[2])});
  if (largest == 0) {
    return tl::unexpected(CurveError::kNoQuadraticPart);
  }
  // A power of two: scaling does not round.
  const int exponent = std::ilogb(largest);
  for (double& value : k) {
    value = std::ldexp(value, -exponent);
  }
  if (!all_finite(k)) {
    return tl::unexpected(CurveError::kOutOfRange);
  }
  return conic_from_scaled(k, side, near_B);
}

std::array<double, 6> implicit_coefficients(const Curve& curve) {
  const Vector2d u = curve.axis_B;
  const Vector2d w = perp(u);
  const Vector2d v = curve.vertex_B;
  if (curve.kind == CurveKind::kPoint) {
    return {1, 1, 0, -2 * v.x(), -2 * v.y(), v.squaredNorm()};
  }
  if (curve.kind == CurveKind::kLine) {
    return {0, 0, 0, -u.x(), -u.y(), u.dot(v)};
  }
  // (y² + q x²)/(2ℓ) - x with x = u·(p - v), y = w·(p - v); the sign is that of the side.
  const double sign = curve.side == Side::kInside ? 1 : -1;
  const double scale = sign / (2 * curve.semi_latus);
  const double x0 = u.dot(v);
  const double y0 = w.dot(v);
  const double q = curve.q;
  const Vector2d linear = -2 * scale * (q * x0 * u + y0 * w) - sign * u;
  return {scale * (w.x() * w.x() + q * u.x() * u.x()),
          scale * (w.y() * w.y() + q * u.y() * u.y()),
          2 * scale * (w.x() * w.y() + q * u.x() * u.y()),
          linear.x(),
          linear.y(),
          scale * y0 * y0 + q * (scale * x0) * x0 + sign * x0};  // squares alone would underflow
}

std::array<double, 2> semi_axes(const Curve& curve) {
  assert(curve.q != 0);
  return {curve.semi_latus / std::abs(curve.q), curve.semi_latus / std::sqrt(std::abs(curve.q))};
}

Vector2d center(const Curve& curve) {
  assert(curve.q != 0);
  return curve.vertex_B + curve.semi_latus / curve.q * curve.axis_B;
}

}  // namespace higherpair
