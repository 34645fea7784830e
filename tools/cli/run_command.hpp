#pragma once

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/profile.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace higherpair::cli {

inline constexpr int kExitOk = 0;
inline constexpr int kExitMachine = 1;
inline constexpr int kExitInput = 2;
inline constexpr int kExitMechanism = 3;
inline constexpr int kExitRows = 4;
inline constexpr int kExitInterrupted = 130;

struct RunOptions {
  std::string profile;
  bool timed = false;   ///< step instead of analyze
  bool forces = false;  ///< forces instead of analyze
  std::optional<std::string> csv;
  std::optional<std::string> json;
  std::vector<std::string> overrides;
  std::optional<std::int64_t> samples;
  double tolerance = 1e-9;
  bool quiet = false;
  bool summary = false;
  bool jerk = false;               ///< columns of jerk behind those of the motion
  std::optional<int> derivatives;  ///< columns of the third to this derivative behind them
};

/// Prints what is wrong with the input on standard error; returns the exit code.
[[nodiscard]] int report_input(const Diagnostics& diagnostics);

/// The exit code of a mechanism that nothing drives, which is all the same for `mobility` only; says why on
/// standard error.
[[nodiscard]] std::optional<int> refuse_without_driver(const std::string& path, const Profile& profile);

/// Runs `analyze`, `step` or `forces`; returns the exit code.
[[nodiscard]] int run_command(const RunOptions& options);

}  // namespace higherpair::cli
