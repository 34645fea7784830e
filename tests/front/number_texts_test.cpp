// Formatted numbers are those of the standard library, character by character.
#include "front/columns/number_texts.hpp"

#include "numeric/decimal.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

std::string ours(double value) {
  std::array<char, NumberTexts::kLongest> text;
  return {text.data(), put_shortest(value, text.data())};
}

std::string standard(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

TEST(NumberTexts, OfAllMagnitudesAreThoseOfTheStandardLibrary) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-20, 20);
  for (int i = 0; i < 200000; ++i) {
    const double value = std::pow(10, exponent(random)) * (i % 2 == 0 ? 1 : -1);
    ASSERT_EQ(ours(value), standard(value));
  }
}

TEST(NumberTexts, OfAnyBitsAreThoseOfTheStandardLibrary) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 100000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) {
      ASSERT_EQ(ours(value), standard(value));
    }
  }
}

TEST(NumberTexts, OfFewDigitsAreThoseOfTheStandardLibrary) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 100000; ++i) {
    const double digits =
        std::floor(std::pow(10, static_cast<double>(i % 17)) * 1e-19 * static_cast<double>(random() >> 1));
    const double value = digits * std::pow(10, static_cast<double>(i % 41) - 20);
    ASSERT_EQ(ours(value), standard(value));
  }
  for (int e = -330; e <= 308; ++e) {
    for (const double first : {1.0, 2.0, 9.0, 1.5, 9.999999999999999, 1.0000000000000002}) {
      const double value = first * std::pow(10, e);
      ASSERT_EQ(ours(value), standard(value));
      ASSERT_EQ(ours(-value), standard(-value));
    }
  }
}

TEST(NumberTexts, OfTheEndsOfTheRangeAreThoseOfTheStandardLibrary) {
  using Limits = std::numeric_limits<double>;
  for (const double value :
       {0.0, Limits::min(), Limits::denorm_min(), Limits::max(), Limits::epsilon(), 0.1, 1e-99, 9.9e-100,
        1e17, 99999999999999984.0, 123456.75, 0.0001, 0.00012, 1e5, 12345678.0}) {
    EXPECT_EQ(ours(value), standard(value));
    EXPECT_EQ(ours(-value), standard(-value));
  }
}

TEST(RoundedTo, IsTheNearestDecimalWithSoManyDigits) {
  EXPECT_EQ(rounded_to(3 * 0.1, 12), 0.3);
  EXPECT_EQ(rounded_to(-1234.5678, 6), -1234.57);
  EXPECT_EQ(rounded_to(1.0 / 3, 17), 1.0 / 3);
  EXPECT_EQ(rounded_to(6.02214076e23, 3), 6.02e23);
  EXPECT_EQ(rounded_to(std::numeric_limits<double>::denorm_min(), 17),
            std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(rounded_to(0, 5), 0);
}

}  // namespace
}  // namespace higherpair
