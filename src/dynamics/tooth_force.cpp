#include "higherpair/dynamics/tooth_force.hpp"

#include "higherpair/dynamics/applied_loads.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <cassert>
#include <cmath>

namespace higherpair {
PitchPoint pitch_point(const Mechanism& mechanism, const Joint& joint,
                       const std::vector<BodyMotion>& bodies) {
  const auto center = [&](const PointRef& point) -> Vector2d {
    return bodies[point.body].X_WB * point_of(mechanism, point);
  };
  const Vector2d c1 = center(joint.first);
  const Vector2d between = center(joint.second) - c1;
  const double k = joint.turning_ratio;
  assert(joint.type == JointType::kGears && k != 1);
  return {c1 + k / (k - 1) * between, between.normalized(), between.norm()};
}

ConstraintRow tooth_row(const Mechanism& mechanism, const Joint& joint, int flank,
                        const std::vector<BodyMotion>& bodies, double size) {
  const PitchPoint pitch = pitch_point(mechanism, joint, bodies);
  const double k = joint.turning_ratio;
  const double radial = flank * std::abs(k - 1) * std::tan(joint.teeth->pressure_angle) * (k < 0 ? 1 : -1);
  const Vector2d force = size / pitch.distance * ((k - 1) * perp(pitch.u_W) + radial * pitch.u_W);
  ConstraintRow row;
  row.body = {joint.first.body, joint.second.body, 0};
  row.coefficient[0] = wrench_of(bodies[joint.first.body], -force, pitch.p_W);
  row.coefficient[1] = wrench_of(bodies[joint.second.body], force, pitch.p_W);
  return row;
}

}  // namespace higherpair
