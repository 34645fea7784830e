// A design task as an optimisation problem.
#include "design_gradient.hpp"
#include "design_setup.hpp"
#include "higherpair/front/design.hpp"

namespace higherpair {

std::vector<LimitPlaces> limit_places(const DesignSetup& setup) {
  std::vector<LimitPlaces> places;
  Eigen::Index next = static_cast<Eigen::Index>(setup.closures) + 1;
  for (const DesignTask::Constraint& constraint : setup.numbers.task().constraints) {
    LimitPlaces& limits = places.emplace_back();
    if (constraint.above) limits.above = next++;
    if (constraint.below) limits.below = next++;
  }
  return places;
}

DesignProblem problem_of(std::shared_ptr<const DesignSetup> setup) {
  const DesignTask& task = setup->numbers.task();
  DesignProblem problem;
  for (const DesignTask::Variable& variable : task.variables) problem.variables.push_back(variable.range);
  for (const DesignTask::Objective& objective : task.objectives) {
    problem.residuals += residual_count(objective);
    const bool is_value = objective.measure || objective.figure || objective.extent;
    problem.has_cost = problem.has_cost || (is_value && !objective.target);
  }
  problem.constraints = constraint_count(*setup);
  problem.branches = task.keep_branch ? 1 : setup->branches;
  problem.start_branch = setup->start_branch.value_or(0);
  problem.evaluator = [setup] { return evaluator_of(*setup); };
  return problem;
}

Result<DesignProblem> design_problem(const Model& model) {
  return design_setup(model).map(problem_of);
}

}  // namespace higherpair
