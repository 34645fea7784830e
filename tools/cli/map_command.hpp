#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct MapOptions {
  std::string profile;
  std::optional<std::string> csv;
  std::optional<std::string> json;
  std::optional<std::string> output;  ///< path of the picture
  std::vector<std::string> overrides;
  std::optional<std::int64_t> samples;
  double tolerance = 1e-9;
  bool quiet = false;
};

/// Adds the command `map` and its options.
CLI::App* add_map_command(CLI::App& app, MapOptions& options);

/// Maps all contacts of every pair over its driver's turn; returns the exit code: 3 if no contact has a map,
/// 4 if one is incomplete.
[[nodiscard]] int map_command(const MapOptions& options);

}  // namespace higherpair::cli
