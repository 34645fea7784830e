#include "commands.hpp"
#include "higherpair/front/pictures.hpp"
#include "outcome.hpp"
#include "output_options.hpp"
#include "picture.hpp"
#include "signals.hpp"

#include <memory>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

struct PlotOptions : ProfileOptions {
  std::string output;
  double width = 720;
  PlotSettings settings;
};

// Plots columns of a run; returns the exit code: 4 if its path is not good.
int plot_command(const PlotOptions& options) {
  const auto model = open_model(options, {{"--output", options.output}});
  if (!model) {
    return report_error(model.error());
  }
  listen_to_signals();
  const auto plot = plot_of(*model, options.settings);
  if (!plot) {
    return exit_failed(plot.error());
  }
  print_notes(plot->notes, options.quiet);
  if (plot->stopped) {
    return kExitInterrupted;
  }
  if (!write_picture(options.output, plots_svg({plot->data}, options.width))) {
    return exit_unwritten();
  }
  return plot->good ? kExitOk : kExitRows;
}

}  // namespace

CommandRun add_plot(CLI::App& command) {
  const auto options = std::make_shared<PlotOptions>();
  options->settings.run.stop = &interruption();
  add_profile_options(command, *options);
  add_picture_option(command, options->profile, options->output);
  command
      .add_option("--y", options->settings.y,
                  "COLUMN[,COLUMN]: what is plotted, names or globs such as follower.*; repeatable")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->required();
  command.add_option("--x", options->settings.x, "COLUMN: what it is plotted against (default: driver)");
  command.add_flag("--time", options->settings.run.in_time, "the motion in time, as step has it");
  command.add_option("--samples", options->settings.run.samples,
                     "number of rows, in place of driver.samples");
  add_tolerance_option(command, options->settings.run.tolerance);
  command.add_option("--width", options->width, "width of the picture in px (default: 720)")
      ->check(CLI::Range(200.0, 10'000.0));
  return [options] { return plot_command(*options); };
}

}  // namespace higherpair::cli
