#pragma once

#include "higherpair/linkage/quick_return.hpp"
#include "higherpair/linkage/rpr_dyad.hpp"
#include "linkage/driver_range.hpp"
#include "linkage/rrp_loop.hpp"

#include <optional>

namespace higherpair {

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

/// Driven by the crank. kSingular: r3 = 0 to within rounding (the slot is perpendicular to the line from O2
/// to the pin). With r4 = 0 this is where the pin meets O2: then one of infinitely many positions is
/// returned.
[[nodiscard]] InvertedSliderCrankMotion inverted_slider_crank_by_crank(const InvertedSliderCrank& linkage,
                                                                       const AngleMotion& link2,
                                                                       AssemblyMode mode);

/// Driven by the slot. kSingular: the crank is perpendicular to the slot to within rounding.
[[nodiscard]] InvertedSliderCrankMotion inverted_slider_crank_by_slot(const InvertedSliderCrank& linkage,
                                                                      const AngleMotion& link3,
                                                                      AssemblyMode mode);

/// Where each driver can go. Limits of θ2: the pin's distance from O2 is |r4|; of θ3:
/// |r4 - r1 sin(θ3 - θ1)| = r2.
[[nodiscard]] DriverRange inverted_slider_crank_crank_range(const InvertedSliderCrank& linkage);
[[nodiscard]] DriverRange inverted_slider_crank_slot_range(const InvertedSliderCrank& linkage);

/// \name Kernel in the frame of the ground link (x from O1 to O2), driven by the crank: `rpr_dyad.hpp` with D
/// from O2 to the pin.
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
[[nodiscard]] SlotLoop<T> make_slot_loop(T r1, T r2, T r4) {
  const T none(0);
  return {r1, r2, r4,
          make_cosine_line(balance(r1, -r2, -r4, none) * balance(r1, -r2, r4, none),
                           balance(r1, r2, -r4, none) * balance(r1, r2, r4, none), T(2) * r1 * r2)};
}

/// u: the slot's direction, s = r3.
template <class T>
[[nodiscard]] RprPosition<T> slot_position(const SlotLoop<T>& loop, const Rotation<T>& u2, T sigma) {
  using std::copysign;
  const Reach<T> reach = reach_at(loop.square, loop.square, u2);
  // r2 cos - r1, without cancellation where the crank lies on the ground link.
  const T r2 = copysign(loop.r2, u2.cos);
  const Vector2<T> D((r2 - loop.r1) - r2 * versine_of(u2), loop.r2 * u2.sin);
  return rpr_position(D, loop.r4, reach, sigma);
}

template <class T>
[[nodiscard]] RprRates<T> slot_rates(const SlotLoop<T>& loop, const RprPosition<T>& position,
                                     const Rotation<T>& u2, T omega2, T alpha2) {
  const T v = loop.r2 * omega2;
  const T a_t = loop.r2 * alpha2;
  const T a_n = v * omega2;
  return rpr_rates(position, loop.r4, Vector2<T>(-v * u2.sin, v * u2.cos),
                   Vector2<T>(-a_t * u2.sin - a_n * u2.cos, a_t * u2.cos - a_n * u2.sin));
}
/// @}

}  // namespace higherpair
