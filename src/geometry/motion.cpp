#include "higherpair/geometry/pose.hpp"

namespace higherpair {

BodyMotion compose(const BodyMotion& motion_WC, const BodyMotion& motion_CB) {
  const Rotation<double>& R_WC = motion_WC.X_WB.R_WB;
  const double omega = motion_WC.omega;
  const Vector2d r_W = R_WC * motion_CB.X_WB.p_WB;
  const Vector2d v_W = R_WC * motion_CB.v_WB;
  BodyMotion body;
  body.X_WB = {R_WC * motion_CB.X_WB.R_WB, motion_WC.X_WB.p_WB + r_W};
  body.theta = motion_WC.theta + motion_CB.theta;
  body.v_WB = motion_WC.v_WB + omega * perp(r_W) + v_W;
  body.omega = omega + motion_CB.omega;
  body.a_WB = motion_WC.a_WB + motion_WC.alpha * perp(r_W) - omega * omega * r_W + 2 * omega * perp(v_W) +
              R_WC * motion_CB.a_WB;
  body.alpha = motion_WC.alpha + motion_CB.alpha;
  return body;
}

}  // namespace higherpair
