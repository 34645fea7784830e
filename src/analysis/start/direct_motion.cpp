#include "higherpair/analysis/direct_motion.hpp"

#include "analysis/groups/group_solver.hpp"
#include "assembly.hpp"
#include "higherpair/mechanism/group_traits.hpp"

#include <algorithm>
#include <utility>

namespace higherpair {

bool DirectMotion::is_possible(const Plan& plan) {
  return std::all_of(plan.groups.begin(), plan.groups.end(),
                     [](const Group& group) { return traits_of(group).direct; });
}

DirectMotion::DirectMotion(const Mechanism& mechanism, Plan plan, int branch)
    : mechanism_(mechanism), plan_(std::move(plan)), gaps_(plan_.groups.size()) {
  state_ = posed_state(mechanism, plan_, branch);
  from_ = state_;
}

bool DirectMotion::move_to(const std::vector<DriverMotion>& drivers, bool with_rates) {
  std::fill(gaps_.begin(), gaps_.end(), std::nullopt);
  const Planned model{mechanism_, plan_};
  std::swap(from_, state_);
  for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
    state_.groups[g].mode = from_.groups[g].mode;
    gaps_[g] = closure_gap(plan_.groups[g], state_.bodies);
    if ((gaps_[g] && *gaps_[g] > 0) ||
        place_group_anew(model, g, from_, drivers, state_) != GroupStatus::kOk) {
      return false;
    }
  }
  for (std::size_t g = 0; with_rates && g < plan_.groups.size(); ++g) {
    set_group_rates(model, g, drivers, state_);
  }
  return true;
}

}  // namespace higherpair
