#include "run_command.hpp"

#include "higherpair/io/diagnostic.hpp"
#include "progress.hpp"
#include "row_hdf5.hpp"
#include "row_writer.hpp"
#include "summary.hpp"
#include "tell.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <ctime>
#include <unistd.h>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

// A signal handler may only touch lock-free atomics, and call few functions.
std::atomic<bool> signalled = false;
std::atomic<std::time_t> first_signal = 0;  // [s]
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<std::time_t>::is_always_lock_free);

void end_at_once(int) {
  _exit(kExitInterrupted);
}

// The second signal ends the program, in case no loop heeds the first one. Not within a second or two:
// timeout(1) sends the same signal twice.
void on_interrupt(int number) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  signalled = true;
  std::time_t first = 0;
  if (!first_signal.compare_exchange_strong(first, now.tv_sec) && now.tv_sec > first + 1) {
    end_at_once(number);
  }
}

void on_signals(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    sigaction(number, &action, nullptr);
  }
}

std::string quoted(const std::string& text) {
  std::string doubled;
  for (const char c : text) {
    doubled += c;
    if (c == '"') doubled += c;
  }
  return fmt::format("\"{}\"", doubled);
}

std::string driver_unit(const Model& model) {
  const Mechanism& mechanism = model.mechanism();
  const Joint& driven = mechanism.joints[mechanism.drivers.front().joint];
  return unit_text(has_angle(driven.type) ? dimension::kAngle : dimension::kLength, model.units());
}

std::string events_csv(const std::vector<Event>& events, const Model& model) {
  std::string text = fmt::format("type,driver[{}],time[{}],item,row,cause\n", driver_unit(model),
                                 unit_text(dimension::kTime, model.units()));
  for (const Event& event : events) {
    text += fmt::format("{},{},{},{},{},{}\n", name_of(event.type), event.driver,
                        event.time ? fmt::format("{}", *event.time) : "", event.item, event.row,
                        quoted(event.cause));
  }
  return text;
}

// The value of an event at which a joint reverses: " = -45.88 deg"; empty for other events.
std::string value_text(const Event& event, const Model& model) {
  if (!event.value || !event.joint) {
    return "";
  }
  const Joint& joint = model.mechanism().joints[*event.joint];
  const Dimension& of = has_angle(joint.type) ? dimension::kAngle : dimension::kLength;
  return fmt::format(" = {:.10g} {}", *event.value, unit_text(of, model.units()));
}

std::vector<std::string> event_lines(const std::vector<Event>& events, const Model& model) {
  const std::string unit = driver_unit(model), time_unit = unit_text(dimension::kTime, model.units());
  std::vector<std::string> lines;
  for (const Event& event : events) {
    const std::string item = event.item.empty() ? "" : ": " + event.item;
    const std::string time = event.time ? fmt::format(", time = {:.15g} {}", *event.time, time_unit) : "";
    lines.push_back(fmt::format("{} at driver = {:.15g} {}{}{}{}: {}", name_of(event.type), event.driver,
                                unit, time, item, value_text(event, model), event.cause));
  }
  return lines;
}

// What the library calls the setting `columns`, or an override, is an option here: "setting columns driver"
// is `--columns driver`, "override driver.end=3" is `--set driver.end=3`.
std::string in_options(const std::string& source) {
  constexpr std::string_view kSetting = "setting ";
  constexpr std::string_view kOverride = "override ";
  return source.starts_with(kSetting)    ? "--" + source.substr(kSetting.size())
         : source.starts_with(kOverride) ? "--set " + source.substr(kOverride.size())
                                         : source;
}

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
    if (signalled) return;
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

}  // namespace

void end_on_signals() {
  on_signals(end_at_once);
  std::signal(SIGPIPE, SIG_IGN);
}

// A write that waits for a reader is not restarted after a signal but fails.
void listen_to_signals() {
  on_signals(on_interrupt);
}

void print_events(const std::vector<Event>& events, const Model& model) {
  for (const std::string& line : event_lines(events, model)) {
    tell("{}\n", line);
  }
}

void print_passed(const std::vector<Event>& passed, const Model& model) {
  if (!passed.empty()) {
    tell("higherpair: the motion from the first position to what is drawn goes over\n");
    print_events(passed, model);
  }
}

const std::atomic<bool>& interruption() {
  return signalled;
}

int exit_unwritten() {
  return signalled ? kExitInterrupted : kExitMachine;
}

int report_error(const Error& error) {
  Error said = error;
  for (Diagnostic& diagnostic : said.diagnostics) {
    diagnostic.place.source = in_options(diagnostic.place.source);
  }
  tell("{}\n", to_string(said));
  switch (error.kind) {
    case ErrorKind::kInput:
      return kExitInput;
    case ErrorKind::kMechanism:
      return kExitMechanism;
    case ErrorKind::kInternal:
      break;
  }
  return kExitMachine;
}

int exit_failed(const Error& error) {
  return signalled ? kExitInterrupted : report_error(error);
}

void print_notes(const Diagnostics& notes, bool quiet) {
  if (quiet) return;
  for (Diagnostic note : notes) {
    note.place.source = in_options(note.place.source);
    tell("{}\n", note_text(note));
  }
}

Result<Model> open_model(const ProfileOptions& options, const std::vector<NamedFile>& outputs, bool quiet) {
  auto model = Model::open(options.profile, options.overrides);
  if (!model) {
    return model;
  }
  std::vector<NamedFile> all = outputs;
  all.push_back({"standard output", "-"});
  if (auto refused = refused_output(*model, all)) {
    return tl::unexpected(*std::move(refused));
  }
  print_notes(model->notes(), quiet);
  return model;
}

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

}  // namespace higherpair::cli
