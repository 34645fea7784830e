#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct ReportOptions {
  std::string profile;
  std::string output;
  std::vector<std::string> overrides;
  std::optional<std::int64_t> samples;
  double tolerance = 1e-9;
  bool timed = false;
  bool quiet = false;
};

CLI::App* add_report_command(CLI::App& app, ReportOptions& options);

/// Runs `report`; returns the exit code.
[[nodiscard]] int report_command(const ReportOptions& options);

}  // namespace higherpair::cli
