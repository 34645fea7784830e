#include "higherpair/io/names.hpp"

#include "encoding.hpp"

#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// Ends of ranges, both included.
constexpr std::pair<char32_t, char32_t> kInvisible[] = {
    {0, 0x1F},          {0x7F, 0xA0},       {0xAD, 0xAD},     {0x34F, 0x34F},   {0x61C, 0x61C},
    {0x115F, 0x1160},   {0x180B, 0x180F},   {0x2000, 0x200F}, {0x2028, 0x202F}, {0x205F, 0x206F},
    {0x3000, 0x3000},   {0x3164, 0x3164},   {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF}, {0xFFA0, 0xFFA0},
    {0x1D173, 0x1D17A}, {0xE0000, 0xE0FFF},
};

// Cyrillic and Greek letters that look like Latin ones.
constexpr std::u32string_view kLookAlikes = U"АВЕЅІЈКМНОРСТУХаеѕіјорсухԁԛԝΑΒΕΖΗΙΚΜΝΟΡΤΥΧορν";

constexpr std::string_view kBlanks[] = {"\u00A0", "\u2007", "\u2009", "\u202F"};

// The bytes of the character at the front; 1 where it is not UTF-8.
std::size_t length_of(std::string_view text) {
  return std::max<std::size_t>(character_length(text), 1);
}

// The word at the front: Latin letters, and characters beyond ASCII.
std::string_view letters_of(std::string_view text) {
  const auto* const end =
      std::find_if_not(text.begin(), text.end(), [](char c) { return is_letter(c) || (c & 0x80) != 0; });
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

}  // namespace

bool is_invisible(char32_t c) {
  return std::any_of(std::begin(kInvisible), std::end(kInvisible),
                     [&](const auto& range) { return c >= range.first && c <= range.second; });
}

std::string visible(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, std::max<std::size_t>(letters_of(text).size(), 1));
    const bool is_latin = std::any_of(word.begin(), word.end(), is_letter);
    for (std::size_t i = 0; i < word.size();) {
      const std::string_view one = word.substr(i, length_of(word.substr(i)));
      const bool is_character = character_length(one) > 0;
      const char32_t c = is_character ? character_at(one) : 0;
      const bool is_hidden =
          is_character && (is_invisible(c) || (is_latin && kLookAlikes.find(c) != std::u32string_view::npos));
      result += is_hidden ? fmt::format("<U+{:04X}>", static_cast<unsigned>(c)) : std::string(one);
      i += one.size();
    }
    text.remove_prefix(word.size());
  }
  return result;
}

std::string with_plain_blanks(std::string_view text) {
  std::string result(text);
  for (const std::string_view blank : kBlanks) {
    for (std::size_t at = result.find(blank); at != std::string::npos; at = result.find(blank, at)) {
      result.replace(at, blank.size(), " ");
    }
  }
  return result;
}

}  // namespace higherpair::io_detail
