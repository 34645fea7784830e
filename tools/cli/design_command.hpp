#pragma once

#include "higherpair/front/design.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct DesignCommandOptions {
  std::string profile;
  std::string output;  ///< the new profile
  std::optional<std::string> json;
  std::optional<std::string> page;  ///< --report
  int best = 1;                     ///< profiles written; the further ones are numbered in their names
  std::optional<std::uint64_t> seed;
  std::optional<double> seconds;
  std::optional<std::int64_t> evaluations;
  std::optional<int> starts;
  int threads = 0;
  bool resume = false;
  bool quiet = false;
};

/// Adds the command `design` and its options.
CLI::App* add_design_command(CLI::App& app, DesignCommandOptions& options);

/// Searches for the design that the profile asks for and writes it as a profile; returns the exit code: 4 if
/// the best design found violates a constraint, 130 if the search was interrupted; the best so far is written
/// all the same. If the output is a regular file, finished searches are kept in OUTPUT.searches until it is
/// written.
[[nodiscard]] int design_command(const DesignCommandOptions& options);

/// The results as readable text and as JSON.
[[nodiscard]] std::string design_text(const DesignReport& report);
[[nodiscard]] std::string design_json(const DesignReport& report);

}  // namespace higherpair::cli
