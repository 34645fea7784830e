#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct MobilityOptions {
  std::string profile;
  std::optional<std::string> csv;
  std::optional<std::string> json;
  std::vector<std::string> overrides;
  double tolerance = 1e-9;
  bool quiet = false;
};

/// Adds the command `mobility` and its options.
CLI::App* add_mobility_command(CLI::App& app, MobilityOptions& options);

/// Runs `mobility`; returns the exit code: 3 if the drivers do not fit the mechanism or it cannot be started;
/// the findings obtained are printed all the same.
[[nodiscard]] int mobility_command(const MobilityOptions& options);

}  // namespace higherpair::cli
