#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct CheckOptions {
  std::string profile;
  std::optional<std::string> csv;
  std::optional<std::string> json;
  std::vector<std::string> overrides;
  double tolerance = 1e-9;
  bool timed = false;  ///< the motion in time, as in `step`
  bool quiet = false;
};

/// Adds the command `check` and its options.
CLI::App* add_check_command(CLI::App& app, CheckOptions& options);

/// Runs `check`; returns the exit code: 4 if a limit is exceeded or the path is not good.
[[nodiscard]] int check_command(const CheckOptions& options);

}  // namespace higherpair::cli
