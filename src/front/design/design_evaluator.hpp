#pragma once

#include "design_candidates.hpp"
#include "design_paths.hpp"
#include "higherpair/design/optimise.hpp"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace higherpair {

/// Values of a task's objectives and constraints for one candidate, in the units of tables.
struct DesignScore {
  bool started = false;
  std::vector<double> objectives;  ///< for each of DesignTask::objectives: a path's sum of squares or a
                                   ///< measure's value; NaN where undefined
  /// For each objective that is a free path: a point p of the path is placed at first · p + second [m].
  std::vector<std::optional<std::pair<PathPlacement::Complex, PathPlacement::Complex>>> placements;
  std::vector<double> constraints;  ///< for each of DesignTask::constraints: the value that is limited
  double missing = 0;               ///< DesignRows::missing
};

/// The score of x on a branch.
[[nodiscard]] DesignScore score_of(const DesignSetup& setup, std::span<const double> x, int branch);

/// The evaluator that problem_of uses.
[[nodiscard]] std::unique_ptr<DesignEvaluator> evaluator_of(std::shared_ptr<const DesignSetup> setup);

/// Number of constraints of the problem: those on closure, one for a good path, and one for each limit of the
/// task.
[[nodiscard]] Eigen::Index constraint_count(const DesignSetup& setup);

/// The first row with this position of the first driver, as tables show it; none if no row has it.
[[nodiscard]] std::optional<std::size_t> row_at(const DriverSchedule& schedule, double position);

/// Sets DesignSetup::scales and cost_scale by the order of magnitude of the limits and of the values at the
/// start.
void set_scales(DesignSetup& setup);

}  // namespace higherpair
