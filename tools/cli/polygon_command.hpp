#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct PolygonOptions {
  std::string profile;
  std::string output;
  std::vector<std::string> overrides;
  double at = 0;
  double tolerance = 1e-9;
  double width = 860;
  bool forces = false;
  bool quiet = false;
};

/// Adds the command `polygon` and its options.
CLI::App* add_polygon_command(CLI::App& app, PolygonOptions& options);

/// Draws the polygons of one position; returns the exit code: 4 if that cannot be reached and they are drawn
/// at the limit before it.
[[nodiscard]] int polygon_command(const PolygonOptions& options);

}  // namespace higherpair::cli
