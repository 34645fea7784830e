#include "rich_text.hpp"

#include "text_layout.hpp"

#include <algorithm>

namespace higherpair {
namespace {

constexpr double kSmaller = 0.84;  // relative size of subscripts and superscripts
constexpr double kLowered = 0.28;  // relative to the size
constexpr double kRaised = -0.40;

double shift_of(int level, double size) {
  return (level < 0 ? kLowered : level > 0 ? kRaised : 0.0) * size;
}

}  // namespace

std::vector<TextPiece> pieces_of(std::string_view markup) {
  std::vector<TextPiece> pieces;
  while (!markup.empty()) {
    const bool shifted = markup.starts_with("_{") || markup.starts_with("^{");
    if (shifted) {
      const std::size_t end = std::min(markup.find('}'), markup.size());
      pieces.push_back({std::string(markup.substr(2, end - 2)), markup[0] == '_' ? -1 : 1});
      markup.remove_prefix(std::min(end + 1, markup.size()));
    } else {
      const std::size_t end = std::min({markup.find("_{", 1), markup.find("^{", 1), markup.size()});
      pieces.push_back({std::string(markup.substr(0, end)), 0});
      markup.remove_prefix(end);
    }
  }
  return pieces;
}

double rich_width(std::string_view markup, double size) {
  double width = 0;
  for (const TextPiece& piece : pieces_of(markup)) {
    width += text_width(piece.text, piece.level == 0 ? size : kSmaller * size);
  }
  return width;
}

void rich_text(SvgWriter& svg, double x, double y, std::string_view markup, double size,
               std::string_view kind) {
  std::vector<SvgWriter::Run> runs;
  double shift = 0;
  for (const TextPiece& piece : pieces_of(markup)) {
    const double wanted = shift_of(piece.level, size);
    runs.push_back({piece.text, wanted - shift, piece.level == 0 ? size : kSmaller * size});
    shift = wanted;
  }
  svg.text({{"class", kind}, {"x", x}, {"y", y}}, runs);
}

std::string plain_text(std::string_view markup) {
  std::string text;
  for (const TextPiece& piece : pieces_of(markup)) {
    text += (piece.level < 0 ? "_" : piece.level > 0 ? "^" : "") + piece.text;
  }
  return text;
}

}  // namespace higherpair
