#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct ExportOptions {
  std::string profile;
  std::string output;
  std::vector<std::string> overrides;
  std::vector<std::string> curves;
  std::string body;
  bool pitch = false;
  /// Lengths as given: numbers in the profile's unit, or with a unit of their own.
  std::optional<std::string> cutter;
  std::optional<std::string> reach;
  std::optional<std::string> tolerance;
  std::optional<int> points;
  std::optional<std::string> units;
  bool quiet = false;
};

/// Adds the command `export` and its options.
CLI::App* add_export_command(CLI::App& app, ExportOptions& options);

/// Writes curves of a profile as CSV, DXF or SVG; returns the exit code.
[[nodiscard]] int export_command(const ExportOptions& options);

}  // namespace higherpair::cli
