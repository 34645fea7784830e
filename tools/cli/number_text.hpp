#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/core.h>

namespace higherpair::cli {

/// A number for people.
[[nodiscard]] inline std::string shown(double value, int digits = 9) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "-";
}

/// A field of CSV with all digits; empty if the value is undefined.
[[nodiscard]] inline std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", value == 0 ? 0.0 : value) : "";
}
[[nodiscard]] inline std::string cell(const std::optional<double>& value) {
  return value ? cell(*value) : "";
}

/// The width of a column: of its head, or of the longest of its texts, a member of each line.
template <class Lines, class Line>
[[nodiscard]] int widest(std::string_view head, const Lines& lines, std::string Line::*text) {
  std::size_t width = head.size();
  for (const Line& line : lines) width = std::max(width, (line.*text).size());
  return static_cast<int>(width);
}

/// The title of a column in a table.
[[nodiscard]] inline std::string title(const std::string& name, const std::string& unit) {
  return name + " [" + unit + "]";
}

}  // namespace higherpair::cli
