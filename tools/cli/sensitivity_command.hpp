#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct SensitivityOptions {
  std::string profile;
  std::optional<std::string> csv;
  std::optional<std::string> json;
  std::optional<std::string> rows;  ///< file for the derivatives of columns, row by row
  std::vector<std::string> overrides;
  std::vector<std::string> results;  ///< COLUMN:OF
  std::vector<std::string> by;       ///< globs of paths
  std::vector<std::string> columns;  ///< of `rows`; empty: those of the results
  std::optional<std::int64_t> samples;
  std::optional<std::int64_t> variants;
  std::optional<std::uint64_t> seed;
  double tolerance = 1e-9;
  std::size_t top = 10;
  int threads = 0;
  bool timed = false;
  bool quiet = false;
};

/// Adds the command `sensitivity` and its options.
CLI::App* add_sensitivity_command(CLI::App& app, SensitivityOptions& options);

/// Runs `sensitivity`; returns the exit code: 4 if the path is not good, or a band is wider than wanted.
[[nodiscard]] int sensitivity_command(const SensitivityOptions& options);

}  // namespace higherpair::cli
