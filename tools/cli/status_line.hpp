#pragma once

#include <cstdio>
#include <string>
#include <unistd.h>

#include <fmt/core.h>

namespace higherpair::cli {

/// A line on standard error, if that is a terminal, with the progress of a search; erased at the end.
class StatusLine {
public:
  explicit StatusLine(bool wanted) : wanted_(wanted && isatty(STDERR_FILENO) == 1) {}
  ~StatusLine() {
    if (shown_) fmt::print(stderr, "\r\033[K");
  }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  void show(const std::string& text) {
    if (!wanted_) return;
    shown_ = true;
    fmt::print(stderr, "\r\033[K{}", text);
    std::fflush(stderr);
  }

private:
  bool wanted_;
  bool shown_ = false;
};

}  // namespace higherpair::cli
