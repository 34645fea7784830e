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
  int best = 1;                     ///< so many files, the further ones with a number in their names
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

/// Looks for the design that the profile asks for and writes it as a profile; returns the exit code: 4 where
/// the best found violates a constraint, 130 where the search was interrupted; the best so far is written all
/// the same. Searches that are done are kept beside a regular file until it is written, in OUTPUT.searches.
[[nodiscard]] int design_command(const DesignCommandOptions& options);

/// What was found, as readable text and as JSON.
[[nodiscard]] std::string design_text(const DesignReport& report);
[[nodiscard]] std::string design_json(const DesignReport& report);

}  // namespace higherpair::cli
