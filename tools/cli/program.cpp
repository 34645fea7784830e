#include "program.hpp"

#include "argument_error.hpp"
#include "commands.hpp"
#include "higherpair/front/model.hpp"
#include "outcome.hpp"
#include "signals.hpp"
#include "tell.hpp"
#include "unknown_argument.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

struct Command {
  const char* name;
  const char* text;
  CommandRun (*add_options)(CLI::App& command);
};

// In the order shown by `higherpair --help`.
constexpr Command kCommands[] = {
    {"analyze", "motion at every driver position of the profile", add_analyze},
    {"step", "motion in time, with the driver's velocity and acceleration", add_step},
    {"forces",
     "motion at every driver position, with the reactions of joints and contacts and the effort of the "
     "drivers; there is no friction but what rolling needs",
     add_forces},
    {"branches", "every contact of the two curves at the first driver position, free or not", add_branches},
    {"mobility",
     "degree of freedom by count and by rank, idle freedoms, order of solution, Grashof class of every "
     "four-bar",
     add_mobility},
    {"map", "every contact of the two curves over the driver's turn: branches, and where they begin and end",
     add_map},
    {"draw", "a picture of the mechanism with its equivalent linkage, as SVG, PDF or PNG", add_draw},
    {"export", "curves of a profile, or paths of cutters along them, as CSV, DXF or SVG", add_export},
    {"plot", "columns of the table as a picture", add_plot},
    {"polygon", "velocity and acceleration polygons of one position, to scale, with their equations",
     add_polygon},
    {"report", "an interactive page: the moving mechanism, plots, the equivalent linkage, events",
     add_report},
    {"check",
     "pressure angles, radii of curvature, speeds, forces and sizes of cams and contacts, held to [limits]",
     add_check},
    {"sweep", "many variants of the mechanism, as [sweep] of the profile says, on all cores", add_sweep},
    {"sensitivity",
     "how results change with every dimension, exactly; with [tolerances] how far they scatter, and which "
     "tolerance to tighten",
     add_sensitivity},
    {"design", "the numbers that serve the profile's objectives best, written as a new profile", add_design},
    {"fit", "numbers of the profile from its measured motion; curves from measured points", add_fit},
    {"verify", "works out mechanisms whose motion is published or has a closed form, and compares",
     add_verify},
};

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
  end_on_signals();
  CLI::App app("Analyses planar mechanisms whose bodies touch, by their equivalent linkages.", "higherpair");
  app.require_subcommand(1);
  const std::string version = "higherpair " + std::string(higherpair::version());
  app.set_version_flag("--version", version);
  const std::vector<std::string_view> arguments(argv + std::min(argc, 1), argv + argc);
  const auto is_given = [&](const Command& one) {
    return std::find(arguments.begin(), arguments.end(), one.name) != arguments.end();
  };
  std::vector<std::pair<const CLI::App*, CommandRun>> given;
  for (const Command& one : kCommands) {
    CLI::App& command = *app.add_subcommand(one.name, one.text);
    if (is_given(one)) {  // the options of the others would take half of the time of a start
      given.emplace_back(&command, one.add_options(command));
      refuse_missing_values(command);
      command.set_version_flag("--version", version);
    }
  }
  const bool known = argc < 2 || argv[1][0] == '-' ||
                     std::any_of(std::begin(kCommands), std::end(kCommands),
                                 [&](const Command& one) { return arguments.front() == one.name; });
  if (!known) {
    tell("higherpair: {}\n", unknown_command(app, argv[1]));
    return kExitInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    for (const CLI::App* one : app.get_subcommands()) {
      const std::string unknown = unknown_argument(*one);
      tell("higherpair: {}\n", unknown.empty() ? unknown_argument(app) : unknown);
    }
    return kExitInput;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
      return app.exit(error);
    }
    tell("higherpair: {}\n", argument_error(app, error));
    return exit_code_of(error.get_exit_code());
  }
  const auto parsed =
      std::find_if(given.begin(), given.end(), [](const auto& one) { return one.first->parsed(); });
  return parsed->second();
}

}  // namespace higherpair::cli
