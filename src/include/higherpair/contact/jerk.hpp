#pragma once

#include "higherpair/contact/common_normal.hpp"

#include <array>

namespace higherpair {

/// The condition on the jerks of two bodies that maintain a contact. n out of body 1, t = n turned +90°; u1,
/// u2 speeds of the contact point along each curve, φ the angle of n, v_s the sliding velocity (see
/// ContactRates).
struct ContactJerk {
  double linkage_normal_jerk = 0;  ///< n·(j2 - j1) of the equivalent linkage frozen at this instant [m/s³]
  /// Contribution of each curve to it, -κ1' u1³ and κ2' u2³ [m/s³].
  std::array<double, 2> rate_of_curvature{};

  /// n·(j2 - j1) of the material points at the contact that maintains it [m/s³].
  [[nodiscard]] double normal_jerk() const {
    return linkage_normal_jerk + rate_of_curvature[0] + rate_of_curvature[1];
  }
};

/// The condition n·(v2 - v1) = 0 at the moving contact point differentiated twice. With v_r = v2 - v1 and
/// a_s = t·(a2 - a1) = v̇_s of the material points at the contact, ω_r = ω2 - ω1, α_r = α2 - α1, the weights
/// w1, w2, w, z of the equivalent link, and κi' = dκi/ds along each curve's own outward normal turned
/// +90°:
///     u̇1 = z α_r + w2 a_s + C,   u̇2 = z α_r - w1 a_s + C,   C = z (κ2' u2² - κ1' u1²),
///     φ̈ = α1 + w1 α_r + w a_s + w2 κ1' u1² + w1 κ2' u2²,
///     n·(j2 - j1) = 2 (α2 u2 - α1 u1) + ω2 u̇2 - ω1 u̇1 - 2 φ̇ a_s - v_s φ̈,
/// in which the terms with κ' combine to κ2' u2³ - κ1' u1³. They vanish for a line, a point, a circle, and at
/// a vertex of a conic: there the jerk of the equivalent linkage is the true one. At an inflection nothing
/// becomes infinite.
/// Uses only the velocities and accelerations of the bodies. \pre They maintain the contact.
[[nodiscard]] ContactJerk contact_jerk(const Curve& curve1, const Curve& curve2, const CommonNormal& at,
                                       const BodyMotion& body1, const BodyMotion& body2);

}  // namespace higherpair
