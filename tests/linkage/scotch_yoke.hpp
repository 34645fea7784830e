#pragma once

#include "linkage/driver_range.hpp"

#include <optional>

namespace higherpair {

/// A Scotch yoke: the pin of crank 2 runs in a straight slot of a yoke that slides along θ1,
///     r2 e^{iθ2} = r1 e^{iθ1} + r3 e^{i(θ1 + β)}.
/// r1 is the yoke's coordinate: where its slot crosses the line through O along θ1. r3 is the pin's
/// coordinate along the slot from there. β is the angle from θ1 to the slot, 90° in the common yoke.
///
/// Driven by the crank there is one assembly. Driven by the yoke, mode σ = +1 is cos(θ2 - θ1 - β) > 0: of the
/// two points in which the pin's circle meets the slot, the one farther along it.
///
/// \pre r2 finite and >= 0 (driven by the yoke > 0). The slot must cross the direction of sliding: sin β !=
/// 0.
struct ScotchYoke {
  double r2 = 0;                ///< [m]
  Rotation<double> slot{0, 1};  ///< (cos β, sin β)
  double theta1 = 0;            ///< direction of sliding [rad]
};

struct ScotchYokeRates {
  double omega2 = 0;  ///< [rad/s]
  double r1_dot = 0;  ///< [m/s]
  double r3_dot = 0;
  double alpha2 = 0;   ///< [rad/s²]
  double r1_ddot = 0;  ///< [m/s²]
  double r3_ddot = 0;
};

struct ScotchYokeMotion {
  LinkageStatus status = LinkageStatus::kNotAssemblable;
  double theta2 = 0;                     ///< [rad]; as given, or in (-π, π]
  double r1 = 0;                         ///< [m]
  double r3 = 0;                         ///< [m]
  std::optional<ScotchYokeRates> rates;  ///< with kOk only
};

/// Driven by the crank: always kOk.
[[nodiscard]] ScotchYokeMotion scotch_yoke_by_crank(const ScotchYoke& linkage, const AngleMotion& link2);

/// Driven by the yoke. kSingular: the crank is perpendicular to the slot to within rounding.
[[nodiscard]] ScotchYokeMotion scotch_yoke_by_yoke(const ScotchYoke& linkage, const SlideMotion& yoke,
                                                   AssemblyMode mode);

/// Where each driver can go: the crank turns fully; the yoke's limits are |r1 sin β| = r2.
[[nodiscard]] DriverRange scotch_yoke_crank_range(const ScotchYoke& linkage);
[[nodiscard]] DriverRange scotch_yoke_yoke_range(const ScotchYoke& linkage);

/// \name Kernel in the frame of the guide (x along θ1).
/// @{

template <class T>
struct YokePosition {
  T r1{0};
  T r3{0};
};

/// Splits a vector p = r1 (1, 0) + r3 (cos β, sin β) into r1 and r3; also used for its first and second
/// derivative.
template <class T>
[[nodiscard]] YokePosition<T> yoke_components(const Rotation<T>& slot, const Vector2<T>& p) {
  const T r3 = p.y() / slot.sin;
  return {p.x() - r3 * slot.cos, r3};
}

/// Driven by the yoke.
template <class T>
struct YokeDrivenPosition {
  Rotation<T> u2_slot;  ///< the crank's direction seen from the slot
  T r3{0};
  Reach<T> reach;  ///< stretch = r2 + r1 sin β, fold = r2 - r1 sin β: distances of the slot inside the circle
};

template <class T>
struct YokeDrivenRates {
  T omega2{0};
  T alpha2{0};
  T r3_dot{0};
  T r3_ddot{0};
};

template <class T>
[[nodiscard]] YokeDrivenPosition<T> yoke_driven_position(T r2, const Rotation<T>& slot, T r1, T sigma) {
  using std::abs;
  const T h = -r1 * slot.sin;  // r2 sin of the crank's angle from the slot
  const Reach<T> reach{r2 - h, r2 + h, T(kReachRoundings * kEpsilonOf<T>) * r2};
  const Rotation<T> u{sigma * root_of(reach) / r2, h / r2};
  return {u, r2 * u.cos - r1 * slot.cos, reach};
}

/// r2 ω2 cos = -ṙ1 sin β and r2 α2 cos = r2 ω2² sin - r̈1 sin β across the slot; r3 along it. Finite but
/// meaningless where cos = 0.
template <class T>
[[nodiscard]] YokeDrivenRates<T> yoke_driven_rates(T r2, const Rotation<T>& slot,
                                                   const YokeDrivenPosition<T>& position, T r1_dot,
                                                   T r1_ddot) {
  const Rotation<T>& u = position.u2_slot;
  const T inv = safe_inverse(r2 * u.cos);
  YokeDrivenRates<T> rates;
  rates.omega2 = -r1_dot * slot.sin * inv;
  const T pull = r2 * rates.omega2 * rates.omega2;
  rates.alpha2 = (pull * u.sin - r1_ddot * slot.sin) * inv;
  rates.r3_dot = -r2 * rates.omega2 * u.sin - r1_dot * slot.cos;
  rates.r3_ddot = -r2 * rates.alpha2 * u.sin - pull * u.cos - r1_ddot * slot.cos;
  return rates;
}
/// @}

}  // namespace higherpair
