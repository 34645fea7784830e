#pragma once

#include "higherpair/geometry/curve.hpp"
#include "higherpair/geometry/expansion.hpp"
#include "higherpair/geometry/tolerances.hpp"

#include <cassert>
#include <cmath>

namespace higherpair {

/// \cond
namespace detail {

// The series of R_F and R_D for nearly equal arguments, about their means (DLMF 19.36.1, 19.36.2).
template <class T>
[[nodiscard]] T rf_series(const T& x, const T& y, const T& z) {
  using std::sqrt;
  const T mean = (x + y + z) / 3.0;
  const T X = 1.0 - x / mean;
  const T Y = 1.0 - y / mean;
  const T Z = -X - Y;
  const T E2 = X * Y - Z * Z;
  const T E3 = X * Y * Z;
  const T series = 1.0 - E2 / 10.0 + E3 / 14.0 + E2 * E2 / 24.0 - 3.0 * E2 * E3 / 44.0 -
                   5.0 * E2 * E2 * E2 / 208.0 + 3.0 * E3 * E3 / 104.0 + E2 * E2 * E3 / 16.0;
  return series / sqrt(mean);
}

template <class T>
[[nodiscard]] T rd_series(const T& x, const T& y, const T& z) {
  using std::sqrt;
  const T mean = (x + y + 3.0 * z) / 5.0;
  const T X = 1.0 - x / mean;
  const T Y = 1.0 - y / mean;
  const T Z = -(X + Y) / 3.0;
  const T XY = X * Y;
  const T E2 = XY - 6.0 * Z * Z;
  const T E3 = (3.0 * XY - 8.0 * Z * Z) * Z;
  const T E4 = 3.0 * (XY - Z * Z) * Z * Z;
  const T E5 = XY * Z * Z * Z;
  const T series = 1.0 - 3.0 * E2 / 14.0 + E3 / 6.0 + 9.0 * E2 * E2 / 88.0 - 3.0 * E4 / 22.0 -
                   9.0 * E2 * E3 / 52.0 + 3.0 * E5 / 26.0 - E2 * E2 * E2 / 16.0 + 3.0 * E3 * E3 / 40.0 +
                   3.0 * E2 * E4 / 20.0 + 45.0 * E2 * E2 * E3 / 272.0 - 9.0 * (E3 * E4 + E2 * E5) / 68.0;
  return series / (mean * sqrt(mean));
}

// Arc length from the vertex to the normal turned by the angle of cosine c and sine s, |angle| <= π/2, from
// R_F and R_D of (c², 1, w²) by duplication (DLMF 19.26.18, 19.26.20), with the same square roots for both,
// until the arguments differ by at most 1 %: the series then leave out less than 1e-16. \pre c >= 0: c itself
// serves as the first square root, since the derivative of √c² at c = 0 would be lost. \param w2  w² = c² + q
// s²
template <class T>
[[nodiscard]] T arc_from_vertex(const T& semi_latus, const T& q, const T& c, const T& s, const T& w2) {
  using std::sqrt;
  T x = c * c;
  T y(1.0);
  T z = w2;
  assert(z > T(0.0));
  T root_x = c;
  T sum(0.0);
  double quarter_power = 1;
  while (true) {
    const T& largest = x > y ? (x > z ? x : z) : (y > z ? y : z);
    const T& smallest = x < y ? (x < z ? x : z) : (y < z ? y : z);
    if (!(T(largest - smallest) > T(kNearlyEqualRoots * largest))) {
      break;
    }
    const T root_y = sqrt(y);
    const T root_z = sqrt(z);
    const T lambda = root_x * root_y + (root_x + root_y) * root_z;
    sum += quarter_power / (root_z * (z + lambda));
    quarter_power /= 4;
    x = (x + lambda) / 4.0;
    y = (y + lambda) / 4.0;
    z = (z + lambda) / 4.0;
    root_x = sqrt(x);
  }
  const T rd = 3.0 * sum + quarter_power * rd_series(x, y, z);
  return semi_latus * s * (rf_series(x, y, z) + (1.0 - q) / 3.0 * s * s * rd);
}

// With w² from c and s.
template <class T>
[[nodiscard]] T arc_from_vertex(const T& semi_latus, const T& q, const T& c, const T& s) {
  return arc_from_vertex(semi_latus, q, c, s, T(c * c + q * s * s));
}

}  // namespace detail
/// \endcond

/// Arc length of a conic from its vertex to the point whose convex-side normal is turned by ψ from the normal
/// at the vertex, positive for ψ > 0 (counter-clockwise) [m].
///     s(ψ) = ℓ ∫₀^ψ dτ / (cos²τ + q sin²τ)^{3/2}
///          = ℓ [ sin ψ R_F(cos²ψ, w², 1) + (1 - q)/3 sin³ψ R_D(cos²ψ, 1, w²) ],   w² = cos²ψ + q sin²ψ
/// by Carlson's symmetric integrals (DLMF 19.25.14 with the characteristic equal to k² = 1 - q): one form for
/// circle, ellipse, parabola and hyperbola. For an ellipse it continues over any number of turns.
/// \tparam T   double, or an Expansion
/// \param psi  [rad]; for a parabola or hyperbola within its cone of normals
template <class T>
[[nodiscard]] T conic_arc_length(const T& semi_latus, const T& q, const T& psi) {
  using std::cos;
  using std::sin;
  if (q == T(1.0)) {
    return semi_latus * psi;
  }
  const T cosine = cos(psi);
  const T sine = sin(psi);
  if (q <= T(0.0)) {
    return detail::arc_from_vertex(semi_latus, q, cosine, sine);
  }
  // Half turns are taken off by the signs of cos and sin, which reduce the angle with all digits of π: at the
  // tips of a thin ellipse a rounding error of the angle would be a noticeable length.
  double half_turns = std::round(value_of(psi) / kPi);
  const double sign = std::fmod(half_turns, 2) == 0 ? 1 : -1;
  T c = sign * cosine;
  T s = sign * sine;
  if (c < T(0.0)) {
    half_turns += s > T(0.0) ? 1 : -1;
    c = -c;
    s = -s;
  }
  const T arc = detail::arc_from_vertex(semi_latus, q, c, s);
  return half_turns == 0 ? arc
                         : arc + 2 * half_turns * detail::arc_from_vertex(semi_latus, q, T(0.0), T(1.0));
}

/// The same for a parabola or hyperbola, from the point itself: x along the axis and y along the normal at
/// the vertex turned +90°, from the vertex [m]. Far out, where a rounding error of ψ is a noticeable length,
/// this form keeps its digits, with Y = y/ℓ = sin ψ/w or, where x is the larger one, Y² = (2x - q x²/ℓ)/ℓ:
///     sin²ψ = Y²/(1 + (1 - q) Y²),   w² = 1/(1 + (1 - q) Y²).
/// \pre q <= 0
template <class T>
[[nodiscard]] T open_arc_length(const T& semi_latus, const T& q, const T& x, const T& y) {
  using std::sqrt;
  T Y = y / semi_latus;
  if (x > semi_latus) {
    const T longer = sqrt(T((2.0 * x - q * x * x / semi_latus) / semi_latus));
    Y = y > T(0.0) ? longer : T(-longer);
  }
  const T per_w2 = 1.0 + (1.0 - q) * Y * Y;
  const T cosine = sqrt(T((1.0 - q * Y * Y) / per_w2));
  return detail::arc_from_vertex(semi_latus, q, cosine, T(Y / sqrt(per_w2)), T(1.0 / per_w2));
}

/// The same for any curve; lines and points: 0.
[[nodiscard]] double arc_length(const Curve& curve, double psi);

/// The angle of the convex-side normal at the vertex in the body's frame [rad], in (-π, π]: opposite to
/// axis_B.
[[nodiscard]] double vertex_normal_angle(const Curve& curve);

}  // namespace higherpair
