#include "encoding.hpp"

#include "numeric/utf8.hpp"

#include <algorithm>
#include <string>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr std::string_view kSaveAsUtf8 = "save it as UTF-8 (\"Save as\" of most editors offers the encoding)";

unsigned byte_of(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

// The UTF-8 text of a byte >= 0xA0 of Latin-1; Windows-1252 has the same characters there.
std::string latin1_character(unsigned byte) {
  return {static_cast<char>(0xC0U | (byte >> 6U)), static_cast<char>(0x80U | (byte & 0x3FU))};
}

std::string not_utf8(unsigned byte) {
  const std::string meant = byte >= 0xA0 ? fmt::format(", where it is {}", latin1_character(byte)) : "";
  return fmt::format("the byte 0x{:02X} is not UTF-8: the file seems to be in Latin-1 or Windows-1252{}; {}",
                     byte, meant, kSaveAsUtf8);
}

// Whether the start of a file has control characters: programs and compressed files do, texts in whatever
// encoding do not.
bool has_controls(std::string_view text) {
  constexpr std::size_t kLooked = 4096;
  const std::string_view start = text.substr(0, kLooked);
  return std::any_of(start.begin(), start.end(), [](char c) {
    return (c >= '\0' && c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f') || c == '\x7f';
  });
}

}  // namespace

// Detects UTF-16 and UTF-32 by their byte order marks, or else by the zero bytes that ASCII letters have in
// them.
bool is_wide(std::string_view text) {
  const auto zeros =
      std::count(text.begin(), text.begin() + std::min<std::ptrdiff_t>(4, std::ssize(text)), '\0');
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") || zeros == 2 || zeros == 3;
}

std::string_view without_bom(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

std::size_t character_length(std::string_view text) {
  if (text.empty()) {
    return 0;
  }
  const unsigned lead = byte_of(text, 0);
  if (lead < 0x80) {
    return 1;
  }
  const std::size_t length = lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
  if (length == 0 || text.size() < length) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if (begins_character(text[i])) return 0;
  }
  // Reject overlong encodings, surrogates, and code points beyond U+10FFFF.
  const char32_t c = character_at(text.substr(0, length));
  const bool is_least = (length != 3 || c >= 0x800) && (length != 4 || c >= 0x10000);
  return is_least && (c < 0xD800 || c > 0xDFFF) && c <= 0x10FFFF ? length : 0;
}

char32_t character_at(std::string_view text) {
  const unsigned lead = byte_of(text, 0);
  if (lead < 0x80) {
    return lead;
  }
  const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  char32_t c = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    c = c << 6U | (byte_of(text, i) & 0x3FU);
  }
  return c;
}

std::optional<Mistake> encoding_mistake(std::string_view text) {
  if (is_wide(text)) {
    return Mistake{{}, fmt::format("this file is in UTF-16 or UTF-32; {}", kSaveAsUtf8)};
  }
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text.substr(i));
    if (length == 0) {
      return Mistake{mark_at(text, i),
                     has_controls(text) ? fmt::format("the byte 0x{:02X} and control characters: this is no "
                                                      "text file",
                                                      byte_of(text, i))
                                        : not_utf8(byte_of(text, i))};
    }
    if (text[i] == '\0') {
      return Mistake{mark_at(text, i), "a zero byte: this is no text file"};
    }
    i += length;
  }
  return std::nullopt;
}

Mark mark_at(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::string_view line = before.substr(before.rfind('\n') + 1);
  const auto characters = std::count_if(line.begin(), line.end(), begins_character);
  return {0, static_cast<int>(lines) + 1, static_cast<int>(characters) + 1};
}

std::size_t byte_at(std::string_view text, int line, int column) {
  std::size_t byte = 0;
  for (int i = 1; i < line && byte < text.size(); ++i) {
    byte = std::min(text.find('\n', byte), text.size() - 1) + 1;
  }
  for (int i = 1; i < column && byte < text.size() && text[byte] != '\n'; ++i) {
    byte += std::max<std::size_t>(character_length(text.substr(byte)), 1);
  }
  return byte;
}

}  // namespace higherpair::io_detail
