#include "program.hpp"

#include "argument_error.hpp"
#include "branches_command.hpp"
#include "check_command.hpp"
#include "design_command.hpp"
#include "draw_command.hpp"
#include "export_command.hpp"
#include "fit_command.hpp"
#include "higherpair/front/model.hpp"
#include "map_command.hpp"
#include "mobility_command.hpp"
#include "plot_command.hpp"
#include "polygon_command.hpp"
#include "report_command.hpp"
#include "run_command.hpp"
#include "sensitivity_command.hpp"
#include "sweep_command.hpp"
#include "unknown_argument.hpp"
#include "verify_command.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace higherpair::cli {
namespace {

struct Command {
  CLI::App* arguments = nullptr;
  std::function<int()> run;
};

template <class Options>
Command command(CLI::App& app, CLI::App* (*add)(CLI::App&, Options&), int (*run)(const Options&)) {
  const auto options = std::make_shared<Options>();
  return {add(app, *options), [options, run] { return run(*options); }};
}

// In the order shown by `higherpair --help`.
std::vector<Command> commands_of(CLI::App& app) {
  return {
      command(app, add_analyze_command, run_command),
      command(app, add_step_command, run_command),
      command(app, add_forces_command, run_command),
      command(app, add_branches_command, branches_command),
      command(app, add_mobility_command, mobility_command),
      command(app, add_map_command, map_command),
      command(app, add_draw_command, draw_command),
      command(app, add_export_command, export_command),
      command(app, add_plot_command, plot_command),
      command(app, add_polygon_command, polygon_command),
      command(app, add_report_command, report_command),
      command(app, add_check_command, check_command),
      command<SweepOptions>(app, add_sweep_command, sweep_command),
      command(app, add_sensitivity_command, sensitivity_command),
      command(app, add_design_command, design_command),
      command(app, add_fit_command, fit_command),
      command(app, add_verify_command, verify_command),
  };
}

// An empty value often comes from an unset shell variable. If a value is left out, the parser takes the next
// option for it.
std::string missing_value(const CLI::App& command, const std::string& value) {
  if (value.empty()) return "is empty";
  const bool is_option = value.size() > 1 && value[0] == '-' && command.get_option_no_throw(value) != nullptr;
  return is_option ? "a value is missing before " + value : "";
}

void refuse_missing_values(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    option->check([&command](const std::string& value) { return missing_value(command, value); });
  }
}

}  // namespace

int run_program(int argc, char** argv) {
  CLI::App app("Analyses planar mechanisms whose bodies touch, by their equivalent linkages.", "higherpair");
  app.require_subcommand(1);
  const std::vector<Command> commands = commands_of(app);
  const std::string version = "higherpair " + std::string(higherpair::version());
  app.set_version_flag("--version", version);
  for (const Command& one : commands) {
    refuse_missing_values(*one.arguments);
    one.arguments->set_version_flag("--version", version);
  }
  const bool known = argc < 2 || argv[1][0] == '-' ||
                     std::any_of(commands.begin(), commands.end(),
                                 [&](const Command& one) { return one.arguments->check_name(argv[1]); });
  if (!known) {
    fmt::print(stderr, "higherpair: {}\n", unknown_command(app, argv[1]));
    return kExitInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    for (const CLI::App* one : app.get_subcommands()) {
      const std::string unknown = unknown_argument(*one);
      fmt::print(stderr, "higherpair: {}\n", unknown.empty() ? unknown_argument(app) : unknown);
    }
    return kExitInput;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
      return app.exit(error);
    }
    fmt::print(stderr, "higherpair: {}\n", argument_error(app, error));
    return kExitInput;
  }
  end_on_signals();
  return std::find_if(commands.begin(), commands.end(),
                      [](const Command& one) { return one.arguments->parsed(); })
      ->run();
}

}  // namespace higherpair::cli
