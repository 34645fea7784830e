#include "gap_of_normals.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {

GapValue gap_value(const GapProblem& problem, const Vector2d& n) {
  const Vector2d inward = -n;
  const SupportPoint<double> s1 = support_point(problem.first, n);
  const SupportPoint<double> s2 = support_point(problem.second, inward);
  const Vector2d d = s2.p_W - s1.p_W;
  return {problem.sign * d.dot(n), problem.sign * d.dot(perp(n)), s1.rho + s2.rho};
}

Bounds curvature_bounds(const GapProblem& problem, const Vector2d& n, const Rotation<double>& half) {
  const Bounds rho1 = radius_bounds(problem.first, n, half);
  const Bounds rho2 = radius_bounds(problem.second, -n, half);
  const Bounds sum{rho1.low + rho2.low, rho1.high + rho2.high};
  return problem.sign > 0 ? -sum : sum;
}

double largest_gap(const GapValue& value, const Rotation<double>& half, double R) {
  if (!std::isfinite(R)) {
    return kInf;
  }
  const double a = value.f - R;
  const double b = std::abs(value.slope);
  // R + √(a² + b²) or R + a cos + b sin, rearranged to avoid cancellation for a huge R.
  if (b * half.cos <= a * half.sin) {
    return a > 0 ? value.f + b * b / (std::sqrt(a * a + b * b) + a) : R;
  }
  const double versine = half.sin * half.sin / (1 + half.cos);
  return value.f - a * versine + b * half.sin;
}

CommonNormals common_normals(const GapProblem& problem, bool ring1, bool ring2) {
  const std::optional<NormalArc> normals1 = normals_of(problem.first);
  std::optional<NormalArc> normals2 = normals_of(problem.second);
  if (normals2) {
    normals2->middle += kPi;
  }
  CommonNormals common{normals1 ? normals1 : normals2};
  if (normals1 && normals2) {
    const double shift = nearest_turn(normals2->middle, normals1->middle) - normals1->middle;
    const double low = std::max(-normals1->half, shift - normals2->half);
    const double high = std::min(normals1->half, shift + normals2->half);
    common.arc = NormalArc{normals1->middle + (low + high) / 2, (high - low) / 2};
    common.empty = !(low < high);
  }
  if (ring1 || ring2) {
    const std::optional<NormalArc>& of_ring = ring1 ? normals1 : normals2;
    const std::optional<NormalArc>& of_body = ring1 ? normals2 : normals1;
    const double wanted = of_ring ? of_ring->half : kPi;
    common.cover_ring =
        !common.empty && (!of_body || (common.arc && common.arc->half >= wanted * (1 - kFineGap)));
  }
  return common;
}

}  // namespace higherpair
