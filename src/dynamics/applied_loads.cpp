#include "higherpair/dynamics/applied_loads.hpp"

#include "higherpair/mechanism/joint_motion.hpp"

namespace higherpair {
namespace {

void add_force(const std::vector<BodyMotion>& bodies, int body, const Vector2d& force_W, const Vector2d& p_W,
               std::vector<Wrench>& wrenches) {
  wrenches[body] += wrench_of(bodies[body], force_W, p_W);
}

void add_torque(int body, double torque, std::vector<Wrench>& wrenches) {
  wrenches[body].z() += torque;
}

// The distance from the first to the second point of a spring.
struct PointDistance {
  Vector2d p1_W;
  Vector2d p2_W;
  Vector2d u_W;       // unit vector; zero where the points coincide
  double length = 0;  // [m]
  double rate = 0;    // [m/s]
};

PointDistance distance_between(const Mechanism& mechanism, const Spring& spring,
                               const std::vector<BodyMotion>& bodies) {
  const PointMotion first = point_motion(bodies[spring.first.body], point_of(mechanism, spring.first));
  const PointMotion second = point_motion(bodies[spring.second.body], point_of(mechanism, spring.second));
  const Vector2d r = second.p_W - first.p_W;
  const double length = r.norm();
  const Vector2d u = length > 0 ? Vector2d(r / length) : Vector2d(Vector2d::Zero());
  return {first.p_W, second.p_W, u, length, (second.v_W - first.v_W).dot(u)};
}

}  // namespace

void add_applied(const Mechanism& mechanism, const std::vector<BodyMotion>& bodies,
                 std::vector<Wrench>& wrenches) {
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    if (const auto& mass = mechanism.bodies[i].mass) {
      const Vector2d p_W = bodies[i].X_WB * mass->center_of_mass_B;
      wrenches[i] += wrench_of(bodies[i], mass->mass * mechanism.gravity_W, p_W);
    }
  }
  for (const Load& load : mechanism.loads) {
    const BodyMotion& body = bodies[load.body];
    const Vector2d force_W = load.frame == LoadFrame::kBody ? body.X_WB.R_WB * load.force : load.force;
    add_force(bodies, load.body, force_W, body.X_WB * load.p_B, wrenches);
    add_torque(load.body, load.torque, wrenches);
  }
  for (const Spring& spring : mechanism.springs) {
    add_tension(mechanism, spring, spring_tension(mechanism, spring, bodies), bodies, wrenches);
  }
}

void add_inertia(const Mechanism& mechanism, const std::vector<BodyMotion>& bodies,
                 std::vector<Wrench>& wrenches) {
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    if (const auto& mass = mechanism.bodies[i].mass) {
      const PointMotion center = point_motion(bodies[i], mass->center_of_mass_B);
      wrenches[i] += wrench_of(bodies[i], -mass->mass * center.a_W, center.p_W);
      wrenches[i].z() -= mass->inertia * bodies[i].alpha;
    }
  }
}

double spring_tension(const Mechanism& mechanism, const Spring& spring,
                      const std::vector<BodyMotion>& bodies) {
  if (spring.joint) {
    const Joint& joint = mechanism.joints[*spring.joint];
    const JointMotion motion = joint_motion(mechanism, joint, bodies);
    return spring.stiffness * (motion.position - spring.free) + spring.damping * motion.velocity;
  }
  const PointDistance between = distance_between(mechanism, spring, bodies);
  return spring.stiffness * (between.length - spring.free) + spring.damping * between.rate;
}

void add_tension(const Mechanism& mechanism, const Spring& spring, double tension,
                 const std::vector<BodyMotion>& bodies, std::vector<Wrench>& wrenches) {
  if (spring.joint) {
    const Joint& joint = mechanism.joints[*spring.joint];
    add_joint_effort(mechanism, joint, -tension, bodies, wrenches);
    return;
  }
  const PointDistance between = distance_between(mechanism, spring, bodies);
  add_force(bodies, spring.first.body, tension * between.u_W, between.p1_W, wrenches);
  add_force(bodies, spring.second.body, -tension * between.u_W, between.p2_W, wrenches);
}

void add_joint_effort(const Mechanism& mechanism, const Joint& joint, double effort,
                      const std::vector<BodyMotion>& bodies, std::vector<Wrench>& wrenches) {
  if (joint.type == JointType::kRevolute) {
    add_torque(joint.first.body, -effort, wrenches);
    add_torque(joint.second.body, effort, wrenches);
    return;
  }
  const Vector2d force_W = effort * (bodies[joint.first.body].X_WB.R_WB * joint.direction_A);
  const Vector2d p_W = bodies[joint.second.body].X_WB * point_of(mechanism, joint.second);
  add_force(bodies, joint.first.body, -force_W, p_W, wrenches);
  add_force(bodies, joint.second.body, force_W, p_W, wrenches);
}

}  // namespace higherpair
