#include "higherpair/analysis/unit_motion.hpp"

namespace higherpair {

const std::vector<BodyMotion>& unit_motion(const Run& run, std::size_t driver, State& scratch) {
  const State& there = run.at.shown();
  if (run.at.targets.size() == 1) {
    return there.bodies;
  }
  scratch = there;
  std::vector<DriverMotion> motions(run.at.targets.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    motions[i] = {run.at.targets[i], i == driver ? 1.0 : 0.0, 0};
  }
  set_rates(run, motions, scratch);
  return scratch.bodies;
}

}  // namespace higherpair
