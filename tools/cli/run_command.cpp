#include "run_command.hpp"

#include "force_rows.hpp"
#include "higherpair/io/jerk_table.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "row_writer.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <ctime>
#include <map>
#include <unistd.h>

#include <fmt/format.h>

namespace higherpair::cli {
namespace {

// A signal handler can reach nothing but a flag of this kind.
volatile std::sig_atomic_t interrupted = 0;
void on_interrupt(int) {
  interrupted = 1;
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
  for (const RowWriter& writer : writers) {
    if (!writer.file().good()) {
      fmt::print(stderr, "higherpair: {}\n", writer.file().error());
      return true;
    }
  }
  return false;
}

// Smallest and largest value of every column, and how many rows have which status (the column of that
// number).
struct Summary {
  struct Range {
    double low = INFINITY;
    double high = -INFINITY;
  };
  std::vector<Range> ranges;
  std::map<std::string, std::int64_t> statuses;

  void add(const std::vector<Cell>& cells, std::size_t status) {
    ranges.resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (const auto* number = std::get_if<double>(&cells[i])) {
        ranges[i].low = std::min(ranges[i].low, *number);
        ranges[i].high = std::max(ranges[i].high, *number);
      }
    }
    ++statuses[std::string(std::get<std::string_view>(cells[status]))];
  }

  void print(const std::string& title, const std::vector<Column>& columns) const {
    fmt::print("{}\n\n{:<28}{:>16}{:>16}  unit\n", title, "column", "smallest", "largest");
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].unit.empty() || ranges[i].low > ranges[i].high) {
        continue;
      }
      fmt::print("{:<28}{:>16.7g}{:>16.7g}  {}\n", columns[i].name, ranges[i].low, ranges[i].high,
                 columns[i].unit);
    }
    fmt::print("\nrows:");
    for (const auto& [status, count] : statuses) {
      fmt::print(" {} {}", count, status);
    }
    fmt::print("\n");
  }
};

void print_progress(std::int64_t row, std::int64_t size) {
  fmt::print(stderr, "\r{:3}%", 100 * row / size);
  std::fflush(stderr);
}

class Progress {
public:
  explicit Progress(bool wanted) : wanted_(wanted && isatty(STDERR_FILENO) == 1), start_(std::clock()) {}
  ~Progress() {
    if (shown_) {
      fmt::print(stderr, "\r    \r");
    }
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void at(std::int64_t row, std::int64_t size) {
    if (!wanted_ || row % 4096 != 0 || std::clock() - start_ < CLOCKS_PER_SEC) {
      return;
    }
    shown_ = true;
    print_progress(row, size);
  }

private:
  bool wanted_;
  bool shown_ = false;
  std::clock_t start_;
};

const Joint& driven_joint(const Profile& profile) {
  const Mechanism& mechanism = profile.mechanism;
  return mechanism.joints[static_cast<std::size_t>(mechanism.drivers.front().joint)];
}

Dimension driver_dimension(const Profile& profile) {
  return driven_joint(profile).type == JointType::kRevolute ? dimension::kAngle : dimension::kLength;
}

Event printed(const RunEvent& event, const Profile& profile) {
  const Mechanism& mechanism = profile.mechanism;
  std::string item;
  if (event.contact) {
    item = mechanism.contacts[static_cast<std::size_t>(*event.contact)].name;
  } else if (event.joint) {
    item = mechanism.joints[static_cast<std::size_t>(*event.joint)].name;
  }
  return {std::string(name_of(event.type)),
          from_si(driver_dimension(profile), profile.units).apply(event.driver), std::nullopt, item,
          event.cause};
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

std::vector<double> first_positions(const DriverSchedule& schedule) {
  std::vector<double> positions;
  for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
    positions.push_back(schedule.state(0, i).si.position);
  }
  return positions;
}

}  // namespace

int report_input(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) {
    fmt::print(stderr, "{}\n", to_string(diagnostic));
  }
  return kExitInput;
}

int run_command(const RunOptions& options) {
  const auto profile = read_profile_file(options.profile, options.overrides);
  if (!profile) {
    return report_input(profile.error());
  }
  const auto schedule = options.timed ? DriverSchedule::step(*profile, options.samples)
                                      : DriverSchedule::analyze(*profile, options.samples);
  if (!schedule) {
    return report_input(schedule.error());
  }
  auto run = start_run(profile->mechanism, first_positions(*schedule), options.tolerance);
  if (!run && run.error().slip) {
    return report_slip(*run.error().slip, options, *profile);
  }
  if (!run) {
    fmt::print(stderr, "{}: {}\n", options.profile, run.error().reason);
    return kExitMechanism;
  }
  if (const auto slip = find_slip(*run, some_positions(*schedule))) {
    return report_slip(*slip, options, *profile);
  }
  auto table = MotionTable::make(*profile, options.timed);
  if (!table) {
    return report_input({about(options.profile, table.error())});
  }
  std::optional<ForceRows> forces;
  if (options.forces) {
    auto force_table = ForceTable::make(*profile, table->columns());
    if (!force_table) {
      return report_input({about(options.profile, force_table.error())});
    }
    forces.emplace(*profile, *run, *std::move(force_table));
  }
  std::vector<Column> columns = forces ? forces->columns() : table->columns();
  std::optional<JerkTable> jerk;
  if (options.jerk) {
    jerk.emplace(*profile, run->plan);
    columns.insert(columns.end(), jerk->columns().begin(), jerk->columns().end());
  }

  std::signal(SIGINT, on_interrupt);
  std::vector<RowWriter> writers = open_outputs(options);
  if (failed(writers)) {
    return kExitMachine;
  }
  for (RowWriter& writer : writers) {
    writer.begin(profile->mechanism.title, columns);
  }
  Summary summary;
  std::vector<Event> events;
  std::vector<DriverState> states;
  std::vector<DriverMotion> motions;
  bool all_ok = true;
  Progress progress(!options.quiet);
  for (std::int64_t k = 0; k < schedule->size(); ++k) {
    if (interrupted != 0) {
      return kExitInterrupted;
    }
    read_row(*schedule, k, states, motions);
    move_to(*run, motions);
    for (const RunEvent& event : run->events) {
      events.push_back(printed(event, *profile));
    }
    all_ok = all_ok && run->row.status == RowStatus::kOk;
    const auto& motion = table->cells(run->row, states, options.timed ? schedule->time(k) : 0);
    const auto& with_forces = forces ? forces->row(*run, motions, motion, events) : motion;
    const auto& cells = jerk ? jerk->behind(with_forces, *run) : with_forces;
    for (RowWriter& writer : writers) {
      writer.row(cells);
    }
    if (options.summary) {
      summary.add(cells, columns.size() - 2);
    }
    if (k % 4096 == 0 && failed(writers)) {
      return kExitMachine;
    }
    progress.at(k, schedule->size());
  }
  if (forces) {
    forces->finish(events);
    all_ok = all_ok && !forces->opened();
  }
  for (RowWriter& writer : writers) {
    writer.end(events);
  }
  if (failed(writers)) {
    return kExitMachine;
  }
  if (options.summary) {
    summary.print(profile->mechanism.title, columns);
  }
  if (!options.quiet) {
    for (const Event& event : events) {
      fmt::print(stderr, "{} at driver = {}: {}: {}\n", event.type, event.driver, event.item, event.cause);
    }
  }
  return all_ok ? kExitOk : kExitRows;
}

}  // namespace higherpair::cli
