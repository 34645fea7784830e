#include "higherpair/geometry/curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

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
  double e;  // distance of the focal axis from the body's origin, as a coordinate
  // (q x + d)² = d² - q f at the two vertices; > 0 for a real conic whose focal axis is the x axis.
  double discriminant;
};

// No curve whose numbers have left the range of double.
CurveResult checked(const Curve& curve) {
  const bool finite = curve.vertex_B.allFinite() && std::isfinite(curve.semi_latus) && std::isfinite(curve.q);
  const bool unit = std::abs(curve.axis_B.norm() - 1) < 8 * kEps;
  const bool parabola = curve.kind == CurveKind::kParabola;
  if (!finite || !unit || curve.semi_latus < std::numeric_limits<double>::min() ||
      (curve.q == 0) != parabola) {
    return tl::unexpected(CurveError::kOutOfRange);
  }
  return curve;
}

// Of the two vertices of a circle or ellipse the one nearer to the body's origin: it has the smaller rounding
// error.
CurveResult vertex_form_of_ellipse(const Vector2d& center_B, double a, double b, Vector2d axis_B, Side side) {
  const double distance = center_B.stableNorm();
  if (a == b && distance > 0) {
    axis_B = center_B / distance;
  }
  if (center_B.dot(axis_B) < 0) {
    axis_B = -axis_B;
  }
  const double ratio = b / a;
  return checked({a == b ? CurveKind::kCircle : CurveKind::kEllipse, side, center_B - a * axis_B, axis_B,
                  b * ratio, ratio * ratio});
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
  if (radius == 0) {
    return {mean, mean, Vector2d::UnitX()};
  }
  const double major = mean + std::copysign(radius, mean);
  const double ac = a * b;
  const double quarter = c / 2 * (c / 2);
  // a b - c²/4 with the rounding of both products given back.
  const double det = (ac - quarter) + (std::fma(a, b, -ac) - std::fma(c / 2, c / 2, -quarter));
  // The eigenvector of `major` is at half the angle of (half_difference, c/2), turned by 90° where major < 0.
  const double angle = std::atan2(c / 2, half_difference) / 2;
  const Vector2d algebraic_largest_axis = unit_vector(angle);
  const double minor = std::clamp(det / major, -std::abs(major), std::abs(major));
  return {minor, major, std::signbit(mean) ? algebraic_largest_axis : perp(algebraic_largest_axis)};
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
  const double f = std::fma(-e, e, k[5] / lambda_y);
  return {-e * y_axis_B, x_axis_B, q, d, f, e, std::fma(d, d, -q * f)};
}

// The same conic with the two axes in each other's place: the discriminant is -det/λ_y³, and computing it
// anew would lose digits where λ_x is the larger by far.
AxisForm with_axes_exchanged(const AxisForm& form, const std::array<double, 6>& k, const Eigen2& eigen) {
  AxisForm other = to_axis_form(k, eigen.major, eigen.minor, perp(eigen.minor_axis));
  other.discriminant = form.discriminant / (form.q * form.q * form.q);
  return other;
}

// What rounding of the six coefficients does to the discriminant d² - q f of the form with λ_y = major, q, d
// and f being moved by `kNoise` times what they consist of.
constexpr double kNoise = 8 * kEps;

double discriminant_noise(const AxisForm& form, const std::array<double, 6>& k, double major,
                          double dropped_q) {
  const double linear = std::hypot(k[3], k[4]) / std::abs(2 * major);
  const double constant = std::abs(k[5] / major);
  if (form.q == 0) {
    // Two parallel lines about the axis have no linear part that could be rounded, but a distance; and what
    // was dropped of q makes a parabola of two nearly parallel ones.
    const double d_noise = kNoise * (linear + std::sqrt(constant));
    return (2 * std::abs(form.d) + d_noise) * d_noise + 2 * (std::abs(dropped_q) + kEps) * std::abs(form.f);
  }
  const double d_noise = kNoise * linear;
  const double f_noise = kNoise * (constant + std::abs(form.e) * linear + form.e * form.e);
  return (2 * std::abs(form.d) + d_noise) * d_noise + kNoise * std::abs(form.f) +
         (std::abs(form.q) + kNoise) * f_noise;
}

CurveError degenerate_kind(const AxisForm& form, const std::array<double, 6>& k, double major, double noise) {
  if (form.q == 0) {
    // Two lines at y² = -f; where they coincide, f is rounding.
    const double f_noise = kNoise * (std::abs(k[5] / major) + form.e * form.e);
    return form.f > f_noise ? CurveError::kImaginary : CurveError::kLines;
  }
  if (form.q < 0) {
    return CurveError::kLines;
  }
  return form.discriminant < -noise ? CurveError::kImaginary : CurveError::kSinglePoint;
}

// The vertex form at the vertex whose axis points along +x_axis (`forward`) or against it.
Curve vertex_form(const AxisForm& form, bool forward, Side side) {
  const double root = std::sqrt(form.discriminant);
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
  const double distance = center_B.stableNorm();
  const double radius = std::sqrt(form.discriminant);
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
  return checked(vertex_form(form, x_from_center > 0, side));
}

// The largest of A, B, C is between 1 and 2.
CurveResult conic_from_scaled(const std::array<double, 6>& k, Side side,
                              const std::optional<Vector2d>& near_B) {
  Eigen2 eigen = eigen_decomposition(k[0], k[1], k[2]);
  double dropped_q = 0;
  if (std::abs(eigen.minor) <= kNoise * std::abs(eigen.major)) {
    dropped_q = std::exchange(eigen.minor, 0) / eigen.major;
  }
  AxisForm form = to_axis_form(k, eigen.minor, eigen.major, eigen.minor_axis);
  const double noise = discriminant_noise(form, k, eigen.major, dropped_q);
  if (!std::isfinite(form.discriminant) || !std::isfinite(noise)) {
    return tl::unexpected(CurveError::kOutOfRange);
  }
  // The focal axis of a hyperbola belongs to the eigenvalue with a positive discriminant; that may be either.
  const bool exchanged = form.q < 0 && form.discriminant < 0;
  if ((exchanged ? -form.discriminant : form.discriminant) <= noise) {
    return tl::unexpected(degenerate_kind(form, k, eigen.major, noise));
  }
  if (exchanged) {
    form = with_axes_exchanged(form, k, eigen);
  }
  if (form.q < 0) {
    return hyperbola_branch(form, side, near_B);
  }
  if (form.q == 0) {
    return checked(vertex_form(form, form.d < 0, side));
  }
  if (form.q == 1) {
    return checked(circle(form, k[5] / eigen.major, side));
  }
  const Curve one = vertex_form(form, true, side);
  const Curve other = vertex_form(form, false, side);
  return checked(other.vertex_B.squaredNorm() < one.vertex_B.squaredNorm() ? other : one);
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
  return checked({CurveKind::kParabola, side, vertex_B, unit_vector(rotation), 2 * focal_length, 0});
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
  return checked({CurveKind::kHyperbola, side, center_B + a * axis_B, axis_B, b * ratio, -ratio * ratio});
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
