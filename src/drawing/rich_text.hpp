#pragma once

#include "svg_writer.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

/// A piece of a text that is a subscript (-1), a superscript (1) or neither.
struct TextPiece {
  std::string text;
  int level = 0;
};

/// The pieces of "a_{BA}^{n} = 0"; an unclosed brace extends to the end of the text.
[[nodiscard]] std::vector<TextPiece> pieces_of(std::string_view markup);

/// The approximate width [px].
[[nodiscard]] double rich_width(std::string_view markup, double size);

/// Writes the text as a single text element.
void rich_text(SvgWriter& svg, double x, double y, std::string_view markup, double size,
               std::string_view kind = "");

/// The text without braces, for attributes: "a_BA^n = 0".
[[nodiscard]] std::string plain_text(std::string_view markup);

}  // namespace higherpair
