#include "higherpair/geometry/curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

// A conic in the frame of its focal axis, up to a factor: y² + q x² + 2 d x + f = 0.
struct AxisForm {
  Vector2d origin_B;  // where x = y = 0
  Vector2d x_axis_B;
  double q;
  double d;
  double f;
  double discriminant_noise;  // what rounding of the coefficients does to d² - q f
};

// (q x + d)² = d² - q f at the two vertices; > 0 for a real conic whose focal axis is the x axis.
double discriminant(const AxisForm& form) {
  return std::fma(form.d, form.d, -form.q * form.f);
}

// Of the two vertices of a circle or ellipse the one nearer to the body's origin: it has the smaller rounding
// error.
Curve vertex_form_of_ellipse(const Vector2d& center_B, double a, double b, Vector2d axis_B, Side side) {
  if (a == b && center_B.norm() > 0) {
    axis_B = center_B.normalized();
  }
  if (center_B.dot(axis_B) < 0) {
    axis_B = -axis_B;
  }
  const double ratio = b / a;
  return {a == b ? CurveKind::kCircle : CurveKind::kEllipse,
          side,
          center_B - a * axis_B,
          axis_B,
          b * ratio,
          ratio * ratio};
}

// The quadratic part [A, C/2; C/2, B] by eigenvalues: `major` is the one of larger magnitude.
struct Eigen2 {
  double minor;
  double major;
  Vector2d minor_axis;
};

Eigen2 eigen_decomposition(double a, double b, double c) {
  const double half_difference = (a - b) / 2;
  const double radius = std::hypot(half_difference, c / 2);
  const double mean = (a + b) / 2;
  const double major = mean + std::copysign(radius, mean);
  const double ac = a * b;
  const double quarter = c / 2 * (c / 2);
  // a b - c²/4 with the rounding of both products given back.
  const double det = (ac - quarter) + (std::fma(a, b, -ac) - std::fma(c / 2, c / 2, -quarter));
  // The eigenvector of `major` is at half the angle of (half_difference, c/2), turned by 90° where major < 0.
  const double angle = std::atan2(c / 2, half_difference) / 2;
  const Vector2d algebraic_largest_axis = unit_vector(angle);
  return {det / major, major, mean >= 0 ? perp(algebraic_largest_axis) : algebraic_largest_axis};
}

// Turns and shifts the conic so that the y axis belongs to the eigenvalue `lambda_y` and no term in y is
// left.
AxisForm to_axis_form(const std::array<double, 6>& k, double lambda_x, double lambda_y,
                      const Vector2d& x_axis_B) {
  const Vector2d y_axis_B = perp(x_axis_B);
  const Vector2d linear(k[3], k[4]);
  const double d = linear.dot(x_axis_B) / (2 * lambda_y);
  const double e = linear.dot(y_axis_B) / (2 * lambda_y);
  const double q = lambda_x / lambda_y;
  const double f = k[5] / lambda_y;
  const double d_noise = 4 * kEps * linear.norm() / std::abs(2 * lambda_y);
  const double noise =
      2 * std::abs(d) * d_noise + d_noise * d_noise + 8 * kEps * std::abs(q) * (e * e + std::abs(f));
  return {-e * y_axis_B, x_axis_B, q, d, std::fma(-e, e, f), noise};
}

CurveError degenerate_kind(const AxisForm& form) {
  if (form.q == 0) {
    return form.f > 0 ? CurveError::kImaginary : CurveError::kLines;
  }
  if (form.q < 0) {
    return CurveError::kLines;
  }
  return discriminant(form) < -form.discriminant_noise ? CurveError::kImaginary : CurveError::kSinglePoint;
}

// The vertex form at the vertex whose axis points along +x_axis (`forward`) or against it.
Curve vertex_form(const AxisForm& form, bool forward, Side side) {
  const double root = std::sqrt(discriminant(form));
  // q x² + 2 d x + f = 0 with q x + d = -root (forward) or +root, without cancellation.
  const double wanted = forward ? -root : root;
  const bool cancels = form.d * wanted > 0;
  const double x = cancels ? -form.f / (form.d + wanted) : (wanted - form.d) / form.q;
  CurveKind kind = CurveKind::kParabola;
  if (form.q > 0) {
    kind = CurveKind::kEllipse;
  }
  if (form.q < 0) {
    kind = CurveKind::kHyperbola;
  }
  const Vector2d axis_B = forward ? form.x_axis_B : Vector2d(-form.x_axis_B);
  return {kind, side, form.origin_B + x * form.x_axis_B, axis_B, root, form.q};
}

// A circle x² + y² + … + f = 0 by its vertex nearest to the origin, which is at f/(|c| + r) from it.
Curve circle(const AxisForm& form, double f, Side side) {
  const Vector2d center_B = form.origin_B - form.d * form.x_axis_B;
  const double distance = center_B.norm();
  const double radius = std::sqrt(discriminant(form));
  const Vector2d axis_B = distance > 0 ? Vector2d(center_B / distance) : form.x_axis_B;
  return {CurveKind::kCircle, side, f / (distance + radius) * axis_B, axis_B, radius, 1};
}

CurveResult hyperbola_branch(const AxisForm& form, Side side, const std::optional<Vector2d>& near_B) {
  if (!near_B) {
    return tl::unexpected(CurveError::kBranchNeeded);
  }
  if (!near_B->allFinite()) {
    return tl::unexpected(CurveError::kNotFinite);
  }
  const double x_from_center = form.x_axis_B.dot(*near_B - form.origin_B) + form.d / form.q;
  if (x_from_center == 0) {
    return tl::unexpected(CurveError::kBranchUnclear);
  }
  return vertex_form(form, x_from_center > 0, side);
}

bool all_finite(const std::array<double, 6>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
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
    case CurveError::kBranchNeeded:
      return "is a hyperbola: near = [x, y] must say which branch is meant";
    case CurveError::kBranchUnclear:
      return "is a hyperbola and `near` lies between its branches";
  }
  return "is not valid";
}

CurveResult make_circle(const Vector2d& center_B, double radius, Side side) {
  if (!center_B.allFinite() || !std::isfinite(radius)) {
    return tl::unexpected(CurveError::kNotFinite);
  }
  if (radius <= 0) {
    return tl::unexpected(CurveError::kNotPositive);
  }
  return vertex_form_of_ellipse(center_B, radius, radius, Vector2d::UnitX(), side);
}

CurveResult make_ellipse(const Vector2d& center_B, const std::array<double, 2>& semi_axes, double rotation,
                         Side side) {
  const auto [a, b] = semi_axes;
  if (!center_B.allFinite() || !std::isfinite(a) || !std::isfinite(b) || !std::isfinite(rotation)) {
    return tl::unexpected(CurveError::kNotFinite);
  }
  if (a <= 0 || b <= 0) {
    return tl::unexpected(CurveError::kNotPositive);
  }
  const Vector2d first_axis = unit_vector(rotation);
  if (a >= b) {
    return vertex_form_of_ellipse(center_B, a, b, first_axis, side);
  }
  return vertex_form_of_ellipse(center_B, b, a, perp(first_axis), side);
}

CurveResult make_parabola(const Vector2d& vertex_B, double focal_length, double rotation, Side side) {
  if (!vertex_B.allFinite() || !std::isfinite(focal_length) || !std::isfinite(rotation)) {
    return tl::unexpected(CurveError::kNotFinite);
  }
  if (focal_length <= 0) {
    return tl::unexpected(CurveError::kNotPositive);
  }
  return Curve{CurveKind::kParabola, side, vertex_B, unit_vector(rotation), 2 * focal_length, 0};
}

CurveResult make_hyperbola(const Vector2d& center_B, const std::array<double, 2>& semi_axes, double rotation,
                           Side side) {
  const auto [a, b] = semi_axes;
  if (!center_B.allFinite() || !std::isfinite(a) || !std::isfinite(b) || !std::isfinite(rotation)) {
    return tl::unexpected(CurveError::kNotFinite);
  }
  if (a <= 0 || b <= 0) {
    return tl::unexpected(CurveError::kNotPositive);
  }
  const Vector2d axis_B = unit_vector(rotation);
  const double ratio = b / a;
  return Curve{CurveKind::kHyperbola, side, center_B + a * axis_B, axis_B, b * ratio, -ratio * ratio};
}

CurveResult make_line(const Vector2d& point_B, const Vector2d& normal_B) {
  if (!point_B.allFinite() || !normal_B.allFinite()) {
    return tl::unexpected(CurveError::kNotFinite);
  }
  const double length = normal_B.stableNorm();
  if (length == 0) {
    return tl::unexpected(CurveError::kZeroNormal);
  }
  return Curve{CurveKind::kLine, Side::kInside, point_B, -normal_B / length, 0, 1};
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

  const Eigen2 eigen = eigen_decomposition(k[0], k[1], k[2]);
  double minor = eigen.minor;
  if (std::abs(minor) <= 8 * kEps * std::abs(eigen.major)) {
    minor = 0;
  }
  AxisForm form = to_axis_form(k, minor, eigen.major, eigen.minor_axis);
  // The focal axis of a hyperbola may belong to either eigenvalue: to the one with a positive discriminant.
  if (minor != 0 && minor * eigen.major < 0 && discriminant(form) < 0) {
    form = to_axis_form(k, eigen.major, minor, perp(eigen.minor_axis));
  }
  if (discriminant(form) <= form.discriminant_noise) {
    return tl::unexpected(degenerate_kind(form));
  }
  if (form.q < 0) {
    return hyperbola_branch(form, side, near_B);
  }
  if (form.q == 0) {
    return vertex_form(form, form.d < 0, side);
  }

  if (form.q == 1) {
    return circle(form, k[5] / eigen.major, side);
  }
  Curve curve = vertex_form(form, true, side);
  const Curve other = vertex_form(form, false, side);
  if (other.vertex_B.squaredNorm() < curve.vertex_B.squaredNorm()) {
    curve = other;
  }
  return curve;
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
          scale * (y0 * y0 + q * x0 * x0) + sign * x0};
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
