#pragma once

#include "higherpair/io/diagnostic.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair::io_detail {

/// Where a value was written. Marks are ordered as mistakes are reported: those of the file by line and
/// column, then those of the overrides in their order.
struct Mark {
  int source = 0;  ///< 0: the file; k: the k-th override, which has no lines
  int line = 0;
  int column = 0;

  friend bool operator<(const Mark& a, const Mark& b) {
    return std::tie(a.source, a.line, a.column) < std::tie(b.source, b.line, b.column);
  }
};

/// What is wrong, or probably wrong, at a mark. The rest tells which mistakes are mere consequences of
/// another one; its paths are such as "bodies.cam.mass".
struct Mistake {
  Mark mark;
  std::string message;
  std::string subject = {};             ///< path of the wrong value, unless that is a table
  std::vector<std::string> lacks = {};  ///< paths of what is not there; any one of them would do
  std::vector<std::string> meant =
      {};  ///< of an unknown key: paths of those that it was probably meant to be
  const struct Value* value = nullptr;  ///< of an unknown key
};

struct Entry;

/// A date or time, which no profile needs.
struct DateTime {};

using Array = std::vector<struct Value>;
using Table = std::vector<Entry>;

/// A TOML value and its position in the source; the entries of a table are in the order of the file.
struct Value {
  std::variant<std::string, std::int64_t, double, bool, DateTime, Array, Table> content;
  Mark mark;
};

struct Entry {
  std::string key;
  Mark key_mark;
  Value value;
};

/// Nothing if the table has no such key.
[[nodiscard]] const Value* find(const Table& table, std::string_view key);

/// The entry of a table, or the item of a list, named by one part of a path; null if there is none.
[[nodiscard]] const Value* find_part(const Value& value, std::string_view part);
/// The value at the end of a path, and the entry of the last table along it; null if there is none.
struct PathEnd {
  const Value* value = nullptr;
  const Entry* entry = nullptr;
};
[[nodiscard]] PathEnd end_of_path(const Table& document, std::string_view path);
/// The value at a path, "bodies.crank.points.A.0".
[[nodiscard]] Value* find_path(Value& document, std::string_view path);

/// A number, whether written as a float or as an integer; nothing for any other value.
[[nodiscard]] std::optional<double> number_in(const Value& value);

/// Calls `found` with the path of every number, in the order of the file.
void for_each_number(const Table& document,
                     const std::function<void(const std::string& path, double number)>& found);

/// "a string", "an integer", "a table", …
[[nodiscard]] std::string_view kind_of(const Value& value);

/// The value as TOML writes it, cut after some 40 characters, for messages.
[[nodiscard]] std::string text_of(const Value& value);

/// Parses a TOML text into a table; the error is the first syntax mistake.
[[nodiscard]] tl::expected<Value, Diagnostic> parse_document(std::string_view text,
                                                             const std::string& source_name);

/// A document with an override.
struct Overridden {
  Value document;
  /// If the path leads through a table that was not there but whose name is near to one that was: "there is
  /// no `disk` in bodies.cam.curves; did you mean `disc`?". Else empty.
  std::string doubt;
};

/// Sets the key named by "PATH=VALUE" in `document`; everything set is marked with source `number`. The error
/// tells what is wrong with the path.
[[nodiscard]] tl::expected<Overridden, std::string> apply_override(Value document,
                                                                   std::string_view assignment, int number);

/// The VALUE of an override: TOML where it can be parsed as such, otherwise a string.
[[nodiscard]] Value parse_override_value(std::string_view text, int number);

}  // namespace higherpair::io_detail
