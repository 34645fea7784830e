#include "summary.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <system_error>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

constexpr double kRounding = 1e-12;  // relative to the largest value of the same unit
constexpr std::size_t kLine = 80;

std::string unit_of(const std::vector<Column>& columns, const std::string& name) {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.name == name; });
  return found == columns.end() ? "" : " " + found->unit;
}

// The item that a column belongs to: "cam.O" of "cam.O.vx".
std::string_view item_of(const Column& column) {
  const std::string_view name = column.name;
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : name.substr(0, dot);
}

// Prints names after a heading, as many per line as fit.
void print_list(const std::string& heading, const std::vector<std::string>& items) {
  if (items.empty()) {
    return;
  }
  std::string line = heading;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string item = items[i] + (i + 1 < items.size() ? "," : "");
    if (line.size() + 1 + item.size() > kLine) {
      fmt::print("{}\n", line);
      line.assign(1, ' ');
    }
    line += " " + item;
  }
  fmt::print("{}\n", line);
}

// Prints the smallest contact forces, and up to which speed all contacts stay closed.
void print_contacts(const Analysis& analysis) {
  for (const auto& [contact, force, driver] : analysis.smallest_forces()) {
    fmt::print("smallest force of {}: {:.7g}{} at driver = {:.10g}{}\n", contact, force,
               unit_of(analysis.columns(), contact + ".force"), driver,
               unit_of(analysis.columns(), "driver"));
  }
  const auto speed = analysis.highest_speed();
  if (speed && *speed > 0 && std::isfinite(*speed)) {
    fmt::print("contacts stay closed up to {:.6g} times the speed of the drivers\n",
               std::floor(*speed * 1e5) / 1e5);
  }
}

}  // namespace

double Summary::Range::largest() const {
  return is_defined() ? std::max(std::abs(low.value), std::abs(high.value)) : 0;
}

Summary::Summary(const Analysis& analysis) : analysis_(analysis), ranges_(analysis.columns().size()) {
  const auto& columns = analysis.columns();
  place_ = columns.size();
  for (const char* wanted : {"driver", "time"}) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].name == wanted) place_ = i;
    }
  }
}

void Summary::add(const RowBlock& block) {
  for (std::size_t row = 0; row < block.size(); ++row) {
    const auto values = block.row(row);
    const std::int64_t number = block.first + static_cast<std::int64_t>(row);
    const double at = place_ < values.size() ? values[place_] : static_cast<double>(number);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double value = values[i];  // undefined (NaN) changes nothing
      if (value < ranges_[i].low.value) ranges_[i].low = {value, at};
      if (value > ranges_[i].high.value) ranges_[i].high = {value, at};
    }
    ++statuses_[name_of(block.statuses[row])];
  }
}

double Summary::rounded(std::size_t column, double value) const {
  const auto& columns = analysis_.columns();
  double largest = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].unit == columns[column].unit) largest = std::max(largest, ranges_[i].largest());
  }
  return std::abs(value) <= kRounding * largest ? 0 : value;
}

bool Summary::is_constant(std::size_t column) const {
  const Range& range = ranges_[column];
  const double change = range.high.value - range.low.value;
  return change <= kRounding * range.largest() || rounded(column, change) == 0;
}

void Summary::print_ranges() const {
  const auto& columns = analysis_.columns();
  const std::string place = place_ < columns.size() ? columns[place_].name : "row";
  fmt::print("{:<22}{:>13}{:>10} {:>13}{:>10}  unit\n", "", "smallest", "at " + place, "largest",
             "at " + place);
  std::string_view item;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!columns[i].words.empty() || !ranges_[i].is_defined() || is_constant(i) ||
        columns[i].name == "residual") {
      continue;
    }
    const std::string_view about = item_of(columns[i]);
    if (about != item) {
      fmt::print("{}\n", about);
      item = about;
    }
    const std::string name =
        about.empty() ? columns[i].name : "  " + columns[i].name.substr(about.size() + 1);
    const auto& [low, high] = ranges_[i];
    fmt::print("{:<22}{:>13.7g}{:>10.6g} {:>13.7g}{:>10.6g}  {}\n", name, rounded(i, low.value), low.at,
               rounded(i, high.value), high.at, columns[i].unit);
  }
}

void Summary::print_constants() const {
  const auto& columns = analysis_.columns();
  std::vector<std::string> constants;
  std::int64_t zeros = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!columns[i].words.empty() || !ranges_[i].is_defined() || !is_constant(i)) {
      continue;
    }
    const double value = rounded(i, ranges_[i].high.value);
    if (value == 0) {
      ++zeros;
    } else {
      constants.push_back(fmt::format("{} {:.7g} {}", columns[i].name, value, columns[i].unit));
    }
  }
  fmt::print("\n");
  print_list("constant:", constants);
  if (zeros > 0) {
    fmt::print("always 0: {} columns\n", zeros);
  }
}

void Summary::print_path() const {
  fmt::print("rows:");
  for (const auto& [status, count] : statuses_) {
    fmt::print(" {} {}", count, status);
  }
  std::map<std::string_view, int> events;
  for (const Event& event : analysis_.events()) {
    ++events[name_of(event.type)];
  }
  fmt::print("\npath: {}", analysis_.good() ? "ok" : "not ok");
  for (const auto& [type, count] : events) {
    fmt::print(", {} {}", count, type);
  }
  fmt::print("\n");
  const auto& columns = analysis_.columns();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].name == "residual" && ranges_[i].is_defined()) {
      fmt::print("largest residual: {:.2g} {}\n", ranges_[i].high.value, columns[i].unit);
    }
  }
}

void Summary::print(const std::string& title) const {
  fmt::print("{}\n\n", title);
  print_ranges();
  print_constants();
  print_path();
  print_contacts(analysis_);
  // Events follow on standard error.
  if (std::fflush(stdout) != 0) {
    throw std::system_error(errno, std::generic_category());  // as fmt::print throws
  }
}

}  // namespace higherpair::cli
