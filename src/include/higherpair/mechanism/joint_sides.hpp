#pragma once

#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <cstddef>

// A joint or contact as seen from one of its bodies.

namespace higherpair {

template <class Pair>
[[nodiscard]] bool touches(const Pair& pair, int body) {
  return pair.first.body == body || pair.second.body == body;
}

[[nodiscard]] inline bool joins(const Joint& joint, int one, int other) {
  return one != other && touches(joint, one) && touches(joint, other);
}

/// Whether a joint leaves a body one freedom relative to ground.
[[nodiscard]] inline bool is_grounded(const Joint& joint) {
  return touches(joint, kGround) && can_be_driven(joint.type);
}

/// The point or curve on a body. \pre touches(pair, body)
template <class Pair>
[[nodiscard]] const auto& end_on(const Pair& pair, int body) {
  return pair.first.body == body ? pair.first : pair.second;
}

/// That on the other body.
template <class Pair>
[[nodiscard]] const auto& end_off(const Pair& pair, int body) {
  return pair.first.body == body ? pair.second : pair.first;
}

/// The curve of side 0 or 1.
[[nodiscard]] inline const CurveRef& ref_of(const Contact& contact, std::size_t side) {
  return side == 0 ? contact.first : contact.second;
}

/// The point of a joint on a body, in its frame.
[[nodiscard]] inline const Vector2d& point_on(const Mechanism& mechanism, const Joint& joint, int body) {
  return point_of(mechanism, end_on(joint, body));
}

[[nodiscard]] inline BodyPoint known_end(const Mechanism& mechanism, const Joint& joint, int body) {
  const PointRef& end = end_off(joint, body);
  return {end.body, point_of(mechanism, end)};
}

}  // namespace higherpair
