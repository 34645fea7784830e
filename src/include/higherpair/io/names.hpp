#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace higherpair::io_detail {

[[nodiscard]] constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Whether `text` is a name of the profile format: [A-Za-z_][A-Za-z0-9_-]*.
[[nodiscard]] constexpr bool is_name(std::string_view text) {
  return !text.empty() && (is_letter(text.front()) || text.front() == '_') &&
         std::all_of(text.begin(), text.end(),
                     [](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; });
}

inline constexpr std::string_view kNameRule =
    "a name begins with a letter from A to Z or a to z, or _, and goes on with these, digits and -";

/// `text` without leading and trailing spaces and tabs.
[[nodiscard]] constexpr std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpaces = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
  return text.substr(0, text.find_last_not_of(kSpaces) + 1);
}

/// Whether two letters, or words, differ in being capital at most.
[[nodiscard]] inline bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}
[[nodiscard]] inline bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_letter);
}

/// Whether a character shows nothing or a blank only: control characters, unusual blanks, marks without
/// width.
[[nodiscard]] bool is_invisible(char32_t c);

/// `text` on one line in which all characters can be told apart: invisible ones, and letters that look like
/// Latin ones beside them, are written <U+00A0>.
[[nodiscard]] std::string visible(std::string_view text);

/// `text` with the blanks that documents have between a number and its unit replaced by spaces.
[[nodiscard]] std::string with_plain_blanks(std::string_view text);

}  // namespace higherpair::io_detail
