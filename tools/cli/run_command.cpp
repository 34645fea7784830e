#include "run_command.hpp"

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

// Smallest and largest value of every column, and how many rows have which status.
struct Summary {
  struct Range {
    double low = INFINITY;
    double high = -INFINITY;
  };
  std::vector<Range> ranges;
  std::map<std::string, std::int64_t> statuses;

  void add(const std::vector<Cell>& cells, RowStatus status) {
    ranges.resize(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (const auto* number = std::get_if<double>(&cells[i])) {
        ranges[i].low = std::min(ranges[i].low, *number);
        ranges[i].high = std::max(ranges[i].high, *number);
      }
    }
    ++statuses[std::string(name_of(status))];
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

Event limit_event(const LimitEvent& limit, const Profile& profile, const Plan& plan) {
  const Dimension dimension = plan.driver.freedom.turns ? dimension::kAngle : dimension::kLength;
  const std::size_t contact = static_cast<std::size_t>(plan.group->contact);
  return {"limit_position", from_si(dimension, profile.units).apply(limit.driver), std::nullopt,
          profile.mechanism.contacts[contact].name,
          "the two bodies cannot be kept in contact on this branch beyond this position of the driver"};
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

int report_slip(const Slip& slip, const RunOptions& options, const Profile& profile, const Run& run) {
  const Dimension dimension = run.plan.driver.freedom.turns ? dimension::kAngle : dimension::kLength;
  fmt::print(
      stderr,
      "{}: contacts.{}: this pair cannot roll through the whole run: at driver = {} {} it slips by {} {} a "
      "unit of the driver; set rolling = false\n",
      options.profile, profile.mechanism.contacts[static_cast<std::size_t>(run.plan.group->contact)].name,
      from_si(dimension, profile.units).apply(slip.driver), unit_text(dimension, profile.units),
      from_si(dimension::kLength / dimension, profile.units).apply(slip.velocity),
      unit_text(dimension::kLength / dimension, profile.units));
  return kExitMechanism;
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
  auto run = start_run(profile->mechanism, schedule->state(0).si.position, options.tolerance);
  if (!run) {
    fmt::print(stderr, "{}: {}\n", options.profile, run.error());
    return kExitMechanism;
  }
  if (const auto slip = find_slip(*run, some_positions(*schedule))) {
    return report_slip(*slip, options, *profile, *run);
  }
  auto table = MotionTable::make(*profile, run->plan, options.timed);
  if (!table) {
    return report_input({about(options.profile, table.error())});
  }

  std::signal(SIGINT, on_interrupt);
  std::vector<RowWriter> writers = open_outputs(options);
  if (failed(writers)) {
    return kExitMachine;
  }
  for (RowWriter& writer : writers) {
    writer.begin(profile->mechanism.title, table->columns());
  }
  Summary summary;
  std::vector<Event> events;
  bool all_ok = true;
  Progress progress(!options.quiet);
  for (std::int64_t k = 0; k < schedule->size(); ++k) {
    if (interrupted != 0) {
      return kExitInterrupted;
    }
    const DriverState driver = schedule->state(k);
    const RunStep step = move_to(*run, driver.si.position, driver.si.velocity, driver.si.acceleration);
    if (step.limit) {
      events.push_back(limit_event(*step.limit, *profile, run->plan));
    }
    all_ok = all_ok && step.row.status == RowStatus::kOk;
    const auto& cells = table->cells(*run, step.row, driver, options.timed ? schedule->time(k) : 0);
    for (RowWriter& writer : writers) {
      writer.row(cells);
    }
    if (options.summary) {
      summary.add(cells, step.row.status);
    }
    if (k % 4096 == 0 && failed(writers)) {
      return kExitMachine;
    }
    progress.at(k, schedule->size());
  }
  for (RowWriter& writer : writers) {
    writer.end(events);
  }
  if (failed(writers)) {
    return kExitMachine;
  }
  if (options.summary) {
    summary.print(profile->mechanism.title, table->columns());
  }
  if (!options.quiet) {
    for (const Event& event : events) {
      fmt::print(stderr, "{} at driver = {}: {}: {}\n", event.type, event.driver, event.item, event.cause);
    }
  }
  return all_ok ? kExitOk : kExitRows;
}

}  // namespace higherpair::cli
