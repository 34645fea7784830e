#include "json_writer.hpp"

#include <cmath>
#include <cstddef>
#include <iterator>

#include <fmt/format.h>

namespace higherpair {
namespace {

// Length of the UTF-8 sequence at the beginning of the text; 0 if it is invalid.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length > text.size()) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  return length;
}

}  // namespace

JsonWriter& JsonWriter::string(std::string_view value) {
  separate();
  text_ += '"';
  for (std::size_t i = 0; i < value.size();) {
    const std::size_t length = sequence_length(value.substr(i));
    const char c = value[i];
    if (length == 0) {
      text_ += "\\ufffd";
    } else if (length == 1 && (static_cast<unsigned char>(c) < 0x20 || c == '<')) {
      fmt::format_to(std::back_inserter(text_), "\\u{:04x}", static_cast<unsigned>(c));
    } else {
      if (c == '"' || c == '\\') text_ += '\\';
      text_ += value.substr(i, length);
    }
    i += length == 0 ? 1 : length;
  }
  text_ += '"';
  return *this;
}

JsonWriter& JsonWriter::integer(long long value) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", value);
  return *this;
}

JsonWriter& JsonWriter::number(double value, int digits) {
  if (!std::isfinite(value)) {
    return null();
  }
  separate();
  fmt::format_to(std::back_inserter(text_), "{:.{}g}", value == 0 ? 0.0 : value, digits);
  return *this;
}

}  // namespace higherpair
