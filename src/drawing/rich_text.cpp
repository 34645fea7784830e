#include "rich_text.hpp"

#include "text_layout.hpp"

#include <algorithm>

namespace higherpair {
namespace {

constexpr double kSmaller = 0.84;  // relative size of subscripts and superscripts
constexpr double kLowered = 0.28;  // relative to the size
constexpr double kRaised = -0.40;
// A prime of the size of a subscript is a dot on the screen: it is larger, and so far down that it is at the
// top of its letter.
constexpr std::string_view kPrime = "′";
constexpr double kPrimeSize = 1.35, kPrimeLowered = 0.14;
constexpr double kPrimeApart = 0.12;  // from its letter, which the white around it would cover

double shift_of(int level, double size) {
  return (level < 0 ? kLowered : level > 0 ? kRaised : 0.0) * size;
}

std::vector<SvgWriter::Run> runs_of(std::string_view markup, double size) {
  std::vector<SvgWriter::Run> runs;
  for (const TextPiece& piece : pieces_of(markup)) {
    const double down = shift_of(piece.level, size);
    for (std::string_view rest = piece.text; !rest.empty();) {
      const bool prime = rest.starts_with(kPrime);
      const std::size_t end = prime ? kPrime.size() : std::min(rest.find(kPrime), rest.size());
      const std::string text(rest.substr(0, end));
      runs.push_back(
          prime ? SvgWriter::Run{text, down + kPrimeLowered * size, kPrimeSize * size, kPrimeApart * size}
                : SvgWriter::Run{text, down, piece.level == 0 ? size : kSmaller * size, 0});
      rest.remove_prefix(end);
    }
  }
  return runs;
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
  for (const SvgWriter::Run& run : runs_of(markup, size)) {
    width += text_width(run.text, run.text == kPrime ? size : run.size);
  }
  return width;
}

void rich_text(SvgWriter& svg, double x, double y, std::string_view markup, double size,
               std::string_view kind) {
  svg.text({{"class", kind}, {"x", x}, {"y", y}}, runs_of(markup, size));
}

std::string plain_text(std::string_view markup) {
  std::string text;
  for (const TextPiece& piece : pieces_of(markup)) {
    text += (piece.level < 0 ? "_" : piece.level > 0 ? "^" : "") + piece.text;
  }
  return text;
}

}  // namespace higherpair
