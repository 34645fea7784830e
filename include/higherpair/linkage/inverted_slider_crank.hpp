#pragma once

#include "higherpair/linkage/driver.hpp"
#include "higherpair/linkage/rrp_dyad.hpp"

#include <optional>

namespace higherpair {

/// An inverted slider-crank: crank 2 about O1 carries a pin C, and the pin runs in a straight slot (or
/// touches as a flat face's contact does) of a body 3 that turns about O2,
///     r2 e^{iθ2} = r1 e^{iθ1} + r3 e^{iθ3} + r4 e^{i(θ3 + 90°)}.
/// θ1 from O1 to O2, θ3 the slot's direction; r3 the pin's coordinate along the slot from the foot of O2 on
/// it; the offset r4 of the slot from O2 has a sign, positive where the slot lies left of θ3.
///
/// Mode σ = +1, driven by
/// - the crank: the pin is ahead of the foot of O2: r3 > 0;
/// - the slot: cos(θ2 - θ3) > 0: of the two points in which the pin's circle meets the slot the one ahead.
///
/// \pre r1, r2 finite and >= 0; driven by the slot r2 > 0.
struct InvertedSliderCrank {
  double r1 = 0;      ///< [m]
  double r2 = 0;      ///< [m]
  double r4 = 0;      ///< offset [m], with sign
  double theta1 = 0;  ///< direction of the ground link [rad]
};

struct InvertedSliderCrankRates {
  double omega2 = 0;  ///< [rad/s]
  double omega3 = 0;
  double r3_dot = 0;  ///< [m/s]
  double alpha2 = 0;  ///< [rad/s²]
  double alpha3 = 0;
  double r3_ddot = 0;  ///< [m/s²]
};

struct InvertedSliderCrankMotion {
  LinkageStatus status = LinkageStatus::kNotAssemblable;
  double theta2 = 0;  ///< [rad]; the driver's as given, the other in (-π, π]
  double theta3 = 0;
  double r3 = 0;                                  ///< [m]
  std::optional<InvertedSliderCrankRates> rates;  ///< with kOk only
};

/// Driven by the crank. kSingular: r3 = 0 to rounding (the slot stands across the line from O2 to the pin).
/// With r4 = 0 this is where the pin meets O2: then one of infinitely many positions is given.
[[nodiscard]] InvertedSliderCrankMotion inverted_slider_crank_by_crank(const InvertedSliderCrank& linkage,
                                                                       const AngleMotion& link2,
                                                                       AssemblyMode mode);

/// Driven by the slot. kSingular: the crank stands across the slot to rounding.
[[nodiscard]] InvertedSliderCrankMotion inverted_slider_crank_by_slot(const InvertedSliderCrank& linkage,
                                                                      const AngleMotion& link3,
                                                                      AssemblyMode mode);

/// Where each driver can go. Limits of θ2: the pin's distance from O2 is |r4|; of θ3:
/// |r4 - r1 sin(θ3 - θ1)| = r2.
[[nodiscard]] DriverRange inverted_slider_crank_crank_range(const InvertedSliderCrank& linkage);
[[nodiscard]] DriverRange inverted_slider_crank_slot_range(const InvertedSliderCrank& linkage);

/// \name Kernel in the frame of the ground link (x from O1 to O2), driven by the crank.
/// Driven by the slot it is `rrp_dyad.hpp` in the slot's frame: arm r1 at angle θ1 - θ3 + 180°, leg r2.
/// @{

template <class T>
struct SlotLoop {
  T r1{0};
  T r2{0};
  T r4{0};
  CosineLine<T> square;  ///< r3² = d² - r4², over the angle from ground to crank; d: from O2 to the pin
};

template <class T>
struct SlotPosition {
  Rotation<T> u3;
  T r3{0};
  Reach<T> reach;  ///< stretch and fold are both r3², negative where the pin cannot reach the slot
};

template <class T>
struct SlotRates {
  T omega3{0};
  T alpha3{0};
  T r3_dot{0};
  T r3_ddot{0};
};

template <class T>
[[nodiscard]] SlotLoop<T> make_slot_loop(T r1, T r2, T r4) {
  const T none(0);
  return {r1, r2, r4,
          make_cosine_line(balance(r1, -r2, -r4, none) * balance(r1, -r2, r4, none),
                           balance(r1, r2, -r4, none) * balance(r1, r2, r4, none), T(2) * r1 * r2)};
}

/// u3 = D turned back by the angle of (r3, r4), D = r3 u3 + r4 u4 from O2 to the pin; D = 0: u3 along +x.
template <class T>
[[nodiscard]] SlotPosition<T> slot_position(const SlotLoop<T>& loop, const Rotation<T>& u2, T sigma) {
  using std::copysign;
  using std::max;
  using std::sqrt;
  const Reach<T> reach = reach_at(loop.square, loop.square, u2);
  const T r3 = sigma * sqrt(max(reach.fold, T(0)));
  // r2 cos - r1, without cancelling where the crank lies on the ground link.
  const T r2 = copysign(loop.r2, u2.cos);
  const T x = (r2 - loop.r1) - r2 * versine_of(u2);
  const T y = loop.r2 * u2.sin;
  const T d2 = x * x + y * y;
  const T inv_d = safe_inverse(sqrt(d2));
  const T body2 = r3 * r3 + loop.r4 * loop.r4;
  const T inv_body = safe_inverse(sqrt(body2));
  const Rotation<T> pin{select(d2 > T(0), x * inv_d, T(1)), y * inv_d};
  const Rotation<T> body{select(body2 > T(0), r3 * inv_body, T(1)), loop.r4 * inv_body};
  return {(pin * body.inverse()).normalised(), r3, reach};
}

/// r3 ω3 = Ḋ·u4,  ṙ3 = Ḋ·u3 + r4 ω3,  r3 α3 = D̈·u4 - 2 ṙ3 ω3 + r4 ω3²,  r̈3 = D̈·u3 + r3 ω3² + r4 α3.
/// Finite but meaningless where r3 = 0.
template <class T>
[[nodiscard]] SlotRates<T> slot_rates(const SlotLoop<T>& loop, const SlotPosition<T>& position,
                                      const Rotation<T>& u2, T omega2, T alpha2) {
  const Rotation<T> u = u2 * position.u3.inverse();  // the crank seen from the slot
  const T v = loop.r2 * omega2;
  const T a_t = loop.r2 * alpha2;
  const T a_n = v * omega2;
  const T inv = safe_inverse(position.r3);
  SlotRates<T> rates;
  rates.omega3 = v * u.cos * inv;
  rates.r3_dot = loop.r4 * rates.omega3 - v * u.sin;
  const T square = rates.omega3 * rates.omega3;
  rates.alpha3 = (a_t * u.cos - a_n * u.sin - T(2) * rates.r3_dot * rates.omega3 + loop.r4 * square) * inv;
  rates.r3_ddot = loop.r4 * rates.alpha3 + position.r3 * square - a_t * u.sin - a_n * u.cos;
  return rates;
}
/// @}

}  // namespace higherpair
