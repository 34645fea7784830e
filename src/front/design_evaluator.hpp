#pragma once

#include "design_candidates.hpp"
#include "design_paths.hpp"
#include "higherpair/design/optimise.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace higherpair {

/// What a task's objectives and constraints come to for one candidate, in the units of tables.
struct DesignScore {
  bool started = false;
  std::vector<double> objectives;  ///< of DesignTask::objectives: a path's sum of squares, a measure's value;
                                   ///< NaN where undefined
  /// Of each objective that is a free path: what p of the path goes to is first · p + second [m].
  std::vector<std::optional<std::pair<PathPlacement::Complex, PathPlacement::Complex>>> placements;
  std::vector<double> constraints;  ///< of DesignTask::constraints: the value that is limited
  double missing = 0;               ///< DesignRows::missing
};

/// The score of x on a branch.
[[nodiscard]] DesignScore score_of(const DesignSetup& setup, std::span<const double> x, int branch);

/// The evaluator of problem_of.
[[nodiscard]] std::unique_ptr<DesignEvaluator> evaluator_of(std::shared_ptr<const DesignSetup> setup);

/// How many groups of the mechanism have two modes, and so a constraint on their closure.
[[nodiscard]] Eigen::Index closure_count(const DesignSetup& setup);

/// Sets DesignSetup::scales and cost_scale: the order of the limits and of what the start has.
void set_scales(DesignSetup& setup);

}  // namespace higherpair
