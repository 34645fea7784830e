#pragma once

#include <cstdint>
#include <cstdio>
#include <ctime>
#include <unistd.h>

#include <fmt/core.h>

namespace higherpair::cli {

/// The percentage done, on standard error if that is a terminal, once a run has taken a second.
class Progress {
public:
  explicit Progress(bool wanted) : wanted_(wanted && isatty(STDERR_FILENO) == 1), start_(std::clock()) {}
  ~Progress() {
    if (shown_) {
      fmt::print(stderr, "\r    \r");
    }
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void at(std::int64_t row, std::int64_t size) {
    if (!wanted_ || row % 4096 != 0 || std::clock() - start_ < CLOCKS_PER_SEC) {
      return;
    }
    shown_ = true;
    fmt::print(stderr, "\r{:3}%", 100 * row / size);
    std::fflush(stderr);
  }

private:
  bool wanted_;
  bool shown_ = false;
  std::clock_t start_;
};

}  // namespace higherpair::cli
