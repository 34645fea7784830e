#pragma once

#include "design_evaluator.hpp"

#include <memory>

namespace higherpair {

/// A task made ready. Fails, with the place of each, for what the task cannot mean: columns, rows and pins
/// that are not there, and numbers that change nothing.
[[nodiscard]] Result<std::shared_ptr<const DesignSetup>> design_setup(const Model& model);

/// What is wrong with a task's variables and objectives in effect: that they change nothing near the start.
[[nodiscard]] Diagnostics idle_parts(const DesignSetup& setup);

/// The text of the model's profile with the design x in it, and with the poses that it takes to assemble it
/// on the branch. Reading it gives the design.
[[nodiscard]] Result<std::string> text_of_design(const DesignSetup& setup, std::span<const double> x,
                                                 int branch);

}  // namespace higherpair
