#pragma once

#include "higherpair/geometry/expansion.hpp"
#include "higherpair/geometry/pose.hpp"

#include <cmath>

namespace higherpair {

/// The vertex form of a circle or parabola; see Curve.
template <class T>
struct LocalConic {
  Vector2<T> vertex_B, axis_B;
  T semi_latus{0};
};

/// The circle of curvature of a curve at a point, with its vertex there; or the parabola that also matches
/// the rate of change of the curvature. With τ = ρ′/(3 ρ), the slope of the parabola's normal against its
/// axis:
///     |ρ| = ℓ (1 + τ²)^{3/2},   y = -ℓ τ,   x = ℓ τ²/2.
/// \param n_B  outward normal \param kappa  curvature, not 0 \param slope  dκ/ds along n turned +90°
template <class T>
[[nodiscard]] LocalConic<T> local_conic(const Vector2<T>& p_B, const Vector2<T>& n_B, const T& kappa,
                                        const T& slope, bool circle) {
  using std::sqrt;
  const double side = value_of(kappa) > 0 ? 1 : -1;
  const T rho = T(side) / kappa;
  const Vector2<T> N = T(side) * n_B;
  if (circle) {
    return {p_B, -N, rho};
  }
  const T tau = slope * rho * rho / T(-3);
  const T c = T(1) / sqrt(T(1) + tau * tau);
  const T semi_latus = rho * c * c * c;
  const Vector2<T> axis_B = T(tau * c) * perp(N) - c * N;
  return {p_B - T(semi_latus * tau) * Vector2<T>(T(tau / T(2)) * axis_B - perp(axis_B)), axis_B, semi_latus};
}

}  // namespace higherpair
