#pragma once

#include "higherpair/geometry/pose.hpp"

#include <algorithm>

namespace higherpair {

/// A straight guide that moves with a body: the line P + s u, expressed in ground W.
struct GuideMotion {
  PointMotion P;       ///< the body's point at s = 0
  Rotation<double> u;  ///< unit direction of growing s
  double omega = 0;    ///< of the body [rad/s]
  double alpha = 0;    ///< of the body [rad/s²]
};

/// The guide through p_B along angle u_B, both in the frame of the body that carries it.
[[nodiscard]] inline GuideMotion guide_motion(const BodyMotion& body, const Vector2d& p_B,
                                              const Rotation<double>& u_B) {
  return {point_motion(body, p_B), body.X_WB.R_WB * u_B, body.omega, body.alpha};
}

/// Motion of a point relative to a guide: axes x along u, y to its left, origin at P.
struct SeenMotion {
  Vector2d p = Vector2d::Zero();  ///< [m]
  Vector2d v = Vector2d::Zero();  ///< [m/s]
  Vector2d a = Vector2d::Zero();  ///< [m/s²]
};

/// With Δ the differences from P in the guide's axes:
///     v = Δv - ω ẑ×p,   a = Δa - α ẑ×p + ω² p - 2ω ẑ×v  (the last is the Coriolis term).
[[nodiscard]] inline SeenMotion seen_from(const GuideMotion& guide, const PointMotion& point) {
  const Rotation<double> R_GW = guide.u.inverse();
  const double square = guide.omega * guide.omega;
  SeenMotion seen;
  seen.p = R_GW * Vector2d(point.p_W - guide.P.p_W);
  seen.v = R_GW * Vector2d(point.v_W - guide.P.v_W) - guide.omega * perp(seen.p);
  seen.a = R_GW * Vector2d(point.a_W - guide.P.a_W) - guide.alpha * perp(seen.p) + square * seen.p -
           2 * guide.omega * perp(seen.v);
  return seen;
}

/// The motion of a point that slides on the guide, at s with ṡ, s̈: the inverse of `seen_from` for (s, 0).
[[nodiscard]] inline PointMotion slide_motion(const GuideMotion& guide, double s, double s_dot,
                                              double s_ddot) {
  const Vector2d u(guide.u.cos, guide.u.sin);
  const double across = guide.alpha * s + 2 * guide.omega * s_dot;
  const double along = s_ddot - guide.omega * guide.omega * s;
  return {guide.P.p_W + s * u, guide.P.v_W + s_dot * u + guide.omega * s * perp(u),
          guide.P.a_W + along * u + across * perp(u)};
}

/// The largest coordinate of two points [m]: rounding of it limits the precision of what is computed from
/// them.
[[nodiscard]] inline double extent_of(const Vector2d& p_W, const Vector2d& q_W) {
  return std::max(p_W.cwiseAbs().maxCoeff(), q_W.cwiseAbs().maxCoeff());
}

}  // namespace higherpair
