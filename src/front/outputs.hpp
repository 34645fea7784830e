#pragma once

#include "higherpair/mechanism/description.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"

#include <cstddef>
#include <vector>

namespace higherpair {

/// The joints by which the motion leaves the mechanism: revolute and prismatic ones to ground that are not
/// driven.
[[nodiscard]] inline std::vector<const Joint*> outputs_of(const Mechanism& mechanism) {
  std::vector<const Joint*> joints;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (is_grounded(joint) && !is_driven(mechanism, static_cast<int>(i))) {
      joints.push_back(&joint);
    }
  }
  return joints;
}

}  // namespace higherpair
