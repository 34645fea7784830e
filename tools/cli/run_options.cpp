#include "commands.hpp"
#include "higherpair/analysis/status.hpp"
#include "output_options.hpp"
#include "run_command.hpp"

#include <memory>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

Command add_run(CLI::App& app, const std::string& name, const std::string& text,
                const std::shared_ptr<RunOptions>& options) {
  options->settings.stop = &interruption();
  CLI::App* command = app.add_subcommand(name, text);
  add_profile_options(*command, *options);
  add_output_options(*command, options->profile, {"the table", options->csv},
                     {"the table and the events", options->json},
                     {.events = &options->events, .hdf5 = &options->hdf5});
  command->add_option("--hdf5", options->hdf5, "write the table and the events as HDF5 to this file");
  command->add_option("--events", options->events,
                      "write the events as CSV to this file (-: standard output)");
  command->add_option("--samples", options->settings.samples, "number of rows, in place of driver.samples");
  add_tolerance_option(*command, options->settings.tolerance);
  add_threads_option(*command, options->threads);
  command->add_flag("--jerk", options->settings.jerk,
                    "columns of the true jerk, and of that of the frozen equivalent linkage");
  command
      ->add_option("--derivatives", options->settings.derivatives,
                   "columns of all time derivatives of bodies and points from the third to this one")
      ->check(CLI::Range(3, higherpair::kHighestDerivative));
  command
      ->add_option("--columns", options->settings.columns,
                   "GLOB[,GLOB]: only these columns, such as follower.*,touch.rho*; repeatable")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_flag("--summary", options->summary, "print the range of every column on standard output");
  return {command, [options] { return run_command(*options); }};
}

}  // namespace

Command add_analyze(CLI::App& app) {
  return add_run(app, "analyze", "motion at every driver position of the profile",
                 std::make_shared<RunOptions>());
}

Command add_step(CLI::App& app) {
  const auto options = std::make_shared<RunOptions>();
  options->settings.in_time = true;
  return add_run(app, "step", "motion in time, with the driver's velocity and acceleration", options);
}

Command add_forces(CLI::App& app) {
  const auto options = std::make_shared<RunOptions>();
  options->settings.forces = true;
  Command command =
      add_run(app, "forces",
              "motion at every driver position, with the reactions of joints and contacts and the effort "
              "of the drivers; there is no friction but what rolling needs",
              options);
  command.arguments->add_flag("--time", options->settings.in_time, "the motion in time, as step has it");
  return command;
}

}  // namespace higherpair::cli
