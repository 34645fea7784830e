#include "run_command.hpp"

#include "force_rows.hpp"
#include "higherpair/io/derivative_table.hpp"
#include "higherpair/io/jerk_table.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "progress.hpp"
#include "row_writer.hpp"
#include "summary.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
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

// All tables into their places, or none.
bool finish(std::vector<RowWriter>& writers, const std::vector<Event>& events) {
  std::vector<OutputFile*> files;
  for (RowWriter& writer : writers) {
    writer.end(events);
    files.push_back(&writer.file());
  }
  return commit_all(files);
}

const Joint& driven_joint(const Profile& profile) {
  const Mechanism& mechanism = profile.mechanism;
  return mechanism.joints[static_cast<std::size_t>(mechanism.drivers.front().joint)];
}

Dimension driver_dimension(const Profile& profile) {
  return driven_joint(profile).type == JointType::kRevolute ? dimension::kAngle : dimension::kLength;
}

// An event on the way to row k.
Event printed(const RunEvent& event, const Profile& profile, const DriverSchedule& schedule, std::int64_t k) {
  const Mechanism& mechanism = profile.mechanism;
  std::string item;
  if (event.contact) {
    item = mechanism.contacts[static_cast<std::size_t>(*event.contact)].name;
  } else if (event.joint) {
    item = mechanism.joints[static_cast<std::size_t>(*event.joint)].name;
  }
  const double driver = from_si(driver_dimension(profile), profile.units).apply(event.driver);
  std::optional<double> time;
  if (schedule.is_timed()) {
    time = schedule.passing_time(k, driver, event.share);
  }
  return {std::string(name_of(event.type)), driver, time, item, event.cause};
}

// Driver positions over the whole run, at most a thousand, in SI units.
std::vector<double> some_positions(const DriverSchedule& schedule) {
  std::vector<double> positions;
  const std::int64_t stride = std::max<std::int64_t>(1, schedule.size() / 1000);
  for (std::int64_t k = 0; k < schedule.size(); k += stride) {
    positions.push_back(schedule.state(k).si.position);
  }
  return positions;
}

int report_slip(const Slip& slip, const RunOptions& options, const Profile& profile) {
  const Dimension dimension = driver_dimension(profile);
  const Dimension per_unit = dimension::kLength / dimension;
  fmt::print(
      stderr,
      "{}: contacts.{}: this pair cannot roll: at driver = {} {} it would have to slip by {} {} of the "
      "driver; "
      "set rolling = false, or choose curves and joints whose contact point stays at the instant centre\n",
      options.profile, profile.mechanism.contacts[static_cast<std::size_t>(slip.contact)].name,
      from_si(dimension, profile.units).apply(slip.driver), unit_text(dimension, profile.units),
      from_si(per_unit, profile.units).apply(std::abs(slip.velocity)), unit_text(per_unit, profile.units));
  return kExitMechanism;
}

// The drivers in a row, in the profile's units and in SI.
void read_row(const DriverSchedule& schedule, std::int64_t k, std::vector<DriverState>& states,
              std::vector<DriverMotion>& motions) {
  states.resize(schedule.driver_count());
  motions.resize(schedule.driver_count());
  for (std::size_t i = 0; i < states.size(); ++i) {
    states[i] = schedule.state(k, i);
    motions[i] = {states[i].si.position, states[i].si.velocity, states[i].si.acceleration};
  }
}

// The tables of a run side by side.
struct Tables {
  MotionTable motion;
  std::optional<ForceRows> forces;
  std::optional<JerkTable> jerk;
  std::optional<DerivativeTable> derivatives;
  std::vector<Column> columns;

  // The cells of a row, valid until the next call.
  const std::vector<Cell>& cells(const Run& run, const std::vector<DriverState>& states,
                                 const std::vector<DriverMotion>& motions, double time,
                                 std::vector<Event>& events) {
    const std::vector<Cell>* cells = &motion.cells(run.row, states, time);
    cells = forces ? &forces->row(run, motions, *cells, events) : cells;
    cells = jerk ? &jerk->behind(*cells, run) : cells;
    return derivatives ? derivatives->behind(*cells, run, motions) : *cells;
  }

  [[nodiscard]] std::size_t status_column() const {
    const auto found = std::find_if(columns.begin(), columns.end(),
                                    [](const Column& column) { return column.name == "status"; });
    return static_cast<std::size_t>(found - columns.begin());
  }
};

tl::expected<Tables, Diagnostics> make_tables(const RunOptions& options, const Profile& profile,
                                              const Run& run) {
  auto motion = MotionTable::make(profile, options.timed);
  if (!motion) {
    return tl::unexpected(Diagnostics{about(options.profile, motion.error())});
  }
  Tables tables{*std::move(motion), std::nullopt, std::nullopt, std::nullopt, {}};
  tables.columns = tables.motion.columns();
  if (options.forces) {
    auto forces = ForceTable::make(profile, tables.columns);
    if (!forces) {
      return tl::unexpected(Diagnostics{about(options.profile, forces.error())});
    }
    tables.forces.emplace(profile, run, *std::move(forces));
    tables.columns = tables.forces->columns();
  }
  if (options.jerk) {
    tables.jerk.emplace(profile, run.plan);
    tables.columns.insert(tables.columns.end(), tables.jerk->columns().begin(), tables.jerk->columns().end());
  }
  if (options.derivatives) {
    tables.derivatives.emplace(profile, *options.derivatives);
    const std::vector<Column>& columns = tables.derivatives->columns();
    tables.columns.insert(tables.columns.end(), columns.begin(), columns.end());
  }
  return tables;
}

// The mechanism at its first position; else the message is printed.
tl::expected<Run, int> start(const RunOptions& options, const Profile& profile,
                             const DriverSchedule& schedule) {
  auto run = start_run(profile.mechanism, schedule.first_positions(), options.tolerance);
  const auto slip = run ? find_slip(*run, some_positions(schedule)) : run.error().slip;
  if (slip) {
    return tl::unexpected(report_slip(*slip, options, profile));
  }
  if (!run) {
    fmt::print(stderr, "{}: {}\n", options.profile, run.error().reason);
    return tl::unexpected(kExitMechanism);
  }
  return *std::move(run);
}

void print_events(const std::vector<Event>& events) {
  for (const Event& event : events) {
    const std::string item = event.item.empty() ? "" : ": " + event.item;
    const std::string time = event.time ? fmt::format(", time = {}", *event.time) : "";
    fmt::print(stderr, "{} at driver = {}{}{}: {}\n", event.type, event.driver, time, item, event.cause);
  }
}

// A limit or an overlap within the path, not at its very ends, even where the rows on both sides are `ok`.
bool spoils_path(const RunEvent& event, bool first, bool last) {
  constexpr double kAtEnd = 1e-9;
  const bool at_end = first || (last && event.share >= 1 - kAtEnd);
  return event.type == EventType::kOverlap || (event.type == EventType::kLimitPosition && !at_end);
}

// Moves to row k, by way of the place where the driver turns back if that lies between the rows: it may pass
// something there and pass it back.
// Whether the path there is good.
bool move_to_row(Run& run, const std::vector<DriverMotion>& motions, const Profile& profile,
                 const DriverSchedule& schedule, std::int64_t k, std::vector<Event>& events) {
  bool good = true;
  const auto note = [&](double from, double to) {
    for (RunEvent event : run.events) {
      event.share = std::lerp(from, to, event.share);
      good = good && !spoils_path(event, k == 0, k + 1 == schedule.size());
      events.push_back(printed(event, profile, schedule, k));
    }
  };
  const auto turning = schedule.turning_point(k);
  if (turning) {
    move_to(run, {{turning->si.position, turning->si.velocity, turning->si.acceleration}});
    note(0, turning->share);
  }
  move_to(run, motions);
  note(turning ? turning->share : 0, 1);
  return good;
}

// Runs through the schedule and writes; returns the exit code.
int write_rows(const RunOptions& options, const Profile& profile, const DriverSchedule& schedule, Run& run,
               Tables& tables) {
  std::vector<RowWriter> writers = open_outputs(options);
  for (RowWriter& writer : writers) {
    writer.begin(profile.mechanism.title, tables.columns);
  }
  Summary summary(tables.status_column());
  std::vector<Event> events;
  std::vector<DriverState> states;
  std::vector<DriverMotion> motions;
  bool all_ok = true;
  Progress progress(!options.quiet);
  for (std::int64_t k = 0; k < schedule.size(); ++k) {
    if (interrupted) {
      return kExitInterrupted;
    }
    if (k % 256 == 0 && failed(writers)) {
      return kExitMachine;
    }
    read_row(schedule, k, states, motions);
    const bool good = move_to_row(run, motions, profile, schedule, k, events);
    if (interrupted) {
      return kExitInterrupted;
    }
    all_ok = all_ok && good && run.row.status == RowStatus::kOk;
    const auto& cells = tables.cells(run, states, motions, schedule.time(k), events);
    for (RowWriter& writer : writers) {
      writer.row(cells);
    }
    if (options.summary) {
      summary.add(cells);
    }
    progress.at(k, schedule.size());
  }
  if (tables.forces) {
    tables.forces->finish(events);
    all_ok = all_ok && !tables.forces->opened();
  }
  if (!finish(writers, events)) {
    return interrupted ? kExitInterrupted : kExitMachine;
  }
  if (options.summary) {
    summary.print(profile.mechanism.title, tables.columns);
  }
  if (!options.quiet) {
    print_events(events);
  }
  return all_ok ? kExitOk : kExitRows;
}

}  // namespace

int report_input(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) {
    fmt::print(stderr, "{}\n", to_string(diagnostic));
  }
  return kExitInput;
}

std::optional<int> refuse_without_driver(const std::string& path, const Profile& profile) {
  if (!profile.mechanism.drivers.empty()) {
    return std::nullopt;
  }
  fmt::print(stderr, "{}: {}\n", path,
             driver_objection(profile.mechanism, std::vector<double>{})
                 .value_or("no driver: nothing moves this mechanism; `mobility` tells what it is"));
  return kExitMechanism;
}

int run_command(const RunOptions& options) {
  const auto profile = read_profile_file(options.profile, options.overrides);
  if (!profile) {
    return report_input(profile.error());
  }
  if (const auto code = refuse_without_driver(options.profile, *profile)) {
    return *code;
  }
  const auto schedule = options.timed ? DriverSchedule::step(*profile, options.samples)
                                      : DriverSchedule::analyze(*profile, options.samples);
  if (!schedule) {
    return report_input(schedule.error());
  }
  auto run = start(options, *profile, *schedule);
  if (!run) {
    return run.error();
  }
  auto tables = make_tables(options, *profile, *run);
  if (!tables) {
    return report_input(tables.error());
  }
  listen_to_signals();
  run->stop = &interrupted;
  return write_rows(options, *profile, *schedule, *run, *tables);
}

}  // namespace higherpair::cli
