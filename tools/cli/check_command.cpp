#include "check_report.hpp"
#include "commands.hpp"
#include "event_text.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "signals.hpp"

#include <memory>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

struct CheckOptions : ProfileOptions {
  std::optional<std::string> csv;
  std::optional<std::string> json;
  CheckSettings settings;
};

// Events that are printed beside the figures: those that end the path, and where accelerations are unbounded.
bool is_printed(EventType type) {
  return ends_path(type) || type == EventType::kConforming;
}

int write(const CheckOptions& options, const Model& model, const CheckReport& report) {
  if (report.stopped) {
    return kExitInterrupted;
  }
  const Forms forms = {[&] { return check_csv(report); }, [&] { return check_json(report); },
                       [&] { return check_text(report); }};
  if (!write_forms(options.csv, options.json, forms)) {
    return exit_unwritten();
  }
  print_notes(report.notes, options.quiet);
  if (!options.quiet) {
    std::vector<Event> printed;
    for (const Event& event : report.events) {
      if (is_printed(event.type)) printed.push_back(event);
    }
    print_events(printed, model);
  }
  return report.good ? kExitOk : kExitRows;
}

// Runs `check`; returns the exit code: 4 if a limit is not kept or the path is not good.
int check_command(const CheckOptions& options) {
  const auto model = open_model(options, given({{"--csv", options.csv}, {"--json", options.json}}));
  if (!model) {
    return report_error(model.error());
  }
  listen_to_signals();
  const auto report = check(*model, options.settings);
  return report ? write(options, *model, *report) : exit_failed(report.error());
}

}  // namespace

CommandRun add_check(CLI::App& command) {
  const auto options = std::make_shared<CheckOptions>();
  options->settings.stop = &interruption();
  add_profile_options(command, *options);
  add_output_options(command, options->profile, {"the figures, one to a row,", options->csv},
                     {"the figures", options->json});
  add_tolerance_option(command, options->settings.tolerance);
  add_unused_samples(command, "the whole path counts");
  command.add_flag("--time", options->settings.in_time, "the motion in time, as step has it");
  return [options] { return check_command(*options); };
}

}  // namespace higherpair::cli
