#include "verify/reference.hpp"

#include "higherpair/analysis/run.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/motion_table.hpp"
#include "higherpair/io/profile_reader.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <tl/expected.hpp>

namespace higherpair::cli {
namespace {

template <class T>
using Or = tl::expected<T, std::string>;

struct Expected {
  std::vector<std::string> head;
  std::vector<std::vector<double>> rows;
};

std::string_view cut(std::string_view& text, char at) {
  const std::size_t end = std::min(text.find(at), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

Or<Expected> read_table(std::string_view text) {
  Expected table;
  for (std::string_view head = cut(text, '\n'); !head.empty();) {
    table.head.emplace_back(cut(head, ','));
  }
  while (!text.empty()) {
    std::string_view line = cut(text, '\n');
    std::vector<double>& row = table.rows.emplace_back();
    while (!line.empty()) {
      const std::string_view word = cut(line, ',');
      const char* end = word.data() + word.size();
      if (std::from_chars(word.data(), end, row.emplace_back()).ptr != end || word.empty()) {
        return tl::unexpected(fmt::format("table row {}: '{}' is no number", table.rows.size(), word));
      }
    }
    if (row.size() != table.head.size()) {
      return tl::unexpected(fmt::format("table row {}: {} numbers, but {} columns", table.rows.size(),
                                        row.size(), table.head.size()));
    }
  }
  if (table.head.size() < 2 || table.rows.empty()) {
    return tl::unexpected(std::string("the table needs a head with two columns or more, and a row"));
  }
  return table;
}

std::string head_of(const Column& column) {
  return column.unit.empty() ? column.name : column.name + "[" + column.unit + "]";
}

// Where the expected columns stand among those of the run.
Or<std::vector<std::size_t>> match(const Expected& expected, const std::vector<Column>& columns) {
  std::vector<std::size_t> places;
  for (const std::string& head : expected.head) {
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return head_of(c) == head; });
    if (found == columns.end()) {
      return tl::unexpected(fmt::format("there is no column {}", head));
    }
    places.push_back(static_cast<std::size_t>(found - columns.begin()));
  }
  return places;
}

std::string first_of(const Diagnostics& diagnostics) {
  return diagnostics.empty() ? "not readable" : to_string(diagnostics.front());
}

// The rows of the run, one after the other.
class Rows {
public:
  static Or<Rows> start(const Profile& profile, bool timed) {
    auto schedule = timed ? DriverSchedule::step(profile) : DriverSchedule::analyze(profile);
    if (!schedule) {
      return tl::unexpected(first_of(schedule.error()));
    }
    auto table = MotionTable::make(profile, timed);
    if (!table) {
      return tl::unexpected(table.error());
    }
    Rows rows(*std::move(schedule), *std::move(table));
    rows.read(0);
    std::vector<double> first;
    for (const DriverMotion& motion : rows.motions_) {
      first.push_back(motion.position);
    }
    auto run = start_run(profile.mechanism, first);
    if (!run) {
      return tl::unexpected(run.error().reason);
    }
    rows.run_.emplace(*std::move(run));
    return rows;
  }

  [[nodiscard]] std::int64_t size() const { return schedule_.size(); }
  [[nodiscard]] const std::vector<Column>& columns() const { return table_.columns(); }

  Or<std::vector<double>> row(std::int64_t k, const std::vector<std::size_t>& places) {
    read(k);
    move_to(*run_, motions_);
    if (run_->row.status != RowStatus::kOk) {
      return tl::unexpected(fmt::format("row {} is {}", k + 1, name_of(run_->row.status)));
    }
    const auto& cells = table_.cells(run_->row, states_, schedule_.is_timed() ? schedule_.time(k) : 0);
    std::vector<double> numbers;
    for (const std::size_t place : places) {
      const double* number = std::get_if<double>(&cells[place]);
      if (number == nullptr) {
        return tl::unexpected(fmt::format("row {}: {} is no number", k + 1, head_of(columns()[place])));
      }
      numbers.push_back(*number);
    }
    return numbers;
  }

private:
  Rows(DriverSchedule schedule, MotionTable table)
      : schedule_(std::move(schedule)), table_(std::move(table)) {}

  void read(std::int64_t k) {
    states_.clear();
    motions_.clear();
    for (std::size_t i = 0; i < schedule_.driver_count(); ++i) {
      states_.push_back(schedule_.state(k, i));
      motions_.push_back({states_[i].si.position, states_[i].si.velocity, states_[i].si.acceleration});
    }
  }

  DriverSchedule schedule_;
  MotionTable table_;
  std::optional<Run> run_;
  std::vector<DriverState> states_;
  std::vector<DriverMotion> motions_;
};

std::vector<double> scales(const Expected& expected) {
  std::vector<double> scale(expected.head.size(), 0);
  for (const auto& row : expected.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      scale[i] = std::max(scale[i], std::abs(row[i]));
    }
  }
  std::replace(scale.begin(), scale.end(), 0.0, 1.0);
  return scale;
}

Or<std::vector<ColumnCheck>> compare(const Expected& expected, Rows& rows) {
  const auto places = match(expected, rows.columns());
  if (!places) {
    return tl::unexpected(places.error());
  }
  if (rows.size() != static_cast<std::int64_t>(expected.rows.size())) {
    return tl::unexpected(fmt::format("{} rows, expected {}", rows.size(), expected.rows.size()));
  }
  const std::vector<double> scale = scales(expected);
  std::vector<ColumnCheck> checks(expected.head.size());
  for (std::size_t k = 0; k < expected.rows.size(); ++k) {
    const auto row = rows.row(static_cast<std::int64_t>(k), *places);
    if (!row) {
      return tl::unexpected(row.error());
    }
    for (std::size_t i = 0; i < checks.size(); ++i) {
      const double error = std::abs((*row)[i] - expected.rows[k][i]) / scale[i];
      if (k == 0 || !(error <= checks[i].error)) {
        checks[i] = {expected.head[i], (*row)[0], (*row)[i], expected.rows[k][i], error};
      }
    }
  }
  return checks;
}

Or<std::vector<ColumnCheck>> compare(const Profile& profile, std::string_view table) {
  const auto expected = read_table(table);
  if (!expected) {
    return tl::unexpected(expected.error());
  }
  auto rows = Rows::start(profile, expected->head.front().starts_with("time["));
  if (!rows) {
    return tl::unexpected(rows.error());
  }
  return compare(*expected, *rows);
}

}  // namespace

const ColumnCheck& Verdict::worst() const {
  return *std::max_element(columns.begin(), columns.end(),
                           [](const auto& a, const auto& b) { return a.error < b.error; });
}

bool Verdict::holds(double bound) const {
  return failure.empty() && !columns.empty() &&
         std::all_of(columns.begin(), columns.end(), [&](const auto& c) { return c.error <= bound; });
}

Verdict verify(const Reference& reference) {
  Verdict verdict;
  const auto start = std::chrono::steady_clock::now();
  const auto profile = read_profile_text(reference.profile, std::string(reference.name));
  if (!profile) {
    verdict.title = reference.name;
    verdict.failure = first_of(profile.error());
    return verdict;
  }
  verdict.title = profile->mechanism.title.empty() ? reference.name : profile->mechanism.title;
  verdict.source = profile->mechanism.description;
  auto columns = compare(*profile, reference.table);
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!columns) {
    verdict.failure = columns.error();
    return verdict;
  }
  verdict.columns = *std::move(columns);
  return verdict;
}

}  // namespace higherpair::cli
