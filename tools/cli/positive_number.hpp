#pragma once

#include <cmath>
#include <string>

#include <CLI/CLI.hpp>

namespace higherpair::cli {

/// Whether an option is a number above 0; CLI::PositiveNumber lets nan pass.
[[nodiscard]] inline CLI::Validator positive_number() {
  const auto objection = [](const std::string& text) -> std::string {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0;
    return good ? "" : "'" + text + "' is no number above 0";
  };
  return {objection, "POSITIVE"};
}

/// Whether an option is a number, and neither nan nor infinite.
[[nodiscard]] inline CLI::Validator finite_number() {
  const auto objection = [](const std::string& text) -> std::string {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
    return good ? "" : "'" + text + "' is no number";
  };
  return {objection, ""};
}

}  // namespace higherpair::cli
