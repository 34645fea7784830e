#include "commands.hpp"
#include "fit_report.hpp"
#include "option_checks.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "signals.hpp"
#include "status_line.hpp"

#include <algorithm>
#include <atomic>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace higherpair::cli {
namespace {

struct FitCommandOptions : ProfileOptions {  // `profile`: with `curve` the points
  std::string measured;                      ///< empty: none
  std::optional<std::string> output;
  std::optional<std::string> json;
  std::optional<std::string> csv;    ///< residuals
  std::optional<std::string> curve;  ///< type of curve that is fitted to points
  std::optional<std::string> loss;
  FitSettings settings;
};

std::vector<NamedFile> outputs_of(const FitCommandOptions& options) {
  return given({{"--output", options.output}, {"--json", options.json}, {"--csv", options.csv}});
}

void check_options(const FitCommandOptions& options) {
  if (options.curve && !options.measured.empty()) {
    throw CLI::ValidationError("--curve", "FILE has the points: no second file is read");
  }
  if (!options.curve && options.measured.empty()) {
    throw CLI::ValidationError(
        "MEASURED",
        "the table of what was measured is missing; without a profile a curve is fitted to points "
        "with --curve line, circle, ellipse, parabola, hyperbola or conic");
  }
  if (!options.curve && !options.output) {
    throw CLI::ValidationError("--output", "is missing: where the fitted profile goes, -o FITTED.toml");
  }
  std::vector<NamedFile> inputs = {{"FILE", options.profile}};
  if (!options.measured.empty()) inputs.push_back({"MEASURED", options.measured});
  check_files(inputs, outputs_of(options));
}

void refuse_with_curve(const FitCommandOptions& options) {
  if (!options.curve) return;
  const auto refuse = [](bool given, const char* name) {
    if (given) throw CLI::ValidationError(name, "means nothing with --curve");
  };
  refuse(!options.overrides.empty(), "--set");
  refuse(options.loss.has_value(), "--loss");
  refuse(!options.settings.columns.empty(), "--columns");
  refuse(!options.settings.offsets.empty(), "--offset");
  refuse(options.settings.starts.has_value(), "--starts");
  refuse(options.settings.seed.has_value(), "--seed");
}

template <class Names>
std::size_t index_of(const Names& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

// Writes the outputs asked for, and the text to standard output unless another output goes there; see
// write_files.
template <class Report>
bool write(const FitCommandOptions& options, const Report& report, const std::atomic<bool>* stop) {
  std::vector<FileText> files;
  if (options.output) files.push_back({*options.output, report.text});
  if (options.json) files.push_back({*options.json, fit_json(report)});
  if (options.csv) files.push_back({*options.csv, fit_csv(report)});
  const bool to_output =
      std::any_of(files.begin(), files.end(), [](const FileText& file) { return file.path == "-"; });
  if (!write_files(files, stop)) return false;
  if (!to_output) fmt::print("{}", fit_text(report));
  return true;
}

int fit_points(const FitCommandOptions& options) {
  const auto points = read_measured_file(options.profile, {"x", "y"});
  if (!points) {
    return report_error(points.error());
  }
  const auto report =
      fit_curve(*points, static_cast<FittedCurve>(index_of(fitted_curve_names(), *options.curve)),
                options.settings.confidence.value_or(0.95));
  if (!report) {
    return report_error(report.error());
  }
  return write(options, *report, &interruption()) ? kExitOk : exit_unwritten();
}

std::string how_far(const FitProgress& progress) {
  return fmt::format("{} of {} searches, {:.3g} % of the spread missed{}", progress.starts,
                     progress.all_starts, 100 * progress.off,
                     progress.rounds > 0 ? fmt::format(", round {}", progress.rounds) : "");
}

FitSettings settings_of(const FitCommandOptions& options, StatusLine& line) {
  FitSettings settings = options.settings;
  if (options.loss) settings.loss = static_cast<FitLoss>(index_of(fit_loss_names(), *options.loss));
  settings.progress = [&line](const FitProgress& progress) { line.show(how_far(progress)); };
  return settings;
}

// Fits the profile's variables to measured motion, or a curve to measured points; returns the exit code: 4
// if the fit is not good (FitReport::good), 130 if it was interrupted; the results are written all the same.
int fit_command(const FitCommandOptions& options) {
  if (options.curve) {
    return fit_points(options);
  }
  const auto model = open_model(options, outputs_of(options));
  if (!model) {
    return report_error(model.error());
  }
  const auto measured = read_measured_file(options.measured);
  if (!measured) {
    return report_error(measured.error());
  }
  listen_to_signals();
  const auto report = [&] {
    StatusLine line(!options.quiet);
    return fit(*model, *measured, settings_of(options, line));
  }();
  if (!report) {
    return report_error(report.error());
  }
  // The results so far are written after a signal, too.
  if (!write(options, *report, report->end == FitEnd::kStopped ? nullptr : &interruption())) {
    return exit_unwritten();
  }
  if (report->end == FitEnd::kStopped) {
    return kExitInterrupted;
  }
  return report->good ? kExitOk : kExitRows;
}

}  // namespace

CommandRun add_fit(CLI::App& command) {
  const auto options = std::make_shared<FitCommandOptions>();
  options->settings.stop = &interruption();
  add_profile_options(command, *options,
                      "profile with [design.variables] (TOML); with --curve the points (CSV)");
  command.add_option("MEASURED", options->measured,
                     "what was measured (CSV): driver or time, and columns of the profile's tables");
  command.add_option("-o,--output", options->output, "the fitted profile, or curve; -: standard output");
  command.add_option("--json", options->json, "what was found as JSON, to this file; -: standard output");
  command.add_option("--csv", options->csv, "residuals as CSV, to this file; -: standard output");
  command.add_option("--curve", options->curve, "fit this curve to points")
      ->check(CLI::IsMember(fitted_curve_names()));
  command.add_option("--loss", options->loss, "how residuals count: by squares (default), huber or tukey")
      ->check(CLI::IsMember(fit_loss_names()));
  command.add_option("--confidence", options->settings.confidence, "of the intervals (default 0.95)")
      ->check(share());
  command
      .add_option("--columns", options->settings.columns,
                  "GLOB[,GLOB]: only these measured columns; repeatable")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--offset", options->settings.offsets,
                  "COLUMN[,COLUMN]: their zero is not known; driver or time as well; repeatable")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--starts", options->settings.starts,
                  "searches (default 12 where all variables have bounds, else 1)")
      ->check(CLI::Range(1, 1'000'000));
  command
      .add_option("--seed", options->settings.seed,
                  "of the random starts (default 1): the same seed, the same result")
      ->check(not_negative());
  add_threads_option(command, options->settings.threads);
  command.final_callback([options] {
    refuse_with_curve(*options);
    check_options(*options);
  });
  return [options] { return fit_command(*options); };
}

}  // namespace higherpair::cli
