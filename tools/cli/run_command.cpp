// The commands `analyze`, `step` and `forces`.
#include "commands.hpp"
#include "event_text.hpp"
#include "higherpair/analysis/status.hpp"
#include "outcome.hpp"
#include "output_options.hpp"
#include "progress.hpp"
#include "row_hdf5.hpp"
#include "row_writer.hpp"
#include "signals.hpp"
#include "summary.hpp"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>

namespace higherpair::cli {
namespace {

struct RunOptions : ProfileOptions {
  std::optional<std::string> csv;
  std::optional<std::string> json;
  std::optional<std::string> hdf5;
  std::optional<std::string> events;  ///< file of the events, as CSV
  RunSettings settings;
  int threads = 0;  ///< 0: as many as there are cores
  bool summary = false;
};

// All outputs that are written while a run goes on.
class Outputs {
public:
  Outputs(const RunOptions& options, const Model& model, const Analysis& analysis) {
    const std::string& title = model.mechanism().title;
    const auto add = [&](const std::string& path, RowWriter::Format format) {
      writers_.emplace_back(path, format, title, analysis.columns());
    };
    if (options.csv) add(*options.csv, RowWriter::Format::kCsv);
    if (options.json) add(*options.json, RowWriter::Format::kJson);
    if (options.hdf5) {
      const RowTitle head = {title, options.profile, driver_unit(model),
                             std::string(unit_text(dimension::kTime, model.units()))};
      hdf5_.emplace(*options.hdf5, head, analysis.columns(), analysis.size());
    }
    if (writers_.empty() && !hdf5_ && !options.summary) add("-", RowWriter::Format::kCsv);
    if (options.summary) summary_.emplace(analysis);
  }

  /// May be called from several threads at once.
  void make_texts(const RowBlock& block, BlockTexts& texts) const {
    texts.resize(writers_.size());
    for (std::size_t i = 0; i < writers_.size(); ++i) writers_[i].append_text(block, texts[i]);
  }

  [[nodiscard]] bool good() const {
    return std::all_of(writers_.begin(), writers_.end(), [](const auto& one) { return one.file().good(); }) &&
           (!hdf5_ || hdf5_->file().good());
  }

  /// To be called in the order of the blocks; false if an output has failed.
  [[nodiscard]] bool write(const RowBlock& block, const BlockTexts& texts) {
    for (std::size_t i = 0; i < writers_.size(); ++i) writers_[i].write(texts[i]);
    if (hdf5_) hdf5_->write(block);
    if (summary_) summary_->add(block);
    return good();
  }

  /// Puts all files into place, or none.
  [[nodiscard]] bool finish(OutputFile* events, const Analysis& analysis, const Model& model) {
    std::vector<OutputFile*> files;
    if (events != nullptr) files.push_back(events);
    for (RowWriter& writer : writers_) {
      writer.end(analysis.events(), analysis.good());
      files.push_back(&writer.file());
    }
    if (hdf5_) {
      hdf5_->end(analysis.events(), event_lines(analysis.events(), model), analysis.good());
      files.push_back(&hdf5_->file());
    }
    return commit_all(files);
  }

  /// Reports failed outputs, unless an interruption is the cause.
  void print_failure() const {
    if (interruption()) return;
    const bool said = std::any_of(writers_.begin(), writers_.end(),
                                  [](const auto& one) { return report_failure(one.file()); });
    if (!said && hdf5_) (void)report_failure(hdf5_->file());
  }

  [[nodiscard]] const std::optional<Summary>& summary() const { return summary_; }

private:
  std::vector<RowWriter> writers_;
  std::optional<RowHdf5> hdf5_;
  std::optional<Summary> summary_;
};

// Runs the analysis and writes all rows; returns the exit code.
int write_rows(const RunOptions& options, const Model& model, Analysis& analysis) {
  Outputs outputs(options, model, analysis);
  std::optional<OutputFile> events;
  if (options.events) events.emplace(*options.events);
  Progress progress(!options.quiet);
  bool written = outputs.good();
  if (!written) {
    outputs.print_failure();
    return exit_unwritten();
  }
  if (events && report_failure(*events)) {
    return exit_unwritten();
  }
  run_blocks(
      analysis, options.threads,
      [&](const RowBlock& block, BlockTexts& texts) { outputs.make_texts(block, texts); },
      [&](const RowBlock& block, const BlockTexts& texts) {
        progress.at(block.first, analysis.size());
        return written = outputs.write(block, texts);
      });
  print_notes(analysis.notes(), options.quiet);
  if (!written) {
    outputs.print_failure();
    return exit_unwritten();
  }
  if (analysis.stopped()) {
    return kExitInterrupted;
  }
  if (events) {
    events->write(events_csv(analysis.events(), model));
    events->finish();
  }
  if (!outputs.finish(events ? &*events : nullptr, analysis, model)) {
    return exit_unwritten();
  }
  if (outputs.summary()) {
    outputs.summary()->print(model.mechanism().title);
  }
  if (!options.quiet) {
    print_events(analysis.events(), model);
  }
  return analysis.good() ? kExitOk : kExitRows;
}

// Runs `analyze`, `step` or `forces`; returns the exit code.
int run_command(const RunOptions& options) {
  const auto model = open_model(options, given({{"--csv", options.csv},
                                                {"--json", options.json},
                                                {"--hdf5", options.hdf5},
                                                {"--events", options.events}}));
  if (!model) {
    return report_error(model.error());
  }
  listen_to_signals();
  auto analysis = model->start(options.settings);
  if (!analysis) {
    return exit_failed(analysis.error());
  }
  return write_rows(options, *model, *analysis);
}

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
