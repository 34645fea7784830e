#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/io/units.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <cstddef>

namespace higherpair {

/// The dimension of a coordinate: an angle if it `turns`, else a length.
[[nodiscard]] constexpr Dimension coordinate_dimension(bool turns) {
  return turns ? dimension::kAngle : dimension::kLength;
}

/// Of the coordinate that a joint leaves its bodies.
[[nodiscard]] constexpr Dimension coordinate_dimension(const Joint& joint) {
  return coordinate_dimension(has_angle(joint.type));
}

/// The dimension of what drives such a coordinate: a torque or a force.
[[nodiscard]] constexpr Dimension effort_dimension(bool turns) {
  return turns ? dimension::kTorque : dimension::kForce;
}

/// Whether a driver's position is an angle.
[[nodiscard]] inline bool driver_turns(const Mechanism& mechanism, std::size_t driver = 0) {
  return has_angle(driven_joint(mechanism, driver).type);
}

/// The dimension of a driver's position.
[[nodiscard]] inline Dimension driver_dimension(const Mechanism& mechanism, std::size_t driver = 0) {
  return coordinate_dimension(driven_joint(mechanism, driver));
}

/// A turn in the unit of angles: 360 for degrees.
[[nodiscard]] inline double full_turn(const Units& units) {
  return from_si(dimension::kAngle, units).apply(2 * kPi);
}

}  // namespace higherpair
