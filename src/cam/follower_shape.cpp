#include "follower_shape.hpp"

#include "higherpair/geometry/curve_queries.hpp"

#include <cmath>

namespace higherpair {

std::optional<Round> round_of(const FlankOrigin& cam) {
  const auto center = round_center(cam.curve);
  if (!center) {
    return std::nullopt;
  }
  return Round{*center, cam.curve.semi_latus * (cam.curve.side == Side::kInside ? 1 : -1)};
}

Center center_at(const FlankOrigin& cam, const Round& round, const Lift& lift, double rest) {
  const CamMotion& motion = cam.motion;
  const double q = motion.follower_sign * (rest + lift.s);
  Center center;
  const Vector2d c = pose_at(motion.follower, q) * round.center_B;
  const double q1 = motion.follower_sign * motion.cam_sign * lift.v;
  center.u = velocity_per_q(motion.follower, c);
  center.v = velocity_per_q(motion.cam, c);
  center.w = q1 * center.u - center.v;
  center.a = motion.follower_sign * lift.a * center.u + q1 * q1 * acceleration_per_q(motion.follower, c);
  center.from_cam = c;
  if (motion.cam.turns) {
    center.from_cam -= motion.cam.p_WO;
    center.a += center.from_cam - 2 * perp(center.w);
  }
  return center;
}

// On a dwell w is against the motion of the cam's material. The normal then points to the pivot of a cam that
// turns; of one that slides, against the sense in which the follower's coordinate grows where the law begins.
double side_of(const FlankOrigin& cam) {
  const CamMotion& motion = cam.motion;
  const double inner = cam.outer ? -1 : 1;
  if (motion.cam.turns) {
    return inner;
  }
  const double q = motion.follower_sign * (motion.follower_rest + motion.law(motion.law.begin()));
  const Vector2d p = pose_at(motion.follower, q) * round_center(cam.curve).value_or(cam.curve.vertex_B);
  const Vector2d to_cam = -motion.follower_sign * velocity_per_q(motion.follower, p);
  return perp(motion.cam.direction_W).dot(to_cam) < 0 ? -inner : inner;
}

Inclination inclination_of(const Center& center) {
  const double speed = center.u.norm();
  return {center.w.dot(center.u) / speed, cross(center.v, center.u) / speed};
}

double pitch_curvature_at(const FlankOrigin& cam, const Center& center) {
  const double speed2 = center.w.squaredNorm();
  return -side_of(cam) * perp(center.w).dot(center.a) / (speed2 * std::sqrt(speed2));
}

SizeRange sizes_of_round(const FlankOrigin& cam, const Round& round) {
  const CamMotion& motion = cam.motion;
  const double rest = motion.follower_rest;
  const Vector2d from_cam = center_at(cam, round, {}, rest).from_cam;
  if (!motion.follower.turns) {
    const double height = from_cam.dot(motion.follower.direction_W);
    const double sense = height < 0 ? -motion.follower_sign : motion.follower_sign;
    return {rest - motion.follower_sign * height, sense, SizeRange().most, from_cam.norm() / 16};
  }
  const Vector2d to_cam = motion.cam.p_WO - motion.follower.p_WO;
  const Vector2d arm = from_cam + to_cam;
  const double angle = angle_from_to(to_cam, arm);
  return {rest - motion.follower_sign * angle, (angle < 0 ? -1 : 1) * motion.follower_sign, kPi, kPi / 64};
}

Face face_at(const FlankOrigin& cam, const Lift& lift, double rest) {
  const CamMotion& motion = cam.motion;
  const Pose<double> X = pose_at(motion.follower, motion.follower_sign * (rest + lift.s));
  const Vector2d n = X.R_WB * cam.curve.axis_B;  // out of the cam, into the follower
  const double q1 = motion.follower_sign * motion.cam_sign * lift.v;
  const double q2 = motion.follower_sign * lift.a;
  const double height = n.dot(X * cam.curve.vertex_B - motion.cam.p_WO);
  if (!motion.follower.turns) {
    return {height, height + q2 * n.dot(motion.follower.direction_W)};
  }
  const Vector2d pivots = motion.follower.p_WO - motion.cam.p_WO;
  const double across = perp(n).dot(pivots);  // d(height)/dq
  const double h1 = q1 * across, h2 = q2 * across - q1 * q1 * n.dot(pivots);
  const double turn = q1 - 1;  // turning rate of the normal in the cam
  return {height, height + (h2 * turn - h1 * q2) / (turn * turn * turn)};
}

SizeRange sizes_of_flat(const FlankOrigin& cam) {
  const CamMotion& motion = cam.motion;
  const double rest = motion.follower_rest;
  if (!motion.follower.turns) {
    const double rise =
        (motion.follower.R_WB * cam.curve.axis_B).dot(motion.follower.direction_W) * motion.follower_sign;
    const double height = face_at(cam, {}, rest).height;
    return {rest - height / rise, rise < 0 ? -1.0 : 1.0, SizeRange().most, std::abs(height / rise) / 16};
  }
  const Vector2d n = pose_at(motion.follower, motion.follower_sign * rest).R_WB * cam.curve.axis_B;
  const Vector2d pivots = motion.follower.p_WO - motion.cam.p_WO;
  const double angle = angle_from_to(pivots, n);
  const double sense = (angle > 0 ? -1 : 1) * motion.follower_sign;
  return {rest - sense * (kPi / 2 - std::abs(angle)), sense, kPi / 2, kPi / 128};
}

CamSize size_at(const FlankOrigin& cam, double rest, double at) {
  if (is_line(cam.curve)) {
    const double height = std::abs(face_at(cam, {}, rest).height);
    return {rest, height, height, at};
  }
  const Round round = *round_of(cam);
  const double radius = center_at(cam, round, {}, rest).from_cam.norm();
  return {rest, radius, cam.outer ? radius + round.radius : radius - round.radius, at};
}

}  // namespace higherpair
