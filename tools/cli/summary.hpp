#pragma once

#include "higherpair/front/motion.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::cli {

/// What a reader wants of a run first: of every column that changes the smallest and the largest value and
/// where they are, what is constant, how many rows have which status, and whether the whole path is good.
class Summary {
public:
  explicit Summary(const Analysis& analysis);

  void add(const RowBlock& block);

  /// Prints them on standard output, at most 80 characters to a line.
  void print(const std::string& title) const;

private:
  struct Extreme {
    double value;
    double at = 0;  ///< driver, time or number of the row
  };
  struct Range {
    Extreme low{std::numeric_limits<double>::infinity()};
    Extreme high{-std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool is_defined() const { return low.value <= high.value; }
    [[nodiscard]] double largest() const;
  };

  void print_ranges() const;
  void print_constants() const;
  void print_path() const;
  [[nodiscard]] bool is_constant(std::size_t column) const;
  /// Without what rounding leaves of zero.
  [[nodiscard]] double rounded(std::size_t column, double value) const;

  const Analysis& analysis_;
  std::size_t place_;  ///< column that says where a row is; none: the number of columns
  std::vector<Range> ranges_;
  std::map<std::string_view, std::int64_t> statuses_;
};

}  // namespace higherpair::cli
