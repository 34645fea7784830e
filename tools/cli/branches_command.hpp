#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct BranchesOptions {
  std::string profile;
  std::optional<std::string> csv;
  std::optional<std::string> json;
  std::vector<std::string> overrides;
  double tolerance = 1e-9;
  bool quiet = false;
  bool certify = false;  ///< decide every contact in exact arithmetic
};

/// Adds the command `branches` and its options.
CLI::App* add_branches_command(CLI::App& app, BranchesOptions& options);

/// Lists every contact at the first driver position; returns the exit code.
[[nodiscard]] int branches_command(const BranchesOptions& options);

}  // namespace higherpair::cli
