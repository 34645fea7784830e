#pragma once

#include "higherpair/linkage/rrr_dyad.hpp"
#include "higherpair/linkage/slider_crank_stroke.hpp"
#include "linkage/driver_range.hpp"
#include "linkage/rrp_loop.hpp"

#include <optional>

namespace higherpair {

struct SliderCrankRates {
  double omega2 = 0;  ///< [rad/s]
  double omega3 = 0;
  double r1_dot = 0;  ///< [m/s]
  double alpha2 = 0;  ///< [rad/s²]
  double alpha3 = 0;
  double r1_ddot = 0;  ///< [m/s²]
};

struct SliderCrankMotion {
  LinkageStatus status = LinkageStatus::kNotAssemblable;
  double theta2 = 0;  ///< [rad]; the driver's as given, the others in (-π, π]
  double theta3 = 0;
  double r1 = 0;                          ///< [m]
  std::optional<SliderCrankRates> rates;  ///< with kOk only
};

/// Driven by the crank. kSingular: the coupler is perpendicular to the line to within rounding.
[[nodiscard]] SliderCrankMotion slider_crank_by_crank(const SliderCrank& linkage, const AngleMotion& link2,
                                                      AssemblyMode mode);

/// Driven by the coupler. kSingular: the crank is perpendicular to the line to within rounding.
[[nodiscard]] SliderCrankMotion slider_crank_by_coupler(const SliderCrank& linkage, const AngleMotion& link3,
                                                        AssemblyMode mode);

/// Driven by the slider. kSingular: crank and coupler are parallel to within rounding; if the slider is also
/// at O2 (r2 = r3, r4 = 0, r1 = 0), one of infinitely many positions is returned, the limit for r1 > 0.
[[nodiscard]] SliderCrankMotion slider_crank_by_slider(const SliderCrank& linkage, const SlideMotion& slider,
                                                       AssemblyMode mode);

/// Where each driver can go. Limits of θ2: |r4 - r2 sin(θ2 - θ1)| = r3; of θ3 the same with 2 and 3
/// exchanged; of r1: r1² + r4² = (r2 ± r3)².
[[nodiscard]] DriverRange slider_crank_crank_range(const SliderCrank& linkage);
[[nodiscard]] DriverRange slider_crank_coupler_range(const SliderCrank& linkage);
[[nodiscard]] DriverRange slider_crank_slider_range(const SliderCrank& linkage);

/// \name Kernel in the frame of the guide (x along θ1). Driven by crank or coupler: `rrp_dyad.hpp`.
/// @{

/// Lengths of a slider-crank driven by its slider, and quantities that do not depend on r1.
template <class T>
struct SliderLoop {
  T r2{0};
  T r3{0};
  T r4{0};
  T stretch_0{0};  ///< (r2 + r3)² - r4²: the reach at r1 = 0
  T fold_0{0};     ///< r4² - (r2 - r3)²
};

template <class T>
struct SliderPosition {
  RrrPosition<T> links;  ///< u_a: link 2; u_b: link 3 reversed
  Reach<T> reach;
};

template <class T>
[[nodiscard]] SliderLoop<T> make_slider_loop(T r2, T r3, T r4) {
  const T none(0);
  return {r2, r3, r4, balance(r2, r3, -r4, none) * balance(r2, r3, r4, none),
          balance(r4, r3, -r2, none) * balance(r4, r2, -r3, none)};
}

template <class T>
[[nodiscard]] SliderPosition<T> slider_position(const SliderLoop<T>& loop, T r1, T sigma) {
  const T square = r1 * r1;
  const T eps(kEpsilonOf<T>);
  const T size = eps * (loop.r2 + loop.r3);
  const Reach<T> reach{loop.stretch_0 - square, loop.fold_0 + square,
                       T(kReachRoundings) * (eps * square + size * size)};
  return {rrr_position(Vector2<T>(r1, loop.r4), loop.r2, loop.r3, reach, sigma), reach};
}

/// omega_a, alpha_a: link 2; omega_b, alpha_b: link 3.
template <class T>
[[nodiscard]] RrrRates<T> slider_rates(const SliderLoop<T>& loop, const SliderPosition<T>& position, T r1_dot,
                                       T r1_ddot) {
  return rrr_rates(position.links, loop.r2, loop.r3, Vector2<T>(r1_dot, T(0)), Vector2<T>(r1_ddot, T(0)));
}
/// @}

}  // namespace higherpair
