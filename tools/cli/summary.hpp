#pragma once

#include "higherpair/io/motion_table.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace higherpair::cli {

/// Smallest and largest value of every column, and how many rows have which status.
class Summary {
public:
  /// \param status  the column that holds the status of a row
  explicit Summary(std::size_t status) : status_(status) {}

  void add(const std::vector<Cell>& cells);

  /// Prints them on standard output.
  void print(const std::string& title, const std::vector<Column>& columns) const;

private:
  struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
  };

  std::size_t status_;
  std::vector<Range> ranges_;
  std::map<std::string, std::int64_t> statuses_;
};

}  // namespace higherpair::cli
