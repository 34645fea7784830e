#pragma once

#include "higherpair/analysis/branch_run.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// The positions of a mechanism on a branch without following it there: bodies placed one after the other in
/// closed form (drivers, dyads and slides) depend only on the branch and the drivers' positions, not on the
/// path to them. Far faster than a Run where many sets of dimensions are tried and most of them do not even
/// close; what happens between two positions remains unknown.
class DirectMotion {
public:
  /// Whether all groups of the plan are of this kind.
  [[nodiscard]] static bool is_possible(const Plan& plan);

  /// \pre is_possible(plan). \param mechanism  must outlive this
  DirectMotion(const Mechanism& mechanism, Plan plan, int branch);

  /// False where a group cannot be assembled; gaps() then holds how far it is from that, and groups after it
  /// have not moved. \param drivers  positions and rates of all drivers \param with_rates  whether velocities
  /// and accelerations are required
  bool move_to(const std::vector<DriverMotion>& drivers, bool with_rates);

  [[nodiscard]] const std::vector<BodyMotion>& bodies() const { return state_.bodies; }
  /// closure_gap of each group, up to and including the first that could not be placed.
  [[nodiscard]] const std::vector<std::optional<double>>& gaps() const { return gaps_; }
  [[nodiscard]] const Plan& plan() const { return plan_; }

private:
  const Mechanism& mechanism_;
  Plan plan_;
  State state_, from_;
  std::vector<std::optional<double>> gaps_;
};

}  // namespace higherpair
