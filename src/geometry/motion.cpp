#include "higherpair/geometry/pose.hpp"

#include <cassert>

namespace higherpair {

BodyMotion body_motion_from_points(const Vector2d& p_A, const PointMotion& a, const Vector2d& p_B,
                                   const PointMotion& b) {
  const Vector2d r_B = p_B - p_A;
  const Vector2d r_W = b.p_W - a.p_W;
  const double length2 = r_W.squaredNorm();
  assert(r_B.squaredNorm() > 0 && length2 > 0);

  BodyMotion body;
  const double scale = 1 / std::sqrt(r_B.squaredNorm() * length2);
  body.X_WB.R_WB = {scale * r_B.dot(r_W), scale * cross(r_B, r_W)};
  body.theta = std::atan2(body.X_WB.R_WB.sin, body.X_WB.R_WB.cos);
  body.omega = perp(r_W).dot(b.v_W - a.v_W) / length2;
  body.alpha = perp(r_W).dot(b.a_W - a.a_W) / length2;

  const Vector2d origin_from_A_W = body.X_WB.R_WB * Vector2d(-p_A);
  body.X_WB.p_WB = a.p_W + origin_from_A_W;
  body.v_WB = a.v_W + body.omega * perp(origin_from_A_W);
  body.a_WB = a.a_W + body.alpha * perp(origin_from_A_W) - body.omega * body.omega * origin_from_A_W;
  return body;
}

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
