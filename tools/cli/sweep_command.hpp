#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct SweepOptions {
  std::string profile;
  std::string output = "-";
  std::vector<std::string> overrides;
  std::optional<std::int64_t> samples;
  double tolerance = 1e-9;
  int threads = 0;  ///< 0: as many as there are cores
  bool resume = false;
  std::string part = "1/1";  ///< K/N
  bool quiet = false;
};

/// Adds `sweep` to the program.
[[nodiscard]] CLI::App* add_sweep_command(CLI::App& app, SweepOptions& options);

/// Runs it; returns the exit code.
[[nodiscard]] int sweep_command(const SweepOptions& options);

}  // namespace higherpair::cli
