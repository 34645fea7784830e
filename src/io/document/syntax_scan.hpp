#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::io_detail {

/// A key with its value, or the heading of a table.
struct Statement {
  std::size_t at = 0;   ///< its first byte
  std::string heading;  ///< of the table that it is in or begins, "" at the top level
  std::string key;      ///< "" for a heading; parts joined by dots, as in the heading
};

enum class Expecting { kStatement, kHeading, kKey, kValue };

/// The structure of a text up to the position where the parser stopped: up to there it is TOML, except for
/// the last token. All positions are byte offsets in the text.
struct SyntaxScan {
  std::string_view text;
  std::size_t stop = 0;              ///< where the parser stopped
  std::vector<std::size_t> open;     ///< positions of the unclosed [ and { of values, outermost first
  std::optional<std::size_t> quote;  ///< opening quote of the string that contains `stop`, if any
  std::size_t token = 0;             ///< where the last heading, key or value begins
  Expecting expecting = Expecting::kStatement;
  bool after_value = false;           ///< the last token is a string or list that has been closed
  std::vector<Statement> statements;  ///< the last one may be incomplete

  [[nodiscard]] bool in_list() const { return !open.empty() && text[open.back()] == '['; }
  [[nodiscard]] bool in_table() const { return !open.empty() && text[open.back()] == '{'; }
  /// The text from byte `from` to the end of its line, at most 500 bytes.
  [[nodiscard]] std::string_view line_from(std::size_t from) const;
  /// The last token, up to the next , ] } # or the end of the line.
  [[nodiscard]] std::string_view last_token() const;
};

[[nodiscard]] SyntaxScan scan_syntax(std::string_view text, std::size_t stop);

}  // namespace higherpair::io_detail
