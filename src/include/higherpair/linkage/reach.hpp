#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/linkage/status.hpp"
#include "higherpair/linkage/tolerances.hpp"
#include "higherpair/numeric/scalar.hpp"

#include <algorithm>

namespace higherpair {

/// The sum of four lengths with signs, correct to its last digit even where they cancel; exactly zero where
/// they balance to within rounding (`kBalanceRoundings`), so that a change point remains one in binary
/// numbers.
template <class T>
[[nodiscard]] T balance(T a, T b, T c, T d) {
  using std::abs;
  // Knuth's error-free sum: s + error == x + y exactly.
  const auto error_of = [](T x, T y, T s) {
    const T y_part = s - x;
    return (x - (s - y_part)) + (y - y_part);
  };
  const T ab = a + b;
  const T cd = c + d;
  const T abcd = ab + cd;
  const T sum = abcd + (error_of(ab, cd, abcd) + (error_of(a, b, ab) + error_of(c, d, cd)));
  const T size = (abs(a) + abs(b)) + (abs(c) + abs(d));
  return select(abs(sum) <= T(kBalanceRoundings * kEpsilonOf<T>) * size, T(0), sum);
}

/// A quantity that is linear in the cosine of an angle ψ, at_mid - half_swing cos ψ. It is represented by
/// three values to keep its digits where they might cancel: at a change point a reach vanishes at ψ = 0 or π,
/// and near a quarter turn cos ψ itself is small and accurate.
template <class T>
struct CosineLine {
  T at_0{0};
  T at_mid{0};  ///< at ψ = ±π/2
  T at_pi{0};
  T half_swing{0};  ///< (at_pi - at_0)/2

  /// \param psi      the angle ψ
  /// \param versine  1 - |cos ψ| without cancellation: `versine_of(psi)`.
  [[nodiscard]] T at(const Rotation<T>& psi, T versine) const {
    const T near_end = half_swing * versine;
    return select(versine > T(0.5), at_mid - half_swing * psi.cos,
                  select(psi.cos >= T(0), at_0 + near_end, at_pi - near_end));
  }
};

/// From its values at ψ = 0 and π, and half of their difference, which the caller knows without cancellation.
template <class T>
[[nodiscard]] CosineLine<T> make_cosine_line(T at_0, T at_pi, T half_swing) {
  return {at_0, T(0.5) * (at_0 + at_pi), at_pi, half_swing};
}

/// 1 - |cos ψ| = sin²ψ/(1 + |cos ψ|).
template <class T>
[[nodiscard]] T versine_of(const Rotation<T>& psi) {
  using std::abs;
  return psi.sin * psi.sin / (T(1) + abs(psi.cos));
}

/// The reach at ψ. Its noise is d(reach)/dψ times a few roundings of a radian; close to ψ = 0 and π, where
/// that derivative vanishes, ψ itself is assumed known to one rounding.
template <class T>
[[nodiscard]] Reach<T> reach_at(const CosineLine<T>& stretch, const CosineLine<T>& fold,
                                const Rotation<T>& psi) {
  using std::abs;
  const T versine = versine_of(psi);
  const T eps(kEpsilonOf<T>);
  return {stretch.at(psi, versine), fold.at(psi, versine),
          T(kReachRoundings) * eps * abs(fold.half_swing) * (abs(psi.sin) + eps)};
}

/// √(stretch · fold), and 0 where one of them is negative.
template <class T>
[[nodiscard]] T root_of(const Reach<T>& reach) {
  using std::max;
  using std::sqrt;
  return sqrt(max(reach.stretch, T(0)) * max(reach.fold, T(0)));
}

/// 1/x, but 1 at x = 0: keeps results finite that must not be used.
template <class T>
[[nodiscard]] T safe_inverse(T x) {
  return T(1) / select(x == T(0), T(1), x);
}

}  // namespace higherpair
