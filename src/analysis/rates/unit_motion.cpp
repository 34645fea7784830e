#include "higherpair/analysis/unit_motion.hpp"

#include "higherpair/mechanism/joint_motion.hpp"

namespace higherpair {

const std::vector<BodyMotion>& unit_motion(const Run& run, std::size_t driver, State& scratch) {
  const State& there = run.at.shown();
  const std::size_t count = run.mechanism().drivers.size();
  if (count == 1) {
    return there.bodies;
  }
  scratch = there;
  std::vector<DriverMotion> motions(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Joint& joint = driven_joint(run.mechanism(), i);
    motions[i] = {joint_motion(run.mechanism(), joint, there.bodies).position, i == driver ? 1.0 : 0.0, 0};
  }
  set_rates(run, motions, scratch);
  return scratch.bodies;
}

}  // namespace higherpair
