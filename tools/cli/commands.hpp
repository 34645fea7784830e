#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace higherpair::cli {

/// A command of the program with its options.
struct Command {
  CLI::App* arguments = nullptr;
  std::function<int()> run;  ///< after the arguments have been parsed; returns the exit code
};

/// \name Add a command to the program.
/// @{
[[nodiscard]] Command add_analyze(CLI::App& app);
[[nodiscard]] Command add_step(CLI::App& app);
[[nodiscard]] Command add_forces(CLI::App& app);
[[nodiscard]] Command add_branches(CLI::App& app);
[[nodiscard]] Command add_mobility(CLI::App& app);
[[nodiscard]] Command add_map(CLI::App& app);
[[nodiscard]] Command add_draw(CLI::App& app);
[[nodiscard]] Command add_export(CLI::App& app);
[[nodiscard]] Command add_plot(CLI::App& app);
[[nodiscard]] Command add_polygon(CLI::App& app);
[[nodiscard]] Command add_report(CLI::App& app);
[[nodiscard]] Command add_check(CLI::App& app);
[[nodiscard]] Command add_sweep(CLI::App& app);
[[nodiscard]] Command add_sensitivity(CLI::App& app);
[[nodiscard]] Command add_design(CLI::App& app);
[[nodiscard]] Command add_fit(CLI::App& app);
[[nodiscard]] Command add_verify(CLI::App& app);
/// @}

}  // namespace higherpair::cli
