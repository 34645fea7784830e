#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace higherpair::cli {

/// What an option writes, and where to.
struct Output {
  std::string what;
  std::optional<std::string>& path;
};

/// Adds --csv and --json to a command. Both into one file, or both to standard output, are refused.
void add_output_options(CLI::App& command, const Output& csv, const Output& json);

/// Adds --samples to a command that looks at one position only, as all commands take it.
void add_unused_samples(CLI::App& command);

}  // namespace higherpair::cli
