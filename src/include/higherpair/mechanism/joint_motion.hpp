#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/mechanism/description.hpp"

#include <vector>

namespace higherpair {

/// The coordinate of a joint and its rates: the angle of the second body relative to the first [rad], or the
/// displacement of the second point along the line of the first body [m]; for gears and belts the angle of
/// the second wheel relative to the carrier [rad].
struct JointMotion {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
};

/// \param bodies  motions of Mechanism::bodies, in that order.
/// Slides by differentiating s = (p_B - p_A)·d with the line's direction d turning with its body:
///     ṡ = (v_B - v_A)·d + ω_A (p_B - p_A)·d⊥,
///     s̈ = (a_B - a_A)·d + 2 ω_A (v_B - v_A)·d⊥ + (p_B - p_A)·(α_A d⊥ - ω_A² d).
[[nodiscard]] JointMotion joint_motion(const Mechanism& mechanism, const Joint& joint,
                                       const std::vector<BodyMotion>& bodies);

/// Whether a driver moves the joint.
/// \param joint  index of Mechanism::joints
[[nodiscard]] bool is_driven(const Mechanism& mechanism, int joint);

/// The joint that a driver moves.
/// \param driver  index of Mechanism::drivers
[[nodiscard]] inline const Joint& driven_joint(const Mechanism& mechanism, std::size_t driver = 0) {
  return mechanism.joints[mechanism.drivers[driver].joint];
}

/// The poses of the description as motions at rest.
[[nodiscard]] std::vector<BodyMotion> posed_bodies(const Mechanism& mechanism);

/// The point denoted by a reference, in its body's frame [m].
[[nodiscard]] inline const Vector2d& point_of(const Mechanism& mechanism, const PointRef& ref) {
  return mechanism.bodies[ref.body].points[ref.point].p_B;
}

/// The curve denoted by a reference as the mechanism describes it, with its name.
[[nodiscard]] inline const NamedCurve& described_curve(const Mechanism& mechanism, const CurveRef& ref) {
  return mechanism.bodies[ref.body].curves[ref.curve];
}

/// The boundary of a curve that has one.
[[nodiscard]] inline const Boundary& boundary_of(const Mechanism& mechanism, const CurveRef& ref) {
  return *described_curve(mechanism, ref).boundary;
}

/// The curve denoted by a reference, in its body's frame.
[[nodiscard]] inline const Curve& curve_of(const Mechanism& mechanism, const CurveRef& ref) {
  return described_curve(mechanism, ref).curve;
}

}  // namespace higherpair
