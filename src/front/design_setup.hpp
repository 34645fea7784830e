#pragma once

#include "design_evaluator.hpp"

#include <memory>

namespace higherpair {

/// A task made ready. Fails, with the place of each, for what the task cannot mean: columns, rows and pins
/// that are not there, and numbers that change nothing.
[[nodiscard]] Result<std::shared_ptr<const DesignSetup>> design_setup(const Model& model);

/// The task as the optimiser takes it: residuals of paths and targets, cost of what is to be small,
/// constraints of the closure of each dyad, of the whole path being good, and of the task, each of which may
/// have two limits.
[[nodiscard]] DesignProblem problem_of(std::shared_ptr<const DesignSetup> setup);

/// Which of the problem's constraints are the limits of the task's k-th one: `above` before `below`.
struct LimitPlaces {
  std::optional<Eigen::Index> above, below;
};
[[nodiscard]] std::vector<LimitPlaces> limit_places(const DesignSetup& setup);

/// What is wrong with a task's variables and objectives in effect: that they change nothing near the start.
[[nodiscard]] Diagnostics idle_parts(const DesignSetup& setup);

/// The text of the model's profile with the design x in it, and with the poses that it takes to assemble it
/// on the branch. Reading it gives the design.
[[nodiscard]] Result<std::string> text_of_design(const DesignSetup& setup, std::span<const double> x,
                                                 int branch);

}  // namespace higherpair
