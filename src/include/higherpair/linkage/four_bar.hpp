#pragma once

#include "higherpair/linkage/reach.hpp"

namespace higherpair {

/// A four-bar: crank 2 and rocker 4 on ground 1, coupler 3 between them,
///     r2 e^{iθ2} + r3 e^{iθ3} = r1 e^{iθ1} + r4 e^{iθ4},
/// θ2 from ground pivot O2 to A, θ3 from A to B, θ1 from O2 to O4, θ4 from O4 to B.
///
/// The loop is symmetric in 2 and 3, so a drive at the coupler equals a drive at the crank with the two
/// exchanged. With M the driven link and J the other of the two, mode σ = +1 is
///     θ4 = (direction from O4 to the end of M) + σ (angle of the triangle at O4),
/// the sign of the square root in tan(θ4/2), and of sin(θJ - θ4).
///
/// \pre All lengths are finite, >= 0, and r3, r4 (driven by the coupler: r2, r4) are > 0: a link of no length
/// has no direction to solve for. r1 = 0 is a triangle that turns as a whole.
struct FourBar {
  double r1 = 0;  ///< [m]
  double r2 = 0;
  double r3 = 0;
  double r4 = 0;
  double theta1 = 0;  ///< direction of the ground link [rad]
};

/// A link of the four-bar by its number.
enum class FourBarLink { kFrame = 1, kCrank = 2, kCoupler = 3, kRocker = 4 };

/// The lengths and quantities that do not change with the driver. Index M: driven link, J: the other one.
template <class T>
struct FourBarLoop {
  T r1{0};
  T r_M{0};
  T r_J{0};
  T r4{0};
  CosineLine<T> stretch;  ///< (r_J + r4)² - d², over the angle from ground to M; d: from M's end to O4
  CosineLine<T> fold;     ///< d² - (r_J - r4)²
};

/// Both end values of either line are products of balanced sums, exactly zero at a change point.
template <class T>
[[nodiscard]] FourBarLoop<T> make_four_bar_loop(T r1, T r_M, T r_J, T r4) {
  return {r1,
          r_M,
          r_J,
          r4,
          make_cosine_line(balance(r_J, r4, -r1, r_M) * balance(r_J, r4, r1, -r_M),
                           balance(r_J, r4, -r1, -r_M) * balance(r_J, r4, r1, r_M), T(-2) * r1 * r_M),
          make_cosine_line(balance(r1, -r_M, -r_J, r4) * balance(r1, -r_M, r_J, -r4),
                           balance(r1, r_M, -r_J, r4) * balance(r1, r_M, r_J, -r4), T(2) * r1 * r_M)};
}

}  // namespace higherpair
