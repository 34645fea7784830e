#pragma once

#include "higherpair/analysis/branch_run.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// The positions of a mechanism on a branch without following it there: what drivers, dyads and slides place
/// one after the other in closed form depends on the branch and on where the drivers are, not on how they
/// came there. Far quicker than a Run where many sets of dimensions are tried and most of them do not even
/// close; what happens between two positions remains unseen.
class DirectMotion {
public:
  /// Whether the plan's groups are such.
  [[nodiscard]] static bool is_possible(const Plan& plan);

  /// \pre is_possible(plan). \param mechanism  outlives this
  DirectMotion(const Mechanism& mechanism, Plan plan, int branch);

  /// False where a group cannot be put together; gaps() says how far it is from that, groups after it have
  /// not moved. \param drivers  positions and rates of all drivers \param with_rates  whether velocities and
  /// accelerations are wanted
  bool move_to(const std::vector<DriverMotion>& drivers, bool with_rates);

  [[nodiscard]] const std::vector<BodyMotion>& bodies() const { return state_.bodies; }
  /// closure_gap of each group, up to the first that could not be placed.
  [[nodiscard]] const std::vector<std::optional<double>>& gaps() const { return gaps_; }
  [[nodiscard]] const Plan& plan() const { return plan_; }

private:
  const Mechanism& mechanism_;
  Plan plan_;
  State state_, from_;
  std::vector<double> positions_;
  std::vector<std::optional<double>> gaps_;
};

}  // namespace higherpair
