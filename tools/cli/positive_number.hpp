#pragma once

#include <cmath>
#include <string>

#include <CLI/CLI.hpp>

namespace higherpair::cli {

/// Requires an option to be a finite number above 0; CLI::PositiveNumber would accept nan.
[[nodiscard]] inline CLI::Validator positive_number() {
  const auto objection = [](const std::string& text) -> std::string {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0;
    return good ? "" : "'" + text + "' is no number above 0";
  };
  return {objection, "POSITIVE"};
}

/// Requires an option to be an integer >= 0; the parser would take the sign of -1 for a large number.
[[nodiscard]] inline CLI::Validator not_negative() {
  return {[](const std::string& text) -> std::string {
            return text.starts_with('-') ? "'" + text + "' is negative" : "";
          },
          ""};
}

/// Requires an option to be a finite number.
[[nodiscard]] inline CLI::Validator finite_number() {
  const auto objection = [](const std::string& text) -> std::string {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
    return good ? "" : "'" + text + "' is no number";
  };
  return {objection, ""};
}

}  // namespace higherpair::cli
