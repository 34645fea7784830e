#pragma once

#include "document.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace higherpair::io_detail {

/// A mistake at a place of a text.
struct TextMistake {
  Mark mark;
  std::string message;
};

/// The bytes of the character of UTF-8 at the front of `text`, 1 to 4; 0 if they are not one, or none is
/// left.
[[nodiscard]] std::size_t character_length(std::string_view text);

/// The code point at the front of `text`, which must be a character of UTF-8.
[[nodiscard]] char32_t character_at(std::string_view text);

/// Whether `text` is in UTF-16 or UTF-32.
[[nodiscard]] bool is_wide(std::string_view text);

/// What keeps `text` from being UTF-8: UTF-16 or UTF-32, Latin-1, data that are no text at all.
[[nodiscard]] std::optional<TextMistake> encoding_mistake(std::string_view text);

/// Line and column, in characters and both from 1, of a byte of the text; and the byte at such a place, the
/// end of the line where the line is shorter.
[[nodiscard]] Mark mark_at(std::string_view text, std::size_t byte);
[[nodiscard]] std::size_t byte_at(std::string_view text, int line, int column);

}  // namespace higherpair::io_detail
