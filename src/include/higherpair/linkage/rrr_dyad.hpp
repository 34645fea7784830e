#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/linkage/reach.hpp"

namespace higherpair {

/// Two links joined at C, with their other ends at known points A and B: the triangle
///     a u_a - b u_b = D,   u_a from A to C, u_b from B to C, D = B - A,   d = |D|.
/// Mode σ = +1: C lies left of the line from A to B.
///     u_a, u_b = D/d turned to (x, y):  x_a = (d² + a² - b²)/(2da),  x_b = -(d² + b² - a²)/(2db),
///     y_a = σ√(stretch·fold)/(2da),     y_b = σ√(stretch·fold)/(2db),
///     sin of the angle from u_a to u_b = σ√(stretch·fold)/(2ab): the determinant of the closure.
template <class T>
struct RrrPosition {
  Rotation<T> u_a;
  Rotation<T> u_b;
  T sine{0};  ///< u_a × u_b
};

template <class T>
struct RrrRates {
  T omega_a{0};
  T omega_b{0};
  T alpha_a{0};
  T alpha_b{0};
};

/// The two directions. `reach` is supplied by the caller, who may know it more accurately than it follows
/// from |D|.
/// Where d = 0 (then a = b, and every direction closes) the limit for D along +x is given:
/// u_a = u_b = (0, σ).
/// \pre a > 0, b > 0.
template <class T>
[[nodiscard]] RrrPosition<T> rrr_position(const Vector2<T>& D, T a, T b, const Reach<T>& reach, T sigma) {
  using std::sqrt;
  const T d2 = D.x() * D.x() + D.y() * D.y();
  const T d = sqrt(d2);
  const auto apart = d2 > T(0);
  const T inv_d = safe_inverse(d);
  const Rotation<T> h{select(apart, D.x() * inv_d, T(1)), D.y() * inv_d};

  const T root = sigma * root_of(reach);
  const T shift = (a - b) * (a + b) * inv_d;
  const T half_a = T(0.5) / a;
  const T half_b = T(0.5) / b;
  const T height = root * inv_d;
  const Rotation<T> local_a{(d + shift) * half_a, select(apart, height * half_a, sigma)};
  const Rotation<T> local_b{(shift - d) * half_b, select(apart, height * half_b, sigma)};
  // A link much shorter than d gets its direction from cancelling terms: normalise it again.
  return {h * local_a.normalised(), h * local_b.normalised(), T(2) * root * half_a * half_b};
}

/// Their rates from the first and second derivative of D:
///     ω_a = Ḋ·u_b/(a s),   α_a = (D̈·u_b + a ω_a² c - b ω_b²)/(a s),
///     ω_b = Ḋ·u_a/(b s),   α_b = (D̈·u_a + a ω_a² - b ω_b² c)/(b s),   s = u_a × u_b, c = u_a · u_b.
/// Finite but meaningless where s = 0.
template <class T>
[[nodiscard]] RrrRates<T> rrr_rates(const RrrPosition<T>& position, T a, T b, const Vector2<T>& D_dot,
                                    const Vector2<T>& D_ddot) {
  const Rotation<T>& u_a = position.u_a;
  const Rotation<T>& u_b = position.u_b;
  const auto dot = [](const Rotation<T>& u, const Vector2<T>& v) { return u.cos * v.x() + u.sin * v.y(); };
  const T inv_s = safe_inverse(position.sine);
  const T gain_a = inv_s / a;
  const T gain_b = inv_s / b;
  const T c = u_a.cos * u_b.cos + u_a.sin * u_b.sin;

  RrrRates<T> rates;
  rates.omega_a = dot(u_b, D_dot) * gain_a;
  rates.omega_b = dot(u_a, D_dot) * gain_b;
  const T pull_a = a * rates.omega_a * rates.omega_a;
  const T pull_b = b * rates.omega_b * rates.omega_b;
  rates.alpha_a = (dot(u_b, D_ddot) + pull_a * c - pull_b) * gain_a;
  rates.alpha_b = (dot(u_a, D_ddot) + pull_a - pull_b * c) * gain_b;
  return rates;
}

/// The reach of a dyad between two points: stretch = (a+b)² - d², fold = d² - (a-b)², each as a product.
/// \param extent  largest coordinate that D was computed from [m]: its rounding limits the precision of the
/// points
template <class T>
[[nodiscard]] Reach<T> rrr_reach(const Vector2<T>& D, T a, T b, T extent) {
  using std::sqrt;
  const T d = sqrt(D.x() * D.x() + D.y() * D.y());
  const T sum = a + b;
  const T difference = a - b;
  const T eps(kEpsilonOf<T>);
  return {(sum - d) * (sum + d), (d - difference) * (d + difference),
          T(kReachRoundings) * eps * (d * (d + extent) + eps * sum * sum)};
}

}  // namespace higherpair
