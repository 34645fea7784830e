#pragma once

#include "higherpair/front/motion.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::cli {

/// An overview of a run: smallest and largest value of every column that changes, and where they occur;
/// columns that are constant; the number of rows of each status; whether the whole path is good.
class Summary {
public:
  explicit Summary(const Analysis& analysis);

  void add(const RowBlock& block);

  /// Prints the overview on standard output, with at most 80 characters per line.
  void print(const std::string& title) const;

private:
  struct Extreme {
    double value;
    double at = 0;  ///< driver position, time or row number
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
  /// The value, or 0 if it is 0 to within rounding.
  [[nodiscard]] double rounded(std::size_t column, double value) const;
  [[nodiscard]] double largest_of(std::string_view unit) const;
  [[nodiscard]] double scale_of_rates(std::string_view unit) const;

  const Analysis& analysis_;
  std::size_t place_;  ///< column of the row's position; none: the number of columns
  std::vector<Range> ranges_;
  std::map<std::string_view, std::int64_t> statuses_;
};

}  // namespace higherpair::cli
