#pragma once

#include "higherpair/io/units.hpp"

#include <cmath>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace higherpair::cli {

/// The objection to a value that should be a number, with what to write instead of a decimal comma or
/// separators of thousands in it.
[[nodiscard]] inline std::string with_separator_advice(const std::string& objection, std::string_view value) {
  std::string advice = separator_advice(value);
  if (advice.empty() && value.find(',') != std::string_view::npos) {
    advice = "decimals are written with a point";
  }
  return advice.empty() ? objection : objection + "; " + advice;
}

/// Requires an option to be a finite number that `is` such a one; CLI::PositiveNumber would accept nan.
/// \param what  for the objection, "number above 0"
/// \param type  for the help, "POSITIVE"
[[nodiscard]] inline CLI::Validator number_that(bool (*is)(double), const std::string& what,
                                                const std::string& type) {
  const auto objection = [is, what](const std::string& text) -> std::string {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && is(value);
    return good ? "" : with_separator_advice("'" + text + "' is no " + what, text);
  };
  return {objection, type};
}

[[nodiscard]] inline CLI::Validator finite_number() {
  return number_that([](double) { return true; }, "number", "");
}

[[nodiscard]] inline CLI::Validator positive_number() {
  return number_that([](double value) { return value > 0; }, "number above 0", "POSITIVE");
}

/// Requires an option to be a fraction between 0 and 1.
[[nodiscard]] inline CLI::Validator share() {
  return number_that([](double value) { return value > 0 && value < 1; },
                     "share between 0 and 1, such as 0.95", "SHARE");
}

/// Requires an option to be an integer >= 0; the parser would take the sign of -1 for a large number.
[[nodiscard]] inline CLI::Validator not_negative() {
  return {[](const std::string& text) -> std::string {
            return text.starts_with('-') ? "'" + text + "' is negative" : "";
          },
          ""};
}

}  // namespace higherpair::cli
