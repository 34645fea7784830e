#include "commands.hpp"
#include "event_text.hpp"
#include "higherpair/higherpair.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "option_checks.hpp"
#include "outcome.hpp"
#include "output_options.hpp"
#include "picture.hpp"
#include "signals.hpp"
#include "tell.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

namespace higherpair::cli {
namespace {

struct DrawOptions : ProfileOptions {
  std::string output;
  bool strip = false;
  std::vector<std::string> layers;
  bool linkage = false;
  std::optional<double> width;
  SceneSettings settings;
};

// Layers of the equivalent linkage alone, with the parts that it is attached to.
const std::vector<Role> kLinkageAlone{Role::kFixed, Role::kLinkage, Role::kContact, Role::kLabel};

Result<std::vector<Role>> layers_of(const DrawOptions& options) {
  std::vector<std::string> names;
  for (int role = 0; role < kRoleCount; ++role) {
    names.emplace_back(name_of(static_cast<Role>(role)));
  }
  std::vector<Role> layers;
  for (const std::string& name : options.layers) {
    const auto role = role_of(name);
    if (!role) {
      return tl::unexpected(
          Error{ErrorKind::kInput,
                {about("--layers", fmt::format("there is no layer {}; {}", name, suggestion(name, names)))}});
    }
    layers.push_back(*role);
  }
  return layers.empty() && options.linkage ? kLinkageAlone : layers;
}

// Reports what is wrong with the path to the positions drawn; returns the exit code.
int judge(const DrawOptions& options, const Model& model, const Scenes& scenes) {
  if (scenes.limit) {
    tell("higherpair: driver = {} cannot be reached; drawn at the limit position {}: {}\n",
         *options.settings.at, *scenes.limit, scenes.cause);
    return kExitRows;
  }
  if (!scenes.left_out.empty()) {
    tell("higherpair: positions that cannot be reached are left out: driver = {:.9g}\n",
         fmt::join(scenes.left_out, ", "));
  }
  print_passed(scenes.passed, model);
  return scenes.left_out.empty() && scenes.passed.empty() ? kExitOk : kExitRows;
}

// Draws the mechanism; returns the exit code: 4 if it is drawn at a limit before the position asked for.
int draw_command(const DrawOptions& options) {
  const auto layers = layers_of(options);
  if (!layers) {
    return report_error(layers.error());
  }
  const auto model = open_model(options, {{"--output", options.output}});
  if (!model) {
    return report_error(model.error());
  }
  listen_to_signals();
  SceneSettings settings = options.settings;
  settings.forces = std::find(layers->begin(), layers->end(), Role::kForce) != layers->end();
  const auto scenes = scenes_of(*model, settings);
  if (!scenes) {
    return exit_failed(scenes.error());
  }
  DrawSettings draw = draw_settings(model->units());
  draw.layers = *layers;
  if (options.width) {
    draw.width = *options.width;
    draw.most_height = std::numeric_limits<double>::infinity();
  }
  draw.strip = options.strip;
  draw.title = model->mechanism().title;
  if (!write_picture(options.output, draw_svg(scenes->scenes, draw))) {
    return exit_unwritten();
  }
  return judge(options, *model, *scenes);
}

}  // namespace

CommandRun add_draw(CLI::App& command) {
  const auto options = std::make_shared<DrawOptions>();
  options->settings.stop = &interruption();
  add_profile_options(command, *options);
  add_picture_option(command, options->profile, options->output);
  auto* at = command.add_option("--at", options->settings.at, "position of the driver; otherwise the first")
                 ->check(finite_number());
  auto* every = command
                    .add_option("--every", options->settings.every,
                                "X: draw positions of the driver that are this far apart, all in one picture")
                    ->excludes(at);
  command.add_flag("--strip", options->strip, "with --every: side by side")->needs(every);
  command
      .add_option(
          "--layers", options->layers,
          "LAYER[,LAYER]: what is drawn: ground, link, body, joint, gear, spring, contact, normal, tangent, "
          "curvature, linkage, center, trace, velocity, acceleration, force, driver, label")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--trace", options->settings.traces, "BODY.POINT: draw the path of this point; repeatable")
      ->allow_extra_args(false);
  command.add_flag("--linkage", options->linkage, "the equivalent linkage alone");
  command
      .add_option("--width", options->width, "width in px; otherwise 900, or less where the picture is high")
      ->check(CLI::Range(50.0, 10'000.0));
  add_tolerance_option(command, options->settings.tolerance);
  return [options] { return draw_command(*options); };
}

}  // namespace higherpair::cli
