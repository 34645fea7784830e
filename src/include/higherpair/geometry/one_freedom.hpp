#pragma once

#include "higherpair/geometry/pose.hpp"

namespace higherpair {

/// A body with one freedom, left by its joint to ground, and its coordinate q: turning about a pivot (q:
/// angle of the body's frame [rad]) or sliding along a line (q: displacement [m]).
struct OneFreedom {
  bool turns = true;
  Vector2d p_WO = Vector2d::Zero();          ///< pivot, or the point of the line where q = 0 [m]
  Vector2d p_BO = Vector2d::Zero();          ///< the body's point at the joint, in the body's frame [m]
  Vector2d direction_W = Vector2d::UnitX();  ///< sliding: unit direction of growing q
  double theta = 0;                          ///< sliding: angle of the body's frame [rad]
  Rotation<double> R_WB;                     ///< sliding: the same as a rotation
};

/// The pose at the coordinate q.
/// \param turn  the rotation by q, ignored for a sliding body
[[nodiscard]] inline Pose<double> pose_at(const OneFreedom& freedom, double q, const Rotation<double>& turn) {
  if (freedom.turns) {
    return {turn, freedom.p_WO - turn * freedom.p_BO};
  }
  return {freedom.R_WB, freedom.p_WO + q * freedom.direction_W - freedom.R_WB * freedom.p_BO};
}

/// The same; finds the rotation itself.
[[nodiscard]] inline Pose<double> pose_at(const OneFreedom& freedom, double q) {
  return pose_at(freedom, q, freedom.turns ? Rotation<double>::from_angle(q) : Rotation<double>());
}

/// Velocity of the body's material point at p_W for dq/dt = 1.
[[nodiscard]] inline Vector2d velocity_per_q(const OneFreedom& freedom, const Vector2d& p_W) {
  return freedom.turns ? perp(Vector2d(p_W - freedom.p_WO)) : freedom.direction_W;
}

/// Acceleration of the body's material point at p_W for dq/dt = 1, d²q/dt² = 0: towards the pivot; 0 when
/// sliding.
[[nodiscard]] inline Vector2d acceleration_per_q(const OneFreedom& freedom, const Vector2d& p_W) {
  return freedom.turns ? Vector2d(freedom.p_WO - p_W) : Vector2d::Zero();
}

/// Sets the rates of a body whose pose is known, from the first two time derivatives of its coordinate.
inline void set_rates_at(const OneFreedom& freedom, double q_dot, double q_ddot, BodyMotion& body) {
  body.omega = freedom.turns ? q_dot : 0;
  body.alpha = freedom.turns ? q_ddot : 0;
  const Vector2d per_q = velocity_per_q(freedom, body.X_WB.p_WB);
  body.v_WB = q_dot * per_q;
  body.a_WB = q_ddot * per_q + q_dot * q_dot * acceleration_per_q(freedom, body.X_WB.p_WB);
}

/// Motion of the body's frame for the coordinate q and its first two time derivatives.
[[nodiscard]] inline BodyMotion motion_at(const OneFreedom& freedom, double q, double q_dot, double q_ddot) {
  BodyMotion body;
  body.X_WB = pose_at(freedom, q);
  body.theta = freedom.turns ? q : freedom.theta;
  set_rates_at(freedom, q_dot, q_ddot, body);
  return body;
}

}  // namespace higherpair
