#pragma once

#include "higherpair/geometry/pose.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

/// The approximate width of a text in a sans-serif font, rather too large than too small [px].
/// \param size  of the font [px]
[[nodiscard]] double text_width(std::string_view text, double size);

/// By how much bold letters are wider than others.
inline constexpr double kBoldWidth = 1.15;

/// Breaks a text into lines at its spaces; a word wider than `width` gets a line of its own.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, double size, double width);

/// An upright rectangle on the screen [px].
struct TextBox {
  double left = 0, top = 0, right = 0, bottom = 0;

  [[nodiscard]] bool overlaps(const TextBox& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  [[nodiscard]] bool is_within(const TextBox& outer) const {
    return left >= outer.left && right <= outer.right && top >= outer.top && bottom <= outer.bottom;
  }
  [[nodiscard]] bool holds(const Vector2d& p) const {
    return left <= p.x() && p.x() <= right && top <= p.y() && p.y() <= bottom;
  }
};

/// A label that hangs like a flag on the thin vertical line that it names.
struct Flag {
  double x = 0;           ///< of the line [px]
  double width = 0;       ///< of the text [px]
  bool leftward = false;  ///< the text is left of the line, otherwise right of it
  int lane = 0;           ///< counted from the bottom, from 0; the line extends up to it
};

/// Sets side and lane of each flag so that no text covers another text or a line, and none extends beyond
/// `right` unless there is no room on the left either.
/// \param flags  in ascending order of x
void place_flags(std::vector<Flag>& flags, double left, double right);

}  // namespace higherpair
