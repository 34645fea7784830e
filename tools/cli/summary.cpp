#include "summary.hpp"

#include "higherpair/geometry/pose.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <system_error>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

constexpr double kRounding = 1e-12;  // relative to the scale of a column
constexpr std::size_t kLine = 80;

std::string unit_of(const std::vector<Column>& columns, const std::string& name) {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.name == name; });
  return found == columns.end() ? "" : " " + found->unit;
}

// One radian in a unit of angles; 0 of any other unit.
double radian_in(std::string_view unit) {
  constexpr double kRadian = 180 / kPi;
  return unit == "deg" ? kRadian : unit == "rad" ? 1 : unit == "rev" ? kRadian / 360 : 0;
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

double Summary::largest_of(std::string_view unit) const {
  const auto& columns = analysis_.columns();
  double largest = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].unit == unit) largest = std::max(largest, ranges_[i].largest());
  }
  return largest;
}

// Velocities, accelerations and jerks are worked out from positions and the rates at which bodies turn. So a
// rounding of these is one of size times rate to the order of the derivative, also where the column itself
// and all others of its unit ought to be 0. The size is the largest length, or 1 rad.
double Summary::scale_of_rates(std::string_view unit) const {
  const auto size_of = [&](std::string_view of) {
    return radian_in(of) > 0 ? radian_in(of) : largest_of(of);
  };
  const std::size_t slash = std::min(unit.find('/'), unit.size());
  const std::size_t power = std::min(unit.find('^', slash), unit.size());
  if (slash == unit.size() || power + 2 < unit.size()) return 0;
  const int order = power == unit.size() ? 1 : unit.back() - '0';
  const std::string_view per_time = unit.substr(slash, power - slash);  // "/s"
  double fastest = 0;
  for (const Column& column : analysis_.columns()) {
    if (!column.unit.ends_with(per_time)) continue;
    const std::string_view of = std::string_view(column.unit).substr(0, column.unit.size() - per_time.size());
    if (const double size = size_of(of); size > 0)
      fastest = std::max(fastest, largest_of(column.unit) / size);
  }
  return size_of(unit.substr(0, slash)) * std::pow(fastest, order);
}

double Summary::rounded(std::size_t column, double value) const {
  const std::string& unit = analysis_.columns()[column].unit;
  return std::abs(value) <= kRounding * std::max(largest_of(unit), scale_of_rates(unit)) ? 0 : value;
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
  const auto place_of = [&](const Extreme& extreme) {
    return place_ < columns.size() ? rounded(place_, extreme.at) : extreme.at;
  };
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
    fmt::print("{:<22}{:>13.7g}{:>10.6g} {:>13.7g}{:>10.6g}  {}\n", name, rounded(i, low.value),
               place_of(low), rounded(i, high.value), place_of(high), columns[i].unit);
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
