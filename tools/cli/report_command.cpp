#include "commands.hpp"
#include "event_text.hpp"
#include "file_text.hpp"
#include "higherpair/front/pictures.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "progress.hpp"
#include "signals.hpp"
#include "tell.hpp"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

struct ReportOptions : ProfileOptions {
  std::string output;
  ReportSettings settings;
};

namespace fs = std::filesystem;

// The input of the analysis: the profile's text, preceded by the changes made on the command line.
std::string source_of(const ReportOptions& options) {
  std::string source;
  for (const std::string& override : options.overrides) {
    source += "# --set " + override + "\n";
  }
  return source + file_text(options.profile).value_or("");
}

void check_output(const ReportOptions& options) {
  const fs::path path(options.output);
  if (path.extension() != ".html" && path.extension() != ".htm") {
    throw CLI::ValidationError("-o",
                               options.output + ": a report is a page; give it a name that ends in .html");
  }
  check_files({{"FILE", options.profile}}, {{"-o", options.output}});
}

ReportSettings settings_of(const ReportOptions& options, Progress& progress) {
  ReportSettings settings = options.settings;
  settings.source = source_of(options);
  settings.progress = [&progress](std::int64_t row, std::int64_t size) { progress.at(row, size); };
  return settings;
}

// Runs `report`; returns the exit code.
int report_command(const ReportOptions& options) {
  const auto model = open_model(options, {{"-o", options.output}});
  if (!model) {
    return report_error(model.error());
  }
  listen_to_signals();
  Progress progress(!options.quiet);
  const auto report = report_of(*model, settings_of(options, progress));
  if (!report) {
    return exit_failed(report.error());
  }
  print_notes(report->notes, options.quiet);
  if (report->stopped) {
    return kExitInterrupted;
  }
  if (!write_files({{options.output, report->html}}, &interruption())) {
    return exit_unwritten();
  }
  if (!options.quiet) {
    print_events(report->events, *model);
    if (report->every > 1) {
      tell("higherpair: the page holds one in {} of {} rows; its extremes and events are of all of them\n",
           report->every, report->size);
    }
  }
  return report->good ? kExitOk : kExitRows;
}

}  // namespace

CommandRun add_report(CLI::App& command) {
  const auto options = std::make_shared<ReportOptions>();
  options->settings.stop = &interruption();
  add_profile_options(command, *options);
  command.add_option("-o,--output", options->output, "the page to be written, F.html")->required();
  command.add_option("--samples", options->settings.samples, "number of rows, in place of driver.samples");
  add_tolerance_option(command, options->settings.tolerance);
  command.add_flag("--time", options->settings.in_time, "the motion in time, as `step` has it");
  command.final_callback([options] { check_output(*options); });
  return [options] { return report_command(*options); };
}

}  // namespace higherpair::cli
