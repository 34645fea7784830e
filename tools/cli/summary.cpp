#include "summary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

namespace higherpair::cli {

namespace {

std::string unit_of(const std::vector<Column>& columns, const std::string& name) {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.name == name; });
  return found == columns.end() ? "" : " " + found->unit;
}

// The smallest contact forces, and the speed at which the first contact opens.
void print_contacts(const Analysis& analysis) {
  for (const auto& [contact, force, driver] : analysis.smallest_forces()) {
    fmt::print("smallest force of {}: {:.7g}{} at driver = {:.10g}{}\n", contact, force,
               unit_of(analysis.columns(), contact + ".force"), driver,
               unit_of(analysis.columns(), "driver"));
  }
  const auto speed = analysis.highest_speed();
  if (speed && std::isfinite(*speed)) {
    fmt::print("contacts stay closed up to {:.6g} times the speed of the drivers\n",
               std::floor(*speed * 1e5) / 1e5);
  }
}

}  // namespace

void Summary::add(const Row& row) {
  ranges_.resize(row.values.size());
  for (std::size_t i = 0; i < row.values.size(); ++i) {
    // NaN, which is undefined, changes neither.
    ranges_[i].low = std::min(ranges_[i].low, row.values[i]);
    ranges_[i].high = std::max(ranges_[i].high, row.values[i]);
  }
  ++statuses_[name_of(row.status)];
}

void Summary::print(const std::string& title, const Analysis& analysis) const {
  const std::vector<Column>& columns = analysis.columns();
  fmt::print("{}\n\n{:<28}{:>16}{:>16}  unit\n", title, "column", "smallest", "largest");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!columns[i].words.empty() || ranges_[i].low > ranges_[i].high) {
      continue;
    }
    fmt::print("{:<28}{:>16.7g}{:>16.7g}  {}\n", columns[i].name, ranges_[i].low, ranges_[i].high,
               columns[i].unit);
  }
  fmt::print("\nrows:");
  for (const auto& [status, count] : statuses_) {
    fmt::print(" {} {}", count, status);
  }
  std::map<std::string_view, int> events;
  for (const Event& event : analysis.events()) {
    ++events[name_of(event.type)];
  }
  fmt::print("\npath: {}", analysis.good() ? "ok" : "not ok");
  for (const auto& [type, count] : events) {
    fmt::print(", {} {}", count, type);
  }
  fmt::print("\n");
  print_contacts(analysis);
  // Events follow on standard error.
  std::fflush(stdout);
}

}  // namespace higherpair::cli
