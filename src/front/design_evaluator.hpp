#pragma once

#include "design_paths.hpp"
#include "higherpair/design/problem.hpp"

#include <memory>
#include <string>
#include <vector>

namespace higherpair {

/// What a task's objectives and constraints come to for one candidate, in the units of tables.
struct DesignScore {
  bool started = false;
  std::vector<double> objectives;  ///< of DesignTask::objectives: a path's sum of squares, a measure's value;
                                   ///< NaN where undefined
  std::vector<double> constraints;  ///< of DesignTask::constraints: the value that is limited
  double missing = 0;               ///< DesignRows::missing
};

/// The score of x on a branch.
[[nodiscard]] DesignScore score_of(const DesignSetup& setup, std::span<const double> x, int branch);

/// The task as the optimiser takes it: residuals of paths and targets, cost of what is to be small,
/// constraints of the closure of each dyad, of the whole path being good, and of the task, each of which may
/// have two limits. \param scales  of each objective that is a measure and each constraint: what counts as
/// much
[[nodiscard]] DesignProblem problem_of(std::shared_ptr<const DesignSetup> setup);

/// Which of the problem's constraints are the limits of the task's k-th one: `above` before `below`.
struct LimitPlaces {
  std::optional<Eigen::Index> above, below;
};
[[nodiscard]] std::vector<LimitPlaces> limit_places(const DesignSetup& setup);

/// By how much a constraint's limit has to be missed to count as 1, in the unit of tables.
[[nodiscard]] double scale_of(const DesignTask::Constraint& constraint);

}  // namespace higherpair
