#include "number_texts.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace higherpair {
namespace {

constexpr int kMostDigits = 17;  // of the shortest decimal of a double
constexpr std::uint64_t kZeros = 0x3030303030303030U;

// The eight digits of a number below 10⁸ as characters, the first in the lowest byte. The number is split
// into groups of four digits, then of two, then of one, all groups of the word at once.
std::uint64_t eight_digits(std::uint32_t number) {
  const std::uint64_t fours = number / 10000 | static_cast<std::uint64_t>(number % 10000) << 32;
  const std::uint64_t hundreds = (fours * 10486 >> 20) & 0x0000007F0000007FU;  // 10486/2^20: about 1/100
  const std::uint64_t twos = hundreds | (fours - 100 * hundreds) << 16;
  const std::uint64_t tens = (twos * 103 >> 10) & 0x000F000F000F000FU;  // 103/2^10: about 1/10
  return (tens | (twos - 10 * tens) << 8) | kZeros;
}

// Writes seventeen digits; returns the number of leading zeros.
int put_digits(std::uint64_t number, char* out) {
  constexpr std::uint64_t kEight = 100'000'000;
  const std::uint64_t upper = number / kEight;
  const std::uint64_t first = upper / kEight;
  const std::uint64_t middle = eight_digits(static_cast<std::uint32_t>(upper - first * kEight));
  const std::uint64_t last = eight_digits(static_cast<std::uint32_t>(number - upper * kEight));
  *out = static_cast<char>('0' + first);
  std::memcpy(out + 1, &middle, sizeof middle);
  std::memcpy(out + 9, &last, sizeof last);
  const auto zeros = [](std::uint64_t digits) { return std::countr_zero(digits ^ kZeros) / 8; };
  return first > 0 ? 0 : middle != kZeros ? 1 + zeros(middle) : 9 + zeros(last);
}

// Whether 0.digits, with zeros after the point, is no longer than the form with an exponent, which needs no
// point if there is only one digit.
bool is_short_enough(int zeros, int digits) {
  return zeros <= (digits > 1 ? 3 : 2);
}

char* put_standard(double value, char* out) {
  return std::to_chars(out, out + NumberTexts::kLongest, value).ptr;
}

}  // namespace

char* put_shortest(double value, char* out) {
  const double size = std::abs(value);
  if (std::endian::native != std::endian::little || !(size >= 1e-99 && size < 1e17)) {
    return put_standard(value, out);
  }
  // Not a public part of fmt; tested with fmt 9.1. std::to_chars alone takes 1.6 times as long as all of
  // this.
  const auto decimal = fmt::detail::dragonbox::to_decimal(size);
  if (decimal.exponent >= 0) {  // whole: rare, and with an exponent if that is shorter
    return put_standard(value, out);
  }
  std::array<char, std::size_t{2} * kMostDigits> all{};
  const int skipped = put_digits(decimal.significand, all.data());
  const char* const digits = all.data() + skipped;
  const int count = kMostDigits - skipped;
  const int point = count + decimal.exponent;  // number of digits before it
  std::array<char, std::size_t{3} * kMostDigits> text{};
  char* end = text.data();
  *end = '-';
  end += value < 0 ? 1 : 0;
  // Copies more than the digits: a copy of constant length is cheap.
  if (point > 0) {
    std::memcpy(end, digits, kMostDigits - 1);
    std::memcpy(end + point + 1, digits + point, kMostDigits - 1);
    end[point] = '.';
    end += count + 1;
  } else if (is_short_enough(-point, count)) {
    std::memcpy(end, "0.000", 5);
    end += 2 - point;
    std::memcpy(end, digits, kMostDigits);
    end += count;
  } else {
    *end++ = digits[0];
    *end = '.';
    std::memcpy(end + 1, digits + 1, kMostDigits - 1);
    end += count > 1 ? count : 0;
    const int exponent = 1 - point;
    std::memcpy(end, "e-", 2);
    end[2] = static_cast<char>('0' + exponent / 10);
    end[3] = static_cast<char>('0' + exponent % 10);
    end += 4;
  }
  std::memcpy(out, text.data(), NumberTexts::kLongest);
  return out + (end - text.data());
}

}  // namespace higherpair
