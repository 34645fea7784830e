#pragma once

namespace higherpair {

/// Whether a byte of UTF-8 begins a character: those after the first begin with the bits 10.
[[nodiscard]] constexpr bool begins_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

}  // namespace higherpair
