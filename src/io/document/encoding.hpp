#pragma once

#include "document.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace higherpair::io_detail {

/// The text after its byte order mark of UTF-8, if it has one.
[[nodiscard]] std::string_view without_bom(std::string_view text);

/// The number of bytes, 1 to 4, of the UTF-8 character at the front of `text`; 0 if the text is empty or does
/// not begin with a valid character.
[[nodiscard]] std::size_t character_length(std::string_view text);

/// The code point at the front of `text`, which must be a character of UTF-8.
[[nodiscard]] char32_t character_at(std::string_view text);

/// Whether `text` is in UTF-16 or UTF-32.
[[nodiscard]] bool is_wide(std::string_view text);

/// Why `text` is not UTF-8: it is UTF-16 or UTF-32, Latin-1, or no text at all. None if it is UTF-8.
[[nodiscard]] std::optional<Mistake> encoding_mistake(std::string_view text);

/// Converts between a byte offset and a line and column (in characters, both counted from 1). Where the line
/// is shorter than `column`, byte_at() gives its end.
[[nodiscard]] Mark mark_at(std::string_view text, std::size_t byte);
[[nodiscard]] std::size_t byte_at(std::string_view text, int line, int column);

}  // namespace higherpair::io_detail
