#pragma once

#include "document.hpp"

#include <string>

namespace higherpair::io_detail {

/// A value as TOML writes it, on one line. Dates, which documents do not keep, have no text.
[[nodiscard]] std::string toml_text(const Value& value);

/// A table of the document with its heading: its tables have headings of their own, and what they hold is on
/// one line each.
[[nodiscard]] std::string toml_section(const std::string& name, const Table& table);

/// Whether two values say the same, whatever the order of keys in tables.
[[nodiscard]] bool same_content(const Value& a, const Value& b);

}  // namespace higherpair::io_detail
