#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct DrawOptions {
  std::string profile;
  std::string output;
  std::vector<std::string> overrides;
  std::optional<double> at;
  std::optional<double> every;
  bool strip = false;
  std::vector<std::string> layers;
  std::vector<std::string> traces;
  bool linkage = false;
  std::optional<double> width;
  double tolerance = 1e-9;
  bool quiet = false;
};

/// Adds the command `draw` and its options.
CLI::App* add_draw_command(CLI::App& app, DrawOptions& options);

/// Draws the mechanism; returns the exit code: 4 if it is drawn at a limit before the position asked for.
[[nodiscard]] int draw_command(const DrawOptions& options);

}  // namespace higherpair::cli
