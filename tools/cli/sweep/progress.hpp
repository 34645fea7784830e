#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <unistd.h>

#include <fmt/core.h>

namespace higherpair::cli {

/// "3 h 20 min", "2 min 5 s", "40 s".
[[nodiscard]] inline std::string duration_text(double seconds) {
  const auto whole = std::llround(seconds);
  if (whole >= 86400) return fmt::format("{} d {} h", whole / 86400, whole % 86400 / 3600);
  if (whole >= 3600) return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
  if (whole >= 60) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} s", whole);
}

/// The share done, the rate and the remaining time, on standard error if that is a terminal.
class SweepProgress {
public:
  /// \param done  variants that were done before
  SweepProgress(std::int64_t done, std::int64_t size, bool wanted)
      : wanted_(wanted && isatty(STDERR_FILENO) == 1), before_(done), size_(size), start_(Clock::now()) {}
  ~SweepProgress() { clear(); }
  SweepProgress(const SweepProgress&) = delete;
  SweepProgress& operator=(const SweepProgress&) = delete;

  void at(std::int64_t done) {
    const auto now = Clock::now();
    if (!wanted_ || now - shown_ < std::chrono::milliseconds(500)) {
      return;
    }
    shown_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double rate = static_cast<double>(done - before_) / seconds;
    const std::string text =
        fmt::format("{:3} %  {:.0f} variants/s  {} left",
                    static_cast<int>(100.0 * static_cast<double>(done) / static_cast<double>(size_)), rate,
                    duration_text(static_cast<double>(size_ - done) / rate));
    fmt::print(stderr, "\r{:<{}}", text, length_);
    std::fflush(stderr);
    length_ = text.size();
  }

  void clear() {
    if (length_ > 0) fmt::print(stderr, "\r{:{}}\r", "", length_);
    length_ = 0;
  }

private:
  using Clock = std::chrono::steady_clock;

  bool wanted_;
  std::int64_t before_;
  std::int64_t size_;
  Clock::time_point start_;
  Clock::time_point shown_ = start_;
  std::size_t length_ = 0;
};

}  // namespace higherpair::cli
