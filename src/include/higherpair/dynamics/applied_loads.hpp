#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/mechanism/description.hpp"

#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// Load on a body: a force and a torque about the origin of the body's frame, in ground (F_x [N], F_y [N], τ
/// [N m]). Its product with (v_x, v_y, ω) of the frame is a power [W].
using Wrench = Eigen::Vector3d;

/// The wrench of a force at p_W on a body.
[[nodiscard]] inline Wrench wrench_of(const BodyMotion& body, const Vector2d& force_W, const Vector2d& p_W) {
  return {force_W.x(), force_W.y(), cross(Vector2d(p_W - body.X_WB.p_WB), force_W)};
}

/// Adds the loads on every body other than those of joints, contacts and drivers: gravity at the centre of
/// mass, loads, springs and dampers.
/// \param bodies  motions of Mechanism::bodies; `wrenches` has one entry for each
void add_applied(const Mechanism& mechanism, const std::vector<BodyMotion>& bodies,
                 std::vector<Wrench>& wrenches);

/// Adds the inertia of every body with mass, as D'Alembert's force -m a_G at the centre of mass and torque -I
/// α.
void add_inertia(const Mechanism& mechanism, const std::vector<BodyMotion>& bodies,
                 std::vector<Wrench>& wrenches);

/// T = k (x - x_free) + c ẋ of a spring and damper, x the distance of its points or the coordinate of its
/// joint: positive where it tends to reduce x [N, or N m on a revolute joint].
[[nodiscard]] double spring_tension(const Mechanism& mechanism, const Spring& spring,
                                    const std::vector<BodyMotion>& bodies);

/// Adds the effect of a spring of tension T on its bodies; nothing where its two points coincide, since it
/// then has no direction.
void add_tension(const Mechanism& mechanism, const Spring& spring, double tension,
                 const std::vector<BodyMotion>& bodies, std::vector<Wrench>& wrenches);

/// Adds a torque (revolute) or a force along the line at the second point (else) on the second body of a
/// joint, positive in the sense of the joint's coordinate, and the reaction on the first body.
void add_joint_effort(const Mechanism& mechanism, const Joint& joint, double effort,
                      const std::vector<BodyMotion>& bodies, std::vector<Wrench>& wrenches);

}  // namespace higherpair
