#include "run_command.hpp"

#include "higherpair/io/notes.hpp"
#include "progress.hpp"
#include "row_writer.hpp"
#include "summary.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>

#include <fmt/format.h>

namespace higherpair::cli {
namespace {

// A signal handler can reach nothing but a flag of this kind.
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);
void on_interrupt(int) {
  interrupted = true;
}

std::vector<RowWriter> open_outputs(const RunOptions& options) {
  std::vector<RowWriter> writers;
  if (options.csv) {
    writers.emplace_back(*options.csv, RowWriter::Format::kCsv);
  }
  if (options.json) {
    writers.emplace_back(*options.json, RowWriter::Format::kJson);
  }
  if (writers.empty() && !options.summary) {
    writers.emplace_back("-", RowWriter::Format::kCsv);
  }
  return writers;
}

bool failed(const std::vector<RowWriter>& writers) {
  return std::any_of(writers.begin(), writers.end(),
                     [](const RowWriter& writer) { return report_failure(writer.file()); });
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
  const Joint& driven = mechanism.joints[static_cast<std::size_t>(mechanism.drivers.front().joint)];
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

// All tables into their places, or none.
bool finish(std::vector<RowWriter>& writers, OutputFile* events, const Analysis& analysis) {
  std::vector<OutputFile*> files;
  if (events != nullptr) files.push_back(events);
  for (RowWriter& writer : writers) {
    writer.end(analysis.events(), analysis.good());
    files.push_back(&writer.file());
  }
  return commit_all(files);
}

// Writes all rows; returns the exit code.
int write_rows(const RunOptions& options, const Model& model, Analysis& analysis) {
  std::vector<RowWriter> writers = open_outputs(options);
  for (RowWriter& writer : writers) {
    writer.begin(model.mechanism().title, analysis.columns());
  }
  Summary summary(analysis);
  Progress progress(!options.quiet);
  Row row;
  while (analysis.next(row)) {
    if (row.number % 256 == 0 && failed(writers)) {
      return kExitMachine;
    }
    for (RowWriter& writer : writers) {
      writer.row(row);
    }
    if (options.summary) {
      summary.add(row);
    }
    progress.at(row.number, analysis.size());
  }
  if (analysis.stopped()) {
    return kExitInterrupted;
  }
  std::optional<OutputFile> events;
  if (options.events) {
    events.emplace(*options.events);
    events->write(events_csv(analysis.events(), model));
    events->finish();
  }
  if (!finish(writers, events ? &*events : nullptr, analysis)) {
    return interrupted ? kExitInterrupted : kExitMachine;
  }
  if (options.summary) {
    summary.print(model.mechanism().title);
  }
  if (!options.quiet) {
    print_events(analysis.events(), model);
  }
  return analysis.good() ? kExitOk : kExitRows;
}

RunSettings settings_of(const RunOptions& options) {
  RunSettings settings;
  settings.in_time = options.timed;
  settings.samples = options.samples;
  settings.forces = options.forces;
  settings.jerk = options.jerk;
  settings.derivatives = options.derivatives;
  settings.columns = options.columns;
  settings.tolerance = options.tolerance;
  settings.stop = &interrupted;
  return settings;
}

}  // namespace

// A write that waits for a reader comes back with an error instead of beginning again; a pipe that nobody
// reads is an error of its write.
void listen_to_signals() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    sigaction(number, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
}

// Of what reverses: " = -45.88 deg".
std::string value_text(const Event& event, const Model& model) {
  if (!event.value || !event.joint) {
    return "";
  }
  const Joint& joint = model.mechanism().joints[static_cast<std::size_t>(*event.joint)];
  const Dimension& of = has_angle(joint.type) ? dimension::kAngle : dimension::kLength;
  return fmt::format(" = {:.10g} {}", *event.value, unit_text(of, model.units()));
}

void print_events(const std::vector<Event>& events, const Model& model) {
  const std::string unit = driver_unit(model);
  for (const Event& event : events) {
    const std::string item = event.item.empty() ? "" : ": " + event.item;
    const std::string time = event.time ? fmt::format(", time = {:.15g}", *event.time) : "";
    fmt::print(stderr, "{} at driver = {:.15g} {}{}{}{}: {}\n", name_of(event.type), event.driver, unit, time,
               item, value_text(event, model), event.cause);
  }
}

const std::atomic<bool>& interruption() {
  return interrupted;
}

int report_error(const Error& error) {
  fmt::print(stderr, "{}\n", to_string(error));
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

void print_notes(const Diagnostics& notes, bool quiet) {
  for (const Diagnostic& note : notes) {
    if (!quiet) fmt::print(stderr, "{}\n", note_text(note));
  }
}

Result<Model> open_model(const std::string& path, const std::vector<std::string>& overrides, bool quiet) {
  auto model = Model::open(path, overrides);
  if (model) {
    print_notes(model->notes(), quiet);
  }
  return model;
}

int run_command(const RunOptions& options) {
  const auto model = open_model(options.profile, options.overrides, options.quiet);
  if (!model) {
    return report_error(model.error());
  }
  listen_to_signals();
  auto analysis = model->start(settings_of(options));
  if (!analysis) {
    return report_error(analysis.error());
  }
  print_notes(analysis->notes(), options.quiet);
  return write_rows(options, *model, *analysis);
}

}  // namespace higherpair::cli
