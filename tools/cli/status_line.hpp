#pragma once

#include "tell.hpp"

#include <chrono>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace higherpair::cli {

/// A line on standard error, if that is a terminal, with the progress of the work; erased at the end.
class StatusLine {
public:
  explicit StatusLine(bool wanted)
      : wanted_(wanted && isatty(STDERR_FILENO) == 1), start_(Clock::now()), shown_at_(start_) {}
  ~StatusLine() { clear(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// Whether it is worth making a text: there is a line, and the last one is at least half a second old.
  [[nodiscard]] bool is_due() const {
    return wanted_ && Clock::now() - shown_at_ >= std::chrono::milliseconds(500);
  }
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

  void show(const std::string& text) {
    if (!wanted_) return;
    shown_ = true;
    shown_at_ = Clock::now();
    tell("\r\033[K{}", text);
    std::fflush(stderr);
  }

  void clear() {
    if (shown_) tell("\r\033[K");
    shown_ = false;
  }

private:
  using Clock = std::chrono::steady_clock;

  bool wanted_;
  bool shown_ = false;
  Clock::time_point start_, shown_at_;
};

}  // namespace higherpair::cli
