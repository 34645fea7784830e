#pragma once

#include "higherpair/linkage/four_bar.hpp"
#include "higherpair/linkage/rrr_dyad.hpp"
#include "linkage/driver_range.hpp"

#include <optional>

namespace higherpair {

struct FourBarRates {
  double omega2 = 0;  ///< [rad/s]
  double omega3 = 0;
  double omega4 = 0;
  double alpha2 = 0;  ///< [rad/s²]
  double alpha3 = 0;
  double alpha4 = 0;
};

struct FourBarMotion {
  LinkageStatus status = LinkageStatus::kNotAssemblable;
  double theta2 = 0;  ///< [rad]; the driver's as given, the others in (-π, π]
  double theta3 = 0;
  double theta4 = 0;
  std::optional<FourBarRates> rates;  ///< with kOk only
};

/// Driven by the crank. kSingular: links 3 and 4 are parallel to within rounding (a limit position of the
/// crank or a change point); if A also coincides with O4, one of infinitely many positions is returned.
[[nodiscard]] FourBarMotion four_bar_by_crank(const FourBar& linkage, const AngleMotion& link2,
                                              AssemblyMode mode);

/// Driven by the coupler. kSingular: links 2 and 4 are parallel to within rounding.
[[nodiscard]] FourBarMotion four_bar_by_coupler(const FourBar& linkage, const AngleMotion& link3,
                                                AssemblyMode mode);

/// The angles θ2 (θ3) that can be assembled. At a limit the diagonal is r3 + r4 or |r3 - r4| (r2 ± r4).
[[nodiscard]] DriverRange four_bar_crank_range(const FourBar& linkage);
[[nodiscard]] DriverRange four_bar_coupler_range(const FourBar& linkage);

/// \name Kernel: unit vectors in the frame of the ground link (x from O2 to O4), no trigonometric functions.
/// @{

template <class T>
struct FourBarPosition {
  RrrPosition<T> links;  ///< u_a: link J, u_b: link 4
  Reach<T> reach;
};

/// \param u_M    direction of the driven link
/// \param sigma  ±1, the assembly mode
template <class T>
[[nodiscard]] FourBarPosition<T> four_bar_position(const FourBarLoop<T>& loop, const Rotation<T>& u_M,
                                                   T sigma) {
  using std::copysign;
  const Reach<T> reach = reach_at(loop.stretch, loop.fold, u_M);
  // r1 - r_M cos, without cancellation where the driven link lies on the ground link.
  const T r_M = copysign(loop.r_M, u_M.cos);
  const Vector2<T> D((loop.r1 - r_M) + r_M * versine_of(u_M), -loop.r_M * u_M.sin);
  return {rrr_position(D, loop.r_J, loop.r4, reach, -sigma), reach};
}

/// omega_a, alpha_a: link J; omega_b, alpha_b: link 4.
template <class T>
[[nodiscard]] RrrRates<T> four_bar_rates(const FourBarLoop<T>& loop, const FourBarPosition<T>& position,
                                         const Rotation<T>& u_M, T omega_M, T alpha_M) {
  const T v = loop.r_M * omega_M;
  const T a_t = loop.r_M * alpha_M;
  const T a_n = v * omega_M;
  const Vector2<T> D_dot(v * u_M.sin, -v * u_M.cos);
  const Vector2<T> D_ddot(a_t * u_M.sin + a_n * u_M.cos, a_n * u_M.sin - a_t * u_M.cos);
  return rrr_rates(position.links, loop.r_J, loop.r4, D_dot, D_ddot);
}
/// @}

}  // namespace higherpair
