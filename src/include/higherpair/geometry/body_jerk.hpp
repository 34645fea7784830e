#pragma once

#include "higherpair/geometry/pose.hpp"

namespace higherpair {

/// Third time derivatives of a body's frame, expressed in ground W.
struct BodyJerk {
  Vector2d j_WB = Vector2d::Zero();  ///< of the origin's position [m/s³]
  double angular = 0;                ///< of the angle [rad/s³]
};

/// Contribution of the body's rotation to the jerk of the material point at r from the frame's origin,
/// without the body's own jerks: -3 ω α r - ω³ ẑ×r [m/s³].
[[nodiscard]] inline Vector2d jerk_by_turning(const BodyMotion& body, const Vector2d& r_W) {
  return -3 * body.omega * body.alpha * r_W - body.omega * body.omega * body.omega * perp(r_W);
}

/// Jerk of the point p_B (body frame, [m]) that is fixed in a moving body, by differentiating its
/// acceleration: j = j_o + α̇ ẑ×r - 3 ω α r - ω³ ẑ×r [m/s³].
[[nodiscard]] inline Vector2d point_jerk(const BodyMotion& body, const BodyJerk& jerk, const Vector2d& p_B) {
  const Vector2d r_W = body.X_WB.R_WB * p_B;
  return jerk.j_WB + jerk.angular * perp(r_W) + jerk_by_turning(body, r_W);
}

}  // namespace higherpair
