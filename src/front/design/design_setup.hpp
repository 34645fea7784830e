#pragma once

#include "design_evaluator.hpp"

#include <memory>

namespace higherpair {

/// Prepares a task. Fails, with the place of each mistake, for columns, rows and pins that do not exist, and
/// for variables without effect.
[[nodiscard]] Result<std::shared_ptr<const DesignSetup>> design_setup(const Model& model);

/// The task as an optimisation problem: residuals for paths and targets, cost for what is to be minimised,
/// constraints for the closure of each dyad, for a good path, and for those of the task, each of which may
/// have two limits.
[[nodiscard]] DesignProblem problem_of(const std::shared_ptr<const DesignSetup>& setup);

/// Sets the places of objectives and constraints, and the numbers of residuals and constraints of the
/// problem.
void set_places(DesignSetup& setup);

/// Diagnostics for variables and objectives that have no effect near the start, and for constraints that no
/// variable changes and that do not hold. Sets DesignSetup::idle. If the start does not assemble, constraints
/// are judged at other values with which it does, if such are found.
[[nodiscard]] Diagnostics idle_parts(DesignSetup& setup);

/// The text of the model's profile with the design x written into it, and with the poses needed to assemble
/// it on the branch, as far as they are estimates: those from which something else is taken are kept.
/// \param settings  of the run that is to start from these poses
[[nodiscard]] Result<std::string> text_of_design(const DesignNumbers& numbers, const RunSettings& settings,
                                                 std::span<const double> x, int branch);

/// Whether such a text, read again and started from its poses, has the poses of the design x on the branch,
/// in the same turn of each angle.
[[nodiscard]] bool starts_as_designed(const DesignNumbers& numbers, const RunSettings& settings,
                                      std::span<const double> x, int branch, const Model& read);

}  // namespace higherpair
