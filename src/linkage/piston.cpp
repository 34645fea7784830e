#include "higherpair/linkage/piston.hpp"

#include "higherpair/geometry/pose.hpp"

#include <cassert>
#include <cmath>

namespace higherpair {
namespace {

/// m = 1/w - 1 at the angle where the error of the velocity is largest: the root of G in the header. G is
/// convex and positive at 90°, so that Newton's steps from there decrease m until rounding stops them.
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
