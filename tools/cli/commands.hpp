#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace higherpair::cli {

/// Runs a command whose arguments have been parsed; returns the exit code.
using CommandRun = std::function<int()>;

/// \name Give a command of the program its options.
/// @{
[[nodiscard]] CommandRun add_analyze(CLI::App& command);
[[nodiscard]] CommandRun add_step(CLI::App& command);
[[nodiscard]] CommandRun add_forces(CLI::App& command);
[[nodiscard]] CommandRun add_branches(CLI::App& command);
[[nodiscard]] CommandRun add_mobility(CLI::App& command);
[[nodiscard]] CommandRun add_map(CLI::App& command);
[[nodiscard]] CommandRun add_draw(CLI::App& command);
[[nodiscard]] CommandRun add_export(CLI::App& command);
[[nodiscard]] CommandRun add_plot(CLI::App& command);
[[nodiscard]] CommandRun add_polygon(CLI::App& command);
[[nodiscard]] CommandRun add_report(CLI::App& command);
[[nodiscard]] CommandRun add_check(CLI::App& command);
[[nodiscard]] CommandRun add_sweep(CLI::App& command);
[[nodiscard]] CommandRun add_sensitivity(CLI::App& command);
[[nodiscard]] CommandRun add_design(CLI::App& command);
[[nodiscard]] CommandRun add_fit(CLI::App& command);
[[nodiscard]] CommandRun add_verify(CLI::App& command);
/// @}

}  // namespace higherpair::cli
