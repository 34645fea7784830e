#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct VerifyOptions {
  std::optional<std::string>
      profile;  ///< with `table`: checks this pair of files instead of the shipped ones
  std::optional<std::string> table;
  std::optional<std::string> json;
  double bound = 1e-11;  ///< largest error of a column, relative to its largest value
  bool quiet = false;
};

/// Adds the command `verify` and its options.
CLI::App* add_verify_command(CLI::App& app, VerifyOptions& options);

/// Runs `verify`; returns the exit code: 4 if a reference does not hold.
[[nodiscard]] int verify_command(const VerifyOptions& options);

}  // namespace higherpair::cli
