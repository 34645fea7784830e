#include "joint_ends.hpp"

#include "analysis/tolerances.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>

namespace higherpair {
namespace {

// Calls f(end, room) for the ends of the joints of a group.
template <class F>
void for_each_end(const Planned& model, std::size_t g, const State& state, const F& f) {
  for (const int index : model.plan.groups[g].ended_joints) {
    const Joint& joint = model.mechanism.joints[index];
    const double s = joint_motion(model.mechanism, joint, state.bodies).position;
    if (joint.from) {
      f(JointEnd{index, false}, s - *joint.from);
    }
    if (joint.to) {
      f(JointEnd{index, true}, *joint.to - s);
    }
  }
}

// The first end that is less than `margin` ahead, or, where that is < 0, that is exceeded by more than
// -`margin`.
std::optional<JointEnd> joint_near_end(const Planned& model, std::size_t g, const State& state,
                                       double margin) {
  std::optional<JointEnd> found;
  for_each_end(model, g, state, [&](const JointEnd& end, double room) {
    if (!found && room < margin) {
      found = end;
    }
  });
  return found;
}

}  // namespace

std::optional<JointEnd> joint_beyond_end(const Planned& model, std::size_t g, const State& state) {
  return model.plan.groups[g].ended_joints.empty()
             ? std::nullopt
             : joint_near_end(model, g, state, -kBeyondJointEnd * model.plan.size);
}

double room_to_end(const Planned& model, std::size_t g, const State& state) {
  double least = kInf;
  for_each_end(model, g, state, [&](const JointEnd&, double room) { least = std::min(least, room); });
  return least;
}

std::optional<JointEnd> joint_at_end(const Planned& model, std::size_t g, const State& state) {
  return joint_near_end(model, g, state, kAtJointEnd * model.plan.size);
}

}  // namespace higherpair
