#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>

namespace higherpair {

JointMotion joint_motion(const Mechanism& mechanism, const Joint& joint,
                         const std::vector<BodyMotion>& bodies) {
  const BodyMotion& first = bodies[joint.first.body];
  const BodyMotion& second = bodies[joint.second.body];
  if (joint.type == JointType::kRevolute) {
    return {second.theta - first.theta, second.omega - first.omega, second.alpha - first.alpha};
  }
  if (couples_turning(joint.type)) {
    const BodyMotion& carrier = bodies[joint.carrier];
    return {second.theta - carrier.theta, second.omega - carrier.omega, second.alpha - carrier.alpha};
  }
  const PointMotion A = point_motion(first, point_of(mechanism, joint.first));
  const PointMotion B = point_motion(second, point_of(mechanism, joint.second));
  const Vector2d d = first.X_WB.R_WB * joint.direction_A;
  const Vector2d across = perp(d);
  const Vector2d r = B.p_W - A.p_W;
  const Vector2d v = B.v_W - A.v_W;
  const double omega = first.omega;
  return {r.dot(d), v.dot(d) + omega * r.dot(across),
          (B.a_W - A.a_W).dot(d) + 2 * omega * v.dot(across) +
              r.dot(Vector2d(first.alpha * across - omega * omega * d))};
}

bool is_driven(const Mechanism& mechanism, int joint) {
  return std::any_of(mechanism.drivers.begin(), mechanism.drivers.end(),
                     [&](const Driver& driver) { return driver.joint == joint; });
}

std::vector<BodyMotion> posed_bodies(const Mechanism& mechanism) {
  std::vector<BodyMotion> bodies(mechanism.bodies.size());
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    bodies[i].theta = body.guess_theta;
    bodies[i].X_WB = {Rotation<double>::from_angle(body.guess_theta), body.guess_p_WB};
  }
  return bodies;
}

}  // namespace higherpair
