#pragma once

#include "status_line.hpp"

#include <cmath>
#include <cstdint>
#include <string>

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

/// The share done, the rate and the remaining time.
class SweepProgress {
public:
  /// \param done  variants that were done before
  SweepProgress(std::int64_t done, std::int64_t size, bool wanted)
      : line_(wanted), before_(done), size_(size) {}

  void at(std::int64_t done) {
    if (!line_.is_due()) return;
    const double rate = static_cast<double>(done - before_) / line_.seconds();
    line_.show(fmt::format("{:3} %  {:.0f} variants/s  {} left",
                           static_cast<int>(100.0 * static_cast<double>(done) / static_cast<double>(size_)),
                           rate, duration_text(static_cast<double>(size_ - done) / rate)));
  }

  void clear() { line_.clear(); }

private:
  StatusLine line_;
  std::int64_t before_;
  std::int64_t size_;
};

}  // namespace higherpair::cli
