#include "general_conic.hpp"

#include "higherpair/geometry/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// Conics given by six coefficients, transformed to the frame of their focal axis and from there to a vertex.

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
  // a b - c²/4, with the rounding errors of both products added back.
  const double det = (ac - quarter) + (std::fma(a, b, -ac) - std::fma(c / 2, c / 2, -quarter));
  // The eigenvector of `major` is at half the angle of (half_difference, c/2), turned by 90° where major < 0.
  const double angle = std::atan2(c / 2, half_difference) / 2;
  const Vector2d algebraic_largest_axis = unit_vector(angle);
  const double minor = std::clamp(det / major, -std::abs(major), std::abs(major));
  return {minor, major, std::signbit(mean) ? algebraic_largest_axis : perp(algebraic_largest_axis)};
}

// Turns and shifts the conic so that the y axis belongs to the eigenvalue `lambda_y` and no term linear in y
// is left.
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

// The same conic with the two axes exchanged: the discriminant is -det/λ_y³, and computing it anew would lose
// digits where λ_x is much larger.
AxisForm with_axes_exchanged(const AxisForm& form, const std::array<double, 6>& k, const Eigen2& eigen) {
  AxisForm other = to_axis_form(k, eigen.major, eigen.minor, perp(eigen.minor_axis));
  other.discriminant = form.discriminant / (form.q * form.q * form.q);
  return other;
}

// The effect of rounding of the six coefficients on the discriminant d² - q f of the form with λ_y = major:
// q, d and f may be off by `kConicNoise` times the terms that they consist of.
double discriminant_noise(const AxisForm& form, const std::array<double, 6>& k, double major,
                          double dropped_q) {
  const double linear = std::hypot(k[3], k[4]) / std::abs(2 * major);
  const double constant = std::abs(k[5] / major);
  if (form.q == 0) {
    // Two parallel lines on either side of the axis have no linear part that could be rounded, but a
    // distance; and dropping a small q makes a parabola of two nearly parallel ones.
    const double d_noise = kConicNoise * (linear + std::sqrt(constant));
    return (2 * std::abs(form.d) + d_noise) * d_noise + 2 * (std::abs(dropped_q) + kEps) * std::abs(form.f);
  }
  const double d_noise = kConicNoise * linear;
  const double f_noise = kConicNoise * (constant + std::abs(form.e) * linear + form.e * form.e);
  return (2 * std::abs(form.d) + d_noise) * d_noise + kConicNoise * std::abs(form.f) +
         (std::abs(form.q) + kConicNoise) * f_noise;
}

CurveError degenerate_kind(const AxisForm& form, const std::array<double, 6>& k, double major, double noise) {
  if (form.q == 0) {
    // Two lines at y² = -f; where they coincide, f is rounding.
    const double f_noise = kConicNoise * (std::abs(k[5] / major) + form.e * form.e);
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
  return if_in_range(vertex_form(form, x_from_center > 0, side));
}

}  // namespace

CurveResult if_in_range(const Curve& curve) {
  const bool finite = curve.vertex_B.allFinite() && std::isfinite(curve.semi_latus) && std::isfinite(curve.q);
  const bool unit = std::abs(curve.axis_B.norm() - 1) < kUnitAxis;
  const bool parabola = curve.kind == CurveKind::kParabola;
  if (!finite || !unit || curve.semi_latus < std::numeric_limits<double>::min() ||
      (curve.q == 0) != parabola) {
    return tl::unexpected(CurveError::kOutOfRange);
  }
  return curve;
}

CurveResult conic_from_scaled(const std::array<double, 6>& k, Side side,
                              const std::optional<Vector2d>& near_B) {
  Eigen2 eigen = eigen_decomposition(k[0], k[1], k[2]);
  double dropped_q = 0;
  if (std::abs(eigen.minor) <= kConicNoise * std::abs(eigen.major)) {
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
    return if_in_range(vertex_form(form, form.d < 0, side));
  }
  if (form.q == 1) {
    return if_in_range(circle(form, k[5] / eigen.major, side));
  }
  const Curve one = vertex_form(form, true, side);
  const Curve other = vertex_form(form, false, side);
  return if_in_range(other.vertex_B.squaredNorm() < one.vertex_B.squaredNorm() ? other : one);
}

}  // namespace higherpair
