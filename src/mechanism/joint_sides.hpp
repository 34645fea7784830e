#pragma once

#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"

// A joint as seen from one of its bodies.

namespace higherpair {

[[nodiscard]] inline bool touches(const Joint& joint, int body) {
  return joint.first.body == body || joint.second.body == body;
}

/// Whether a joint leaves a body one freedom relative to ground.
[[nodiscard]] inline bool is_grounded(const Joint& joint) {
  return touches(joint, 0) && can_be_driven(joint.type);
}

[[nodiscard]] inline const PointRef& end_on(const Joint& joint, int body) {
  return joint.first.body == body ? joint.first : joint.second;
}

[[nodiscard]] inline const PointRef& end_off(const Joint& joint, int body) {
  return joint.first.body == body ? joint.second : joint.first;
}

[[nodiscard]] inline BodyPoint known_end(const Mechanism& mechanism, const Joint& joint, int body) {
  const PointRef& end = end_off(joint, body);
  return {end.body, point_of(mechanism, end)};
}

}  // namespace higherpair
