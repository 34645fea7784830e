#pragma once

#include "syntax_scan.hpp"

#include <optional>
#include <string>
#include <string_view>

// Rules for common mistakes that are not valid TOML. Each rule looks at the position where the parser stopped
// and at its message, and returns nothing if it does not apply.

namespace higherpair::io_detail {

/// A mistake at a byte offset in the text.
struct Found {
  std::size_t at;
  std::string message;
};
using Finding = std::optional<Found>;

/// \name Repeated keys and headings; headings; brackets, braces and commas; keys
/// @{
[[nodiscard]] Finding redefinition(const SyntaxScan& scan, std::string_view message);
[[nodiscard]] Finding heading_mistake(const SyntaxScan& scan, std::string_view message);
[[nodiscard]] Finding bracket_mistake(const SyntaxScan& scan, std::string_view message);
[[nodiscard]] Finding key_mistake(const SyntaxScan& scan);
/// @}

/// A number with a unit and without quotes.
[[nodiscard]] Finding unit_mistake(const SyntaxScan& scan);

/// Other numbers, words without quotes, and anything that follows a value on its line.
[[nodiscard]] Finding value_mistake(const SyntaxScan& scan, std::string_view message);

/// About the first 40 characters of the text, on one line.
[[nodiscard]] std::string shown(std::string_view text);

/// The word at the front: letters, digits, _ and -.
[[nodiscard]] std::string_view word_of(std::string_view text);

/// Whether the text begins with a table heading or with a key and its =.
[[nodiscard]] bool begins_statement(std::string_view text);

[[nodiscard]] inline bool contains_text(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace higherpair::io_detail
