#include "text_layout.hpp"

#include "numeric/utf8.hpp"

#include <algorithm>

namespace higherpair {
namespace {

constexpr double kGap = 6;  // between a flag's text and the next line [px]

// Widths relative to the font size, measured in DejaVu Sans, which is wider than Helvetica and Arial.
double width_of(char c) {
  constexpr std::string_view kNarrow = "iljtfrI.,:;'|!()[] /-";
  constexpr std::string_view kWide = "mwMW@%+=<>";
  if (!begins_character(c)) return 0;
  if (kNarrow.find(c) != std::string_view::npos) return 0.4;
  if (kWide.find(c) != std::string_view::npos) return 0.95;
  return c >= 'A' && c <= 'Z' ? 0.72 : 0.63;
}

}  // namespace

double text_width(std::string_view text, double size) {
  double width = 0;
  for (const char c : text) {
    width += width_of(c);
  }
  return width * size;
}

std::vector<std::string> wrapped(std::string_view text, double size, double width) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    const std::string longer = lines.empty() ? std::string(word) : lines.back() + ' ' + std::string(word);
    if (lines.empty() || text_width(longer, size) > width) {
      lines.emplace_back(word);
    } else {
      lines.back() = longer;
    }
  }
  return lines;
}

// A text may cover the lines of lower flags, and is in a lane above all flags that it covers. Flags with
// their text on the left are above those with their text on the right. No text on the right reaches the line
// of a flag with its text on the left: it is put on the left as well, if there is room.
void place_flags(std::vector<Flag>& flags, double left, double right) {
  double limit = right;
  for (auto flag = flags.rbegin(); flag != flags.rend(); ++flag) {
    flag->leftward = flag->x + flag->width > limit && flag->x - flag->width >= left;
    if (flag->leftward) limit = std::min(limit, flag->x - kGap);
  }
  const auto over = [&](const Flag& above, auto covers) {
    int lane = 0;
    for (const Flag& flag : flags) {
      if (&flag != &above && covers(flag)) lane = std::max(lane, flag.lane + 1);
    }
    return lane;
  };
  for (std::size_t i = flags.size(); i-- > 0;) {
    Flag& flag = flags[i];
    if (!flag.leftward) {
      flag.lane = over(flag, [&](const Flag& other) {
        return &other > &flag && !other.leftward && other.x <= flag.x + flag.width + kGap;
      });
    }
  }
  for (Flag& flag : flags) {
    if (flag.leftward) {
      flag.lane = over(flag, [&](const Flag& other) {
        const double reach = other.leftward ? other.x : other.x + other.width;
        return (&other < &flag || !other.leftward) && reach + kGap >= flag.x - flag.width &&
               other.x <= flag.x;
      });
    }
  }
}

}  // namespace higherpair
