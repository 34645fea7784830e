#include "higherpair/linkage/piston.hpp"

#include <cassert>
#include <cmath>

namespace higherpair {
namespace {

/// By the chain rule, from x(θ) and its derivatives.
PistonMotion with_rates(double x, double x_1, double x_2, const AngleMotion& crank) {
  return {x, x_1 * crank.omega, x_2 * crank.omega * crank.omega + x_1 * crank.alpha};
}

/// 1 - cos θ without cancellation.
double versine(double theta) {
  const double half = std::sin(0.5 * theta);
  return 2 * half * half;
}

/// m = 1/w - 1 at the angle where the error of the velocity is largest: the root of the header's G. G is
/// convex and positive at 90°, so that Newton's steps from there go down until rounding stops them.
double worst_velocity(double lambda, double mu, double m_90) {
  double m = m_90;
  while (true) {
    const double G = m * ((9 * mu - 1) + mu * m * (10 + m * (5 + m))) - 3 * lambda * lambda;
    const double slope = (9 * mu - 1) + mu * m * (20 + m * (15 + 4 * m));
    const double next = m - G / slope;
    if (!(next < m)) return m;
    m = next;
  }
}

}  // namespace

PistonMotion exact_piston_motion(double r, double l, const AngleMotion& crank) {
  assert(r > 0 && r < l);
  const double lambda = r / l;
  const double s = std::sin(crank.theta), c = std::cos(crank.theta);
  const double q = lambda * s;
  const double w = std::sqrt((1 - q) * (1 + q));
  const double x = r * versine(crank.theta) + l * q * q / (1 + w);
  const double x_1 = r * s * (1 + lambda * c / w);
  const double x_2 = r * (c + lambda * ((c - s) * (c + s) / w + q * q * c * c / (w * w * w)));
  return with_rates(x, x_1, x_2, crank);
}

PistonMotion harmonic_piston_motion(double r, double l, const AngleMotion& crank) {
  assert(r >= 0 && l > 0);
  const double lambda = r / l;
  const double s = std::sin(crank.theta), c = std::cos(crank.theta);
  return with_rates(r * (versine(crank.theta) + 0.5 * lambda * s * s), r * s * (1 + lambda * c),
                    r * (c + lambda * (c - s) * (c + s)), crank);
}

HarmonicError harmonic_error(double lambda) {
  assert(lambda > 0 && lambda < 1);
  const double mu = (1 - lambda) * (1 + lambda);
  const double w = std::sqrt(mu);
  const double m_90 = lambda * lambda / (w * (1 + w));
  const double m = worst_velocity(lambda, mu, m_90);
  // sin² θ = q²/λ² with q² = 1 - w², in terms of m.
  const double square = m * (m + 2);
  const double end = lambda * (1 + m);
  const double theta = std::atan2(std::sqrt(square), std::sqrt(end * end - square));
  return {{lambda * lambda * lambda / (2 * (1 + w) * (1 + w)), kPi / 2},
          {0.5 * lambda * m * std::sin(2 * theta), theta},
          {lambda * m_90, kPi / 2}};
}

}  // namespace higherpair
