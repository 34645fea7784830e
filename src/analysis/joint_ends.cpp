#include "joint_ends.hpp"

#include "higherpair/mechanism/joint_motion.hpp"

#include <cmath>

namespace higherpair {
namespace {

constexpr double kBeyond = 1e-12;  // of the size: rounding, so that a row may be at the very end
constexpr double kAt = 1e-9;       // of the size

// The first joint of a group with an end that is less than `margin` ahead of it; beyond it where that is < 0.
std::optional<JointEnd> joint_near_end(const Planned& model, std::size_t g, const State& state,
                                       double margin) {
  for (const int index : model.plan.groups[g].ended_joints) {
    const Joint& joint = model.mechanism.joints[static_cast<std::size_t>(index)];
    const double s = joint_motion(model.mechanism, joint, state.bodies).position;
    if (joint.from && s - *joint.from < margin) {
      return JointEnd{index, false};
    }
    if (joint.to && *joint.to - s < margin) {
      return JointEnd{index, true};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<JointEnd> joint_beyond_end(const Planned& model, std::size_t g, const State& state) {
  return model.plan.groups[g].ended_joints.empty()
             ? std::nullopt
             : joint_near_end(model, g, state, -kBeyond * model.plan.size);
}

std::optional<JointEnd> joint_at_end(const Planned& model, std::size_t g, const State& state) {
  return joint_near_end(model, g, state, kAt * model.plan.size);
}

}  // namespace higherpair
