#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

/// About how wide a text is in a sans-serif font, rather too wide than too narrow [px].
/// \param size  of the font [px]
[[nodiscard]] double text_width(std::string_view text, double size);

/// The lines into which a text is broken at its spaces; a word that is wider gets a line of its own.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, double size, double width);

/// An upright rectangle on the screen [px].
struct TextBox {
  double left = 0, top = 0, right = 0, bottom = 0;

  [[nodiscard]] bool overlaps(const TextBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

/// A label that hangs like a flag on the thin vertical line that it names.
struct Flag {
  double x = 0;           ///< of the line [px]
  double width = 0;       ///< of the text [px]
  bool leftward = false;  ///< the text is on the left of the line, else on its right
  int lane = 0;           ///< from the bottom, 0; the line rises to it
};

/// Sets side and lane of each, so that no text covers another or a line, and none passes `right` unless
/// there is no room on the left either.
/// \param flags  by rising x
void place_flags(std::vector<Flag>& flags, double left, double right);

}  // namespace higherpair
