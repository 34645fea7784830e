#pragma once

#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"

// The two ends of a joint, given one of its bodies.

namespace higherpair {

[[nodiscard]] inline const Joint& joint_of(const Mechanism& mechanism, int index) {
  return mechanism.joints[index];
}

[[nodiscard]] inline bool touches(const Joint& joint, int body) {
  return joint.first.body == body || joint.second.body == body;
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
