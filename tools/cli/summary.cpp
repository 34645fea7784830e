#include "summary.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

namespace higherpair::cli {

void Summary::add(const std::vector<Cell>& cells) {
  ranges_.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (const auto* number = std::get_if<double>(&cells[i])) {
      ranges_[i].low = std::min(ranges_[i].low, *number);
      ranges_[i].high = std::max(ranges_[i].high, *number);
    }
  }
  ++statuses_[std::string(std::get<std::string_view>(cells[status_]))];
}

void Summary::print(const std::string& title, const std::vector<Column>& columns) const {
  fmt::print("{}\n\n{:<28}{:>16}{:>16}  unit\n", title, "column", "smallest", "largest");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].unit.empty() || ranges_[i].low > ranges_[i].high) {
      continue;
    }
    fmt::print("{:<28}{:>16.7g}{:>16.7g}  {}\n", columns[i].name, ranges_[i].low, ranges_[i].high,
               columns[i].unit);
  }
  fmt::print("\nrows:");
  for (const auto& [status, count] : statuses_) {
    fmt::print(" {} {}", count, status);
  }
  fmt::print("\n");
  // Events follow on standard error.
  std::fflush(stdout);
}

}  // namespace higherpair::cli
