#include "commands.hpp"
#include "event_text.hpp"
#include "number_text.hpp"
#include "option_checks.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "output_options.hpp"
#include "sensitivity_report.hpp"
#include "signals.hpp"
#include "sweep/progress.hpp"
#include "tell.hpp"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace higherpair::cli {
namespace {

struct SensitivityOptions : ProfileOptions {
  std::optional<std::string> csv;
  std::optional<std::string> json;
  std::optional<std::string> rows;   ///< file for the derivatives of columns, row by row
  std::vector<std::string> results;  ///< COLUMN:OF
  std::vector<std::string> columns;  ///< of `rows`; empty: those of the results
  std::optional<std::int64_t> variants;
  std::optional<std::uint64_t> seed;
  std::size_t top = 10;
  SensitivitySettings settings;
};

// Quantiles need more than one variant.
constexpr std::int64_t kFewestVariants = 2;

int refuse(const std::string& message) {
  tell("higherpair: {}\n", message);
  return kExitInput;
}

// Writes the derivatives of columns as CSV while the rows are computed.
class RowsFile {
public:
  explicit RowsFile(const std::string& path) : file_(path) {}

  void begin(const SlopeTable& table) {
    columns_ = table.columns.size();
    std::string line;
    for (const Column& column : table.columns) {
      line += (line.empty() ? "" : ",") + csv_head(column);
    }
    for (const SensitivityNumber& number : table.numbers) {
      for (std::size_t c = 1; c < columns_; ++c) {
        const Column& column = table.columns[c];
        line += fmt::format(",d({})/d({})[{}]", column.name, number.name, unit_per(column.unit, number.unit));
      }
    }
    file_.write(line + "\n");
  }

  // Leaves out derivatives of the first column, which is the driver position or time.
  bool take(const RowSlopes& row) {
    std::string line;
    for (const double value : row.values) line += cell(value) + ",";
    for (std::size_t k = 0; k < row.slopes.size(); ++k) {
      if (k % columns_ != 0) line += cell(row.slopes[k]) + ",";
    }
    line.back() = '\n';
    file_.write(line);
    return file_.good();
  }

  OutputFile& file() { return file_; }

private:
  OutputFile file_;
  std::size_t columns_ = 0;
};

std::vector<std::string> columns_of_rows(const SensitivityOptions& options, const SensitivityReport& report) {
  std::vector<std::string> columns = options.columns;
  if (columns.empty()) {
    for (const ResultSensitivity& result : report.results) columns.push_back(result.measure.column);
  }
  return columns;
}

std::optional<int> write_rows(const SensitivityOptions& options, const Model& model,
                              const SensitivitySettings& settings, const SensitivityReport& report) {
  RowsFile rows(*options.rows);
  const auto table = sensitivity_rows(
      model, columns_of_rows(options, report), settings, [&](const SlopeTable& made) { rows.begin(made); },
      [&](const RowSlopes& row) { return rows.take(row); });
  if (!table) {
    return exit_failed(table.error());
  }
  if (table->stopped) {
    return kExitInterrupted;
  }
  rows.file().finish();
  const bool written = !interruption() && commit_all({&rows.file()});
  return written ? std::nullopt : std::optional(exit_unwritten());
}

Result<ToleranceVariants> run_variants(const SensitivityOptions& options, const Model& model,
                                       const SensitivityReport& report) {
  SweepProgress progress(0, *options.variants, !options.quiet);
  ToleranceVariantSettings settings;
  settings.count = *options.variants;
  settings.seed = options.seed.value_or(1);
  settings.threads = options.settings.threads;
  settings.samples = options.settings.samples;
  settings.tolerance = options.settings.tolerance;
  settings.stop = &interruption();
  settings.progress = [&](std::int64_t done) { progress.at(done); };
  return tolerance_variants(model, report, settings);
}

int write(const SensitivityOptions& options, const Model& model, const SensitivityFindings& findings) {
  const Forms forms = {[&] { return sensitivity_csv(findings); }, [&] { return sensitivity_json(findings); },
                       [&] { return sensitivity_text(findings); }};
  const bool rows_alone = options.rows == "-" && !options.csv && !options.json;
  if (!rows_alone && !write_forms(options.csv, options.json, forms)) {
    return exit_unwritten();
  }
  print_notes(findings.report.notes, options.quiet);
  if (!options.quiet && !findings.report.good) print_events(findings.report.events, model);
  const bool kept = std::all_of(findings.bands.begin(), findings.bands.end(),
                                [](const ToleranceBand& band) { return band.kept; });
  return findings.report.good && kept ? kExitOk : kExitRows;
}

std::vector<NamedFile> outputs_of(const SensitivityOptions& options) {
  return given({{"--csv", options.csv}, {"--json", options.json}, {"--rows", options.rows}});
}

void check_outputs(const SensitivityOptions& options) {
  std::vector<NamedFile> outputs = outputs_of(options);
  if (!options.csv && !options.json && options.rows != "-") outputs.push_back({"standard output", "-"});
  check_files({{"FILE", options.profile}}, outputs);
  if (!options.rows && !options.columns.empty()) {
    throw CLI::ValidationError("--columns", "only --rows writes columns: add --rows FILE");
  }
  if (options.seed && !options.variants) {
    throw CLI::ValidationError("--seed", "only variants are drawn: add --variants N");
  }
}

std::optional<int> refuse_variants(const SensitivityOptions& options, const Model& model) {
  if (!options.variants) {
    return std::nullopt;
  }
  if (!model.profile().tolerances) {
    return refuse("--variants: there is no [tolerances] in the profile: it says how numbers scatter");
  }
  if (!options.settings.by.empty()) {
    return refuse("--variants: the numbers that scatter are those of [tolerances]; leave --by out");
  }
  return std::nullopt;
}

// Runs `sensitivity`; returns the exit code: 4 if the path is not good, or a band is wider than wanted.
int sensitivity_command(const SensitivityOptions& options) {
  const auto model = open_model(options, outputs_of(options));
  if (!model) {
    return report_error(model.error());
  }
  if (const auto code = refuse_variants(options, *model)) {
    return *code;
  }
  listen_to_signals();
  SensitivitySettings settings = options.settings;
  for (const std::string& text : options.results) {
    auto measure = measure_from(*model, text, settings);
    if (!measure) {
      return report_error(measure.error());
    }
    settings.results.push_back(*std::move(measure));
  }
  auto report = sensitivity(*model, settings);
  if (!report) {
    return exit_failed(report.error());
  }
  if (report->stopped) {
    return kExitInterrupted;
  }
  SensitivityFindings findings;
  findings.report = *std::move(report);
  findings.top = options.top;
  if (model->profile().tolerances && options.settings.by.empty()) {
    findings.task = model->profile().tolerances.get();
    findings.bands = tolerance_bands(*findings.task, findings.report);
  }
  if (options.variants) {
    auto variants = run_variants(options, *model, findings.report);
    if (!variants) {
      return exit_failed(variants.error());
    }
    if (variants->stopped) {
      return kExitInterrupted;
    }
    findings.variants = *std::move(variants);
  }
  if (options.rows) {
    if (const auto code = write_rows(options, *model, settings, findings.report)) {
      return *code;
    }
  }
  return write(options, *model, findings);
}

}  // namespace

CommandRun add_sensitivity(CLI::App& command) {
  const auto options = std::make_shared<SensitivityOptions>();
  options->settings.stop = &interruption();
  add_profile_options(command, *options);
  add_forms(command, {"the derivatives", options->csv}, {"the derivatives and bands", options->json});
  command
      .add_option("--results", options->results,
                  "COLUMN:OF[,COLUMN:OF]: instead of those of the profile, such as follower.alpha:maxabs or "
                  "slider.x:at=30 or 'slider.x:at=0.5 rad'; repeatable")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--by", options->settings.by,
                  "GLOB[,GLOB]: paths of the numbers to differentiate by, such as bodies.crank.*; repeatable")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--rows", options->rows,
                     "write the derivatives of whole columns, row by row, as CSV to this file (-: standard "
                     "output)");
  command
      .add_option("--columns", options->columns,
                  "GLOB[,GLOB]: the columns of --rows; otherwise those of the results; repeatable")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--variants", options->variants,
                  "number of random variants by which the bands of [tolerances] are checked, such as 100000")
      ->check(CLI::Range(kFewestVariants, kMostToleranceVariants));
  command.add_option("--seed", options->seed, "other random variants (default 1)")->check(not_negative());
  command
      .add_option("--top", options->top, "number of dimensions that are printed of each result (default 10)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000}));
  command.add_option("--samples", options->settings.samples, "number of rows, in place of driver.samples");
  add_tolerance_option(command, options->settings.tolerance);
  add_threads_option(command, options->settings.threads);
  command.add_flag("--time", options->settings.in_time, "the motion in time, as step has it");
  command.final_callback([options] { check_outputs(*options); });
  return [options] { return sensitivity_command(*options); };
}

}  // namespace higherpair::cli
