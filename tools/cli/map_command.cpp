#include "commands.hpp"
#include "higherpair/front/pictures.hpp"
#include "map_report.hpp"
#include "option_checks.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "picture.hpp"
#include "signals.hpp"
#include "tell.hpp"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

struct MapOptions : ProfileOptions {
  std::optional<std::string> csv;
  std::optional<std::string> json;
  std::optional<std::string> output;  ///< path of the picture
  MapSettings settings;
};

bool write_all(const MapOptions& options, const MapReport& report) {
  std::vector<FileText> pictures;
  if (options.output) {
    pictures.push_back({*options.output, picture_for(*options.output, plots_svg(plots_of(report)))});
  }
  return write_forms(
      options.csv, options.json,
      {[&] { return map_csv(report); }, [&] { return map_json(report); }, [&] { return map_text(report); }},
      pictures);
}

void print_remarks(const MapOptions& options, const MapReport& report) {
  if (options.quiet) {
    return;
  }
  if (!report.not_started.empty()) {
    tell("{}: the mechanism is on no branch: {}\n", options.profile, report.not_started);
  }
  const bool text = !options.csv && !options.json;
  for (const ContactMapReport& contact : report.contacts) {
    if (!contact.refusal.empty() && !text) {
      tell("{}: contacts.{}: no map: {}\n", options.profile, contact.contact, contact.refusal);
    }
    if (!contact.complete && !text) {
      tell("{}: contacts.{}: not every branch could be followed to its end\n", options.profile,
           contact.contact);
    }
  }
}

// Maps all contacts of every pair over its driver's turn; returns the exit code: 3 if no contact has a map,
// 4 if one is incomplete.
int map_command(const MapOptions& options) {
  const auto model = open_model(
      options, given({{"--csv", options.csv}, {"--json", options.json}, {"--output", options.output}}));
  if (!model) {
    return report_error(model.error());
  }
  listen_to_signals();
  const auto report = map_of(*model, options.settings);
  if (!report) {
    return report_error(report.error());
  }
  if (report->stopped) {
    return kExitInterrupted;
  }
  if (!write_all(options, *report)) {
    return exit_unwritten();
  }
  print_remarks(options, *report);
  const bool complete = std::all_of(report->contacts.begin(), report->contacts.end(),
                                    [](const ContactMapReport& contact) { return contact.complete; });
  return complete ? kExitOk : kExitRows;
}

}  // namespace

CommandRun add_map(CLI::App& command) {
  const auto options = std::make_shared<MapOptions>();
  options->settings.stop = &interruption();
  add_profile_options(command, *options);
  add_output_options(command, options->profile, {"the branches", options->csv}, {"the map", options->json},
                     {.picture = &options->output});
  command.add_option("-o,--output", options->output,
                     "the map as a picture besides its tables: a file that ends in .svg, .pdf or .png");
  command
      .add_option("--samples", options->settings.samples, "number of rows over the range, both ends included")
      ->check(CLI::Range(std::int64_t{2}, kMostMapRows));
  command
      .add_option("--tolerance", options->settings.tolerance,
                  "largest overlap of a contact that counts as free, relative to the size")
      ->check(positive_number());
  return [options] { return map_command(*options); };
}

}  // namespace higherpair::cli
