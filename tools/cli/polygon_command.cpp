#include "commands.hpp"
#include "event_text.hpp"
#include "higherpair/front/pictures.hpp"
#include "option_checks.hpp"
#include "outcome.hpp"
#include "output_options.hpp"
#include "picture.hpp"
#include "signals.hpp"
#include "tell.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace higherpair::cli {
namespace {

struct PolygonOptions : ProfileOptions {
  std::string output;
  double width = 860;
  PolygonSettings settings;
};

// Draws the polygons of one position; returns the exit code: 4 if that cannot be reached and they are drawn
// at the limit before it.
int polygon_command(const PolygonOptions& options) {
  const auto model = open_model(options, {{"--output", options.output}});
  if (!model) {
    return report_error(model.error());
  }
  listen_to_signals();
  const auto found = polygons_of(*model, options.settings);
  if (!found) {
    return exit_failed(found.error());
  }
  const std::string& name = model->mechanism().title;
  const std::string title = fmt::format("{}{}driver = {:.6g} {}", name, name.empty() ? "" : ", ",
                                        found->driver, found->driver_unit);
  if (!write_picture(options.output, polygons_svg(found->polygons, title, options.width))) {
    return exit_unwritten();
  }
  if (found->limit) {
    tell("{}: driver = {} cannot be reached: drawn at the limit position {:.9g} before it: {}\n",
         options.profile, options.settings.at, found->driver, *found->limit);
    return kExitRows;
  }
  print_passed(found->passed, *model);
  return found->passed.empty() ? kExitOk : kExitRows;
}

}  // namespace

CommandRun add_polygon(CLI::App& command) {
  const auto options = std::make_shared<PolygonOptions>();
  options->settings.stop = &interruption();
  add_profile_options(command, *options);
  add_picture_option(command, options->profile, options->output);
  command.add_option("--at", options->settings.at, "position of the driver, in the profile's unit")
      ->required()
      ->check(finite_number());
  command.add_flag("--forces", options->settings.forces, "also the force polygon of every body");
  add_tolerance_option(command, options->settings.tolerance);
  command.add_option("--width", options->width, "width of the picture in px (default: 860)")
      ->check(CLI::Range(500.0, 10'000.0));
  return [options] { return polygon_command(*options); };
}

}  // namespace higherpair::cli
