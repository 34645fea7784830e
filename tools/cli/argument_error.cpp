#include "argument_error.hpp"

#include "option_checks.hpp"
#include "unknown_argument.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace higherpair::cli {
namespace {

// The parser's message for a value of the wrong kind: "Could not convert: --samples = ten".
constexpr std::string_view kNotConverted = "Could not convert: ";

std::string kind_of_value(const CLI::App& command, const std::string& option) {
  const CLI::Option* const known = command.get_option_no_throw(option);
  const std::string type = known == nullptr ? "" : known->get_type_name();
  return type.find("INT") != std::string::npos ? "an integer" : "a number";
}

std::string not_converted(const CLI::App& command, std::string_view text) {
  text.remove_prefix(kNotConverted.size());
  const std::size_t equals = text.find(" = ");
  const std::string option(text.substr(0, equals));
  if (equals == std::string_view::npos) {
    return option + ": cannot be understood";
  }
  const std::string_view value = text.substr(equals + 3);
  return with_separator_advice(
      fmt::format("{} {}: must be {}", option, value, kind_of_value(command, option)), value);
}

// Rewords "--samples: Value 2.5 not in range 2 to 100", which is also said of a number that is not whole.
std::optional<std::string> not_in_range(const CLI::App& command, const std::string& text) {
  constexpr std::string_view kValue = ": Value ", kRange = " not in range ";
  const std::size_t value = text.find(kValue), range = text.find(kRange);
  if (value == std::string::npos || range == std::string::npos) {
    return std::nullopt;
  }
  const std::string option = text.substr(0, value);
  const std::size_t from = value + kValue.size();
  const std::string given = text.substr(from, range - from);
  std::string limits = text.substr(range + kRange.size());
  constexpr std::string_view kDecimals = ".000000";
  for (std::size_t at = limits.find(kDecimals); at != std::string::npos; at = limits.find(kDecimals)) {
    limits.erase(at, kDecimals.size());
  }
  return with_separator_advice(
      fmt::format("{} {}: must be {} from {}", option, given, kind_of_value(command, option), limits), given);
}

// Rewords "--csv: 1 required TEXT missing" and "--csv: At Most 1 required but received 2".
std::string wrong_count(const std::string& text) {
  const std::string option = text.substr(0, text.find(':'));
  return option + (text.find("missing") != std::string::npos ? " needs a value" : " is given more than once");
}

std::string sentence(const CLI::App& command, const CLI::ParseError& error) {
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr &&
      text.compare(0, kNotConverted.size(), kNotConverted) == 0) {
    return not_converted(command, text);
  }
  return dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr
             ? wrong_count(text)
             : not_in_range(command, text).value_or(text);
}

}  // namespace

std::string argument_error(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  if (given.empty()) {
    const std::string unknown = unknown_argument(app);
    return unknown.empty() ? no_command(app) : unknown;
  }
  const CLI::App& command = *given.front();
  return fmt::format("{}; see higherpair {} --help", sentence(command, error), command.get_name());
}

}  // namespace higherpair::cli
