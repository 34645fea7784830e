#include "higherpair/geometry/curvature_rates.hpp"

#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/geometry/support.hpp"

#include <array>

namespace higherpair {

// With δρ(φ) = Σ d_k (φ - φ₀)ᵏ, the difference of the radii, h + h″ = δρ determines the coefficients of h one
// after the other.
std::array<double, 3> support_beyond(const SpanPoint& point, const CurvatureRates& rates,
                                     const Curve& local) {
  if (!is_conic(local)) {
    return {};
  }
  CurveSeries phi(angle_of(point.n_B));
  phi.c[1] = 1;
  const Vector2<CurveSeries> n(cos(phi), sin(phi));
  const CurveSeries rho_of_conic = support_point(place(local, Pose<CurveSeries>{}), n).rho;
  // Derivatives of ρ with respect to φ: d/dφ = (1/κ) d/ds.
  const CurveSeries kappa = curvature_series(point, rates);
  CurveSeries derivative = CurveSeries(1) / kappa;
  std::array<double, 5> d{};
  double factorial = 1;
  for (std::size_t k = 0; k < d.size(); ++k) {
    factorial *= k > 0 ? static_cast<double>(k) : 1;
    d[k] = value_of(derivative) / factorial - rho_of_conic.c[k];
    derivative = derivative_of(derivative) / kappa;
  }
  const double h4 = d[2] / 12;
  return {h4, d[3] / 20, (d[4] - h4) / 30};
}

// With the tangent turned by ψ = ∫ κ ds, the height falls by sin ψ ds over cos ψ ds.
std::array<double, 5> height_over_tangent(const SpanPoint& point, const CurvatureRates& rates) {
  const CurveSeries kappa = curvature_series(point, rates);
  CurveSeries psi;
  for (std::size_t k = 0; k + 1 < psi.c.size(); ++k) {
    psi.c[k + 1] = kappa.c[k] / static_cast<double>(k + 1);
  }
  CurveSeries derivative = -sin(psi) / cos(psi);  // by x: d/dx = (1/cos ψ) d/ds
  std::array<double, 5> height{};
  double factorial = 1;
  for (std::size_t k = 0; k < height.size(); ++k) {
    derivative = derivative_of(derivative) / cos(psi);
    factorial *= static_cast<double>(k + 2);
    height[k] = value_of(derivative) / factorial;
  }
  return height;
}

}  // namespace higherpair
