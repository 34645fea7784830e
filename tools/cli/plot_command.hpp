#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct PlotOptions {
  std::string profile;
  std::string output;
  std::vector<std::string> y;
  std::optional<std::string> x;
  std::vector<std::string> overrides;
  std::optional<std::int64_t> samples;
  double tolerance = 1e-9;
  double width = 720;
  bool timed = false;  ///< the motion in time, as in `step`
  bool quiet = false;
};

/// Adds the command `plot` and its options.
CLI::App* add_plot_command(CLI::App& app, PlotOptions& options);

/// Plots columns of a run; returns the exit code: 4 if its path is not good.
[[nodiscard]] int plot_command(const PlotOptions& options);

}  // namespace higherpair::cli
