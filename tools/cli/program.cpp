#include "program.hpp"

#include "argument_error.hpp"
#include "commands.hpp"
#include "higherpair/front/model.hpp"
#include "run_command.hpp"
#include "unknown_argument.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace higherpair::cli {
namespace {

// In the order shown by `higherpair --help`.
std::vector<Command> commands_of(CLI::App& app) {
  return {add_analyze(app), add_step(app),  add_forces(app), add_branches(app),    add_mobility(app),
          add_map(app),     add_draw(app),  add_export(app), add_plot(app),        add_polygon(app),
          add_report(app),  add_check(app), add_sweep(app),  add_sensitivity(app), add_design(app),
          add_fit(app),     add_verify(app)};
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
    return exit_code_of(error.get_exit_code());
  }
  end_on_signals();
  return std::find_if(commands.begin(), commands.end(),
                      [](const Command& one) { return one.arguments->parsed(); })
      ->run();
}

}  // namespace higherpair::cli
