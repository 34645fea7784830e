#pragma once

#include "higherpair/front/motion.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::cli {

/// Smallest and largest value of every column, how many rows have which status, and whether the whole path is
/// good.
class Summary {
public:
  void add(const Row& row);

  /// Prints them on standard output.
  void print(const std::string& title, const Analysis& analysis) const;

private:
  struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
  };

  std::vector<Range> ranges_;
  std::map<std::string_view, std::int64_t> statuses_;
};

}  // namespace higherpair::cli
