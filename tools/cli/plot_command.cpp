#include "commands.hpp"
#include "higherpair/front/pictures.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "picture.hpp"
#include "run_command.hpp"

#include <memory>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

struct PlotOptions {
  std::string profile;
  std::string output;
  std::vector<std::string> y;
  std::optional<std::string> x;
  std::vector<std::string> overrides;
  std::optional<std::int64_t> samples;
  double tolerance = 1e-9;
  double width = 720;
  bool timed = false;  ///< the motion in time, as in `step`
  bool quiet = false;
};

// Plots columns of a run; returns the exit code: 4 if its path is not good.
int plot_command(const PlotOptions& options) {
  const auto model =
      open_model(options.profile, options.overrides, options.quiet, {{"--output", options.output}});
  if (!model) {
    return report_error(model.error());
  }
  listen_to_signals();
  PlotSettings settings;
  settings.y = options.y;
  settings.x = options.x;
  settings.run.in_time = options.timed;
  settings.run.samples = options.samples;
  settings.run.tolerance = options.tolerance;
  settings.run.stop = &interruption();
  const auto plot = plot_of(*model, settings);
  if (!plot) {
    return exit_failed(plot.error());
  }
  print_notes(plot->notes, options.quiet);
  if (plot->stopped) {
    return kExitInterrupted;
  }
  if (!write_files({{options.output, picture_for(options.output, plots_svg({plot->data}, options.width))}},
                   &interruption())) {
    return exit_unwritten();
  }
  return plot->good ? kExitOk : kExitRows;
}

}  // namespace

Command add_plot(CLI::App& app) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* command = app.add_subcommand("plot", "columns of the table as a picture");
  command->add_option("FILE", options->profile, "profile of the mechanism (TOML)")->required();
  add_picture_option(*command, options->output);
  command
      ->add_option("--y", options->y,
                   "COLUMN[,COLUMN]: what is plotted, names or globs such as follower.*; repeatable")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->required();
  command->add_option("--x", options->x, "COLUMN: what it is plotted against (default: driver)");
  command->add_flag("--time", options->timed, "the motion in time, as step has it");
  add_set_option(*command, options->overrides);
  command->add_option("--samples", options->samples, "number of rows");
  add_tolerance_option(*command, options->tolerance);
  command->add_option("--width", options->width, "width of the picture in px (default: 720)")
      ->check(CLI::Range(200.0, 10'000.0));
  command->add_flag("--quiet", options->quiet, "no notes on standard error");
  command->final_callback([options] {
    refuse_shared_files({{"FILE", options->profile}}, {{"--output", options->output}});
    check_picture(options->output);
  });
  return {command, [options] { return plot_command(*options); }};
}

}  // namespace higherpair::cli
