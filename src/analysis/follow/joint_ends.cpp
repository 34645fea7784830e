#include "joint_ends.hpp"

#include "analysis/tolerances.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/hermite.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kMostLooks = 20;  // within a step; each is the root of a better cubic

// How far a joint is from an end of its line [m, rad], and how that changes per unit of the path.
struct Room {
  double left = 0;
  double rate = 0;
};

Room room_to(const Planned& model, const JointEnd& end, const State& state) {
  const Joint& joint = model.mechanism.joints[end.joint];
  const JointMotion at = joint_motion(model.mechanism, joint, state.bodies);
  return end.upper ? Room{*joint.to - at.position, -at.velocity}
                   : Room{at.position - *joint.from, at.velocity};
}

// Calls f(end) for the ends of the joints of a group.
template <class F>
void for_each_end(const Mechanism& mechanism, const Group& group, const F& f) {
  for (const int index : group.ended_joints) {
    const Joint& joint = mechanism.joints[index];
    if (joint.from) {
      f(JointEnd{index, false});
    }
    if (joint.to) {
      f(JointEnd{index, true});
    }
  }
}

// The first end that is less than `margin` ahead, or, where that is < 0, that is exceeded by more than
// -`margin`.
std::optional<JointEnd> joint_near_end(const Planned& model, std::size_t g, const State& state,
                                       double margin) {
  std::optional<JointEnd> found;
  for_each_end(model.mechanism, model.plan.groups[g], [&](const JointEnd& end) {
    if (!found && room_to(model, end, state).left < margin) {
      found = end;
    }
  });
  return found;
}

// Where a joint that goes towards an end at the beginning of a step and back from it at the step's end is
// beyond it: from the least of the cubic through both rooms and rates to that of the part that it leaves.
std::optional<double> passed_within(Run& run, const JointEnd& end, const Path& path, double s, double h) {
  const Planned model = model_of(run);
  double low = 0, high = h;
  Room before = room_to(model, end, run.at.state), after = room_to(model, end, run.work.trial);
  std::optional<StateAside> aside;
  for (int looks = 0; looks < kMostLooks && before.rate * h < 0 && after.rate * h > 0; ++looks) {
    const double width = high - low;
    const HermiteCubic room{before.left, width * before.rate, after.left, width * after.rate};
    const double t = room.lowest_at();
    const double worth = kWorthALook * std::max(std::min(before.left, after.left), 0.0);
    if (room(t) > worth - kBeyondJointEnd * run.plan().size) {
      break;
    }
    if (!aside) {
      aside.emplace(run.work.trial);
    }
    const double x = std::lerp(low, high, t);
    if (!solve_at(run, path, s, x)) {
      return x;
    }
    const Room there = room_to(model, end, run.work.trial);
    (there.rate * h < 0 ? low : high) = x;
    (there.rate * h < 0 ? before : after) = there;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> end_passed_within(Run& run, const Path& path, double s, double h) {
  std::optional<double> first;
  for (const Group& group : run.plan().groups) {
    for_each_end(run.mechanism(), group, [&](const JointEnd& end) {
      const auto x = passed_within(run, end, path, s, h);
      if (x && (!first || std::abs(*x) < std::abs(*first))) {
        first = x;
      }
    });
  }
  return first;
}

std::optional<JointEnd> joint_beyond_end(const Planned& model, std::size_t g, const State& state) {
  return model.plan.groups[g].ended_joints.empty()
             ? std::nullopt
             : joint_near_end(model, g, state, -kBeyondJointEnd * model.plan.size);
}

double room_to_end(const Planned& model, std::size_t g, const State& state) {
  double least = kInf;
  for_each_end(model.mechanism, model.plan.groups[g],
               [&](const JointEnd& end) { least = std::min(least, room_to(model, end, state).left); });
  return least;
}

std::optional<JointEnd> joint_at_end(const Planned& model, std::size_t g, const State& state) {
  return joint_near_end(model, g, state, kAtJointEnd * model.plan.size);
}

}  // namespace higherpair
