#pragma once

#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/expansion.hpp"

#include <cstddef>

namespace higherpair {

/// A function of a curve's parameter near one place, up to the sixth power.
using CurveSeries = PowerSeries<double, 6>;

/// Derivative with respect to the parameter; its last coefficient is left 0.
[[nodiscard]] inline CurveSeries derivative_of(const CurveSeries& f) {
  CurveSeries derivative;
  for (std::size_t k = 1; k < f.c.size(); ++k) {
    derivative.c[k - 1] = static_cast<double>(k) * f.c[k];
  }
  return derivative;
}

/// The rates from the curvature κ(t) and the speed ds/dt, both correct up to the fourth power:
///     dᵏ⁺¹κ/dsᵏ⁺¹ = (d/dt dᵏκ/dsᵏ) / (ds/dt).
[[nodiscard]] inline CurvatureRates rates_of_curvature(CurveSeries kappa, const CurveSeries& speed) {
  CurvatureRates rates{};
  for (std::size_t order = 1; order <= 4; ++order) {
    kappa = derivative_of(kappa) / speed;
    if (order >= 2) {
      rates[order - 2] = value_of(kappa);
    }
  }
  return rates;
}

/// The rates from the points p(t): κ = p′ × p″ / |p′|³.
[[nodiscard]] inline CurvatureRates rates_of_curvature(const Vector2<CurveSeries>& p) {
  const CurveSeries x1 = derivative_of(p.x()), y1 = derivative_of(p.y());
  const CurveSeries square = x1 * x1 + y1 * y1;
  const CurveSeries speed = sqrt(square);
  return rates_of_curvature((x1 * derivative_of(y1) - y1 * derivative_of(x1)) / (square * speed), speed);
}

/// The curvature as a function of the arc length.
[[nodiscard]] inline CurveSeries curvature_series(const SpanPoint& point, const CurvatureRates& rates) {
  CurveSeries kappa(point.kappa);
  kappa.c[1] = point.slope;
  kappa.c[2] = rates[0] / 2;
  kappa.c[3] = rates[1] / 6;
  kappa.c[4] = rates[2] / 24;
  return kappa;
}

/// What the support function of a boundary has beyond that of its local_curve() at a place: the coefficients
/// of (φ - φ₀)⁴, (φ - φ₀)⁵ and (φ - φ₀)⁶ [m], φ₀ being the angle of the normal there. 0 for lines and
/// corners.
[[nodiscard]] std::array<double, 3> support_beyond(const SpanPoint& point, const CurvatureRates& rates,
                                                   const Curve& local);

/// The height of a boundary over its tangent at a place, a function of the distance x along it, n turned
/// +90°: the coefficients of x² to x⁶ [m]. Regular at an inflection, where the support function is not.
[[nodiscard]] std::array<double, 5> height_over_tangent(const SpanPoint& point, const CurvatureRates& rates);

}  // namespace higherpair
