// A design task as an optimisation problem.
#include "design_gradient.hpp"
#include "design_setup.hpp"
#include "higherpair/front/design.hpp"
#include "numeric/eigen_index.hpp"

namespace higherpair {

void set_places(DesignSetup& setup) {
  const DesignTask& task = setup.numbers.task();
  std::size_t path = 0, quantity = 0, transmission = 0;
  for (const DesignTask::Objective& objective : task.objectives) {
    setup.objective_places.push_back({setup.residuals, path, quantity});
    ++(objective.path() ? path : quantity);
    setup.residuals += residual_count(objective);
  }
  setup.constraints = eigen_index(setup.closures) + 1;
  for (const DesignTask::Constraint& constraint : task.constraints) {
    ConstraintPlace& place = setup.constraint_places.emplace_back();
    place.transmission = transmission;
    place.quantity = quantity;
    ++(constraint.transmission() ? transmission : quantity);
    if (constraint.above) place.above = setup.constraints++;
    if (constraint.below) place.below = setup.constraints++;
  }
}

DesignProblem problem_of(const std::shared_ptr<const DesignSetup>& setup) {
  const DesignTask& task = setup->numbers.task();
  DesignProblem problem;
  for (const DesignTask::Variable& variable : task.variables) problem.variables.push_back(variable.range);
  for (const DesignTask::Objective& objective : task.objectives) {
    const bool is_value = !objective.path() && !objective.followed();
    problem.has_cost = problem.has_cost || (is_value && !objective.target);
  }
  problem.residuals = setup->residuals;
  problem.constraints = setup->constraints;
  problem.branches = task.keep_branch ? 1 : setup->branches;
  problem.start_branch = setup->start_branch.value_or(0);
  problem.evaluator = [setup] { return evaluator_of(*setup); };
  return problem;
}

Result<DesignProblem> design_problem(const Model& model) {
  return design_setup(model).map(problem_of);
}

}  // namespace higherpair
