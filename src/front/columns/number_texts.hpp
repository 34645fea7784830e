#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace higherpair {

/// Writes the fewest digits that read back as the same double, as std::to_chars does, but faster; returns the
/// end of the text. \param out  has room for NumberTexts::kLongest characters, all of which may be changed
[[nodiscard]] char* put_shortest(double value, char* out);

/// Numbers as text: the fewest digits that read back as the same double. Half of the numbers in a row repeat
/// another one in it, or in the row before: the texts of recent numbers are kept.
class NumberTexts {
public:
  /// Maximum number of characters of a number.
  static constexpr std::size_t kLongest = 24;

  NumberTexts() : known_(std::size_t{1} << kKnownBits) {}

  /// Writes a number and returns the end of the text. \param out  has room for kLongest characters, all of
  /// which may be changed
  [[nodiscard]] char* put(double value, char* out) {
    const auto bits = std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value);
    Text& known = known_[bits * 0x9E3779B97F4A7C15U >> (64 - kKnownBits)];
    if (known.bits != bits) {
      known.bits = bits;
      char* const begin = known.text.data();
      known.length = static_cast<std::uint32_t>(put_shortest(std::bit_cast<double>(bits), begin) - begin);
    }
    std::memcpy(out, known.text.data(), kLongest);
    return out + known.length;
  }

private:
  static constexpr int kKnownBits = 9;

  struct Text {
    std::uint64_t bits = 0;
    std::uint32_t length = 1;
    std::array<char, kLongest> text = {'0'};
  };

  std::vector<Text> known_;
};

}  // namespace higherpair
