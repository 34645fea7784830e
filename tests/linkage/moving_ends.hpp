#pragma once

#include "higherpair/linkage/moving_guide.hpp"
#include "linkage/linkage_testing.hpp"

namespace higherpair::testing {

inline Vector2d random_vector(Random& random, double size = 1) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return {x, y};
}

inline Rotation<double> random_direction(Random& random) {
  return Rotation<double>::from_angle(random.angle());
}

/// A point with constant acceleration: its position at t is known without the library's formulas.
struct MovingPoint {
  PointMotion start;

  [[nodiscard]] PointMotion at(double t) const {
    return {start.p_W + t * start.v_W + 0.5 * t * t * start.a_W, start.v_W + t * start.a_W, start.a_W};
  }
};

inline MovingPoint random_point(Random& random) {
  const Vector2d p = random_vector(random), v = random_vector(random), a = random_vector(random);
  return {{p, v, a}};
}

/// A body whose origin has constant acceleration and whose angle has a constant second derivative.
struct MovingBody {
  MovingPoint origin;
  AngleMotion angle;

  [[nodiscard]] BodyMotion at(double t) const {
    const PointMotion o = origin.at(t);
    const double theta = angle.theta + t * angle.omega + 0.5 * t * t * angle.alpha;
    return {{Rotation<double>::from_angle(theta), o.p_W},
            theta,
            o.v_W,
            angle.omega + t * angle.alpha,
            o.a_W,
            angle.alpha};
  }
};

inline MovingBody random_body(Random& random) {
  const MovingPoint origin = random_point(random);
  const double theta = random.angle(), omega = random.between(-1, 1), alpha = random.between(-1, 1);
  return {origin, {theta, omega, alpha}};
}

/// A guide on a moving body.
struct MovingGuide {
  MovingBody body;
  Vector2d p_B = Vector2d::Zero();
  Rotation<double> u_B;

  [[nodiscard]] GuideMotion at(double t) const { return guide_motion(body.at(t), p_B, u_B); }
};

inline MovingGuide random_guide(Random& random) {
  const MovingBody body = random_body(random);
  const Vector2d p_B = random_vector(random);
  return {body, p_B, random_direction(random)};
}

/// A body at rest, with its axes parallel to ground's.
inline BodyMotion resting(const Vector2d& p_W = Vector2d::Zero()) {
  BodyMotion body;
  body.X_WB.p_WB = p_W;
  return body;
}

/// The motion in ground of a point that moves by `point` in the frame of a moving body (with the Coriolis
/// term).
inline PointMotion carried(const BodyMotion& body, const PointMotion& point) {
  const PointMotion fixed = point_motion(body, point.p_W);
  const Vector2d v = body.X_WB.R_WB * point.v_W, a = body.X_WB.R_WB * point.a_W;
  return {fixed.p_W, fixed.v_W + v, fixed.a_W + a + 2 * body.omega * perp(v)};
}

/// A body that turns about the origin of ground and of its own frame.
inline BodyMotion turning(const AngleMotion& link) {
  BodyMotion body;
  body.X_WB.R_WB = Rotation<double>::from_angle(link.theta);
  body.theta = link.theta;
  body.omega = link.omega;
  body.alpha = link.alpha;
  return body;
}

inline double angle_of(const Rotation<double>& u) {
  return std::atan2(u.sin, u.cos);
}

inline Vector2d vector_of(const Rotation<double>& u) {
  return {u.cos, u.sin};
}

}  // namespace higherpair::testing
