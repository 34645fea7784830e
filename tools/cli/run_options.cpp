#include "commands.hpp"
#include "higherpair/analysis/status.hpp"
#include "output_options.hpp"
#include "run_command.hpp"

#include <memory>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

CommandRun add_run(CLI::App& command, const std::shared_ptr<RunOptions>& options) {
  options->settings.stop = &interruption();
  add_profile_options(command, *options);
  add_output_options(command, options->profile, {"the table", options->csv},
                     {"the table and the events", options->json},
                     {.events = &options->events, .hdf5 = &options->hdf5});
  command.add_option("--hdf5", options->hdf5, "write the table and the events as HDF5 to this file");
  command.add_option("--events", options->events,
                     "write the events as CSV to this file (-: standard output)");
  command.add_option("--samples", options->settings.samples, "number of rows, in place of driver.samples");
  add_tolerance_option(command, options->settings.tolerance);
  add_threads_option(command, options->threads);
  command.add_flag("--jerk", options->settings.jerk,
                   "columns of the true jerk, and of that of the frozen equivalent linkage");
  command
      .add_option("--derivatives", options->settings.derivatives,
                  "columns of all time derivatives of bodies and points from the third to this one")
      ->check(CLI::Range(3, higherpair::kHighestDerivative));
  command
      .add_option("--columns", options->settings.columns,
                  "GLOB[,GLOB]: only these columns, such as follower.*,touch.rho*; repeatable")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_flag("--summary", options->summary, "print the range of every column on standard output");
  return [options] { return run_command(*options); };
}

}  // namespace

CommandRun add_analyze(CLI::App& command) {
  return add_run(command, std::make_shared<RunOptions>());
}

CommandRun add_step(CLI::App& command) {
  const auto options = std::make_shared<RunOptions>();
  options->settings.in_time = true;
  return add_run(command, options);
}

CommandRun add_forces(CLI::App& command) {
  const auto options = std::make_shared<RunOptions>();
  options->settings.forces = true;
  CommandRun run = add_run(command, options);
  command.add_flag("--time", options->settings.in_time, "the motion in time, as step has it");
  return run;
}

}  // namespace higherpair::cli
