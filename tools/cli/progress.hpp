#pragma once

#include "status_line.hpp"

#include <cstdint>

#include <fmt/core.h>

namespace higherpair::cli {

/// The percentage of the rows done, once a run has taken a second.
class Progress {
public:
  explicit Progress(bool wanted) : line_(wanted) {}

  void at(std::int64_t row, std::int64_t size) {
    if (row % 4096 == 0 && line_.is_due() && line_.seconds() >= 1) {
      line_.show(fmt::format("{:3}%", 100 * row / size));
    }
  }

private:
  StatusLine line_;
};

}  // namespace higherpair::cli
