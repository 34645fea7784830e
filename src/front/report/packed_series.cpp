#include "packed_series.hpp"

#include "front/pictures/column_scales.hpp"
#include "front/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace higherpair {
namespace {

constexpr int kMostDifferences = 6;
constexpr double kMostSteps = 1e13;  // bound of a number: differences of all orders are exact in JavaScript
constexpr int kMostExponent = 300;
constexpr int kConstantDigits = 12;

// A digit below 32 ends its number, a larger one is followed by more. None is special in JSON or HTML.
constexpr std::string_view kBase64Digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

using Whole = std::int64_t;

std::size_t length_of(std::uint64_t digits) {
  std::size_t length = 1;
  for (; digits >= 32; digits /= 32) ++length;
  return length;
}

// Maps small numbers of either sign to small unsigned ones.
std::uint64_t unsigned_of(Whole value) {
  return value < 0 ? 2 * static_cast<std::uint64_t>(-(value + 1)) + 1 : 2 * static_cast<std::uint64_t>(value);
}

std::size_t length_of(const std::vector<Whole>& numbers) {
  std::size_t length = 0;
  for (const Whole number : numbers) length += length_of(unsigned_of(number));
  return length;
}

std::string text_of(const std::vector<Whole>& numbers) {
  std::string text;
  for (const Whole number : numbers) {
    std::uint64_t rest = unsigned_of(number);
    for (; rest >= 32; rest /= 32) text += kBase64Digits[32 + rest % 32];
    text += kBase64Digits[rest];
  }
  return text;
}

void take_differences(std::vector<Whole>& numbers) {
  for (std::size_t i = numbers.size(); i-- > 1;) numbers[i] -= numbers[i - 1];
}

void write_gaps(JsonWriter& json, std::span<const double> values) {
  bool undefined = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) == undefined) {
      json.integer(static_cast<long long>(i));
      undefined = !undefined;
    }
  }
  if (undefined) json.integer(static_cast<long long>(values.size()));
}

// The exponent e for which 10^-e <= step.
int exponent_for(std::span<const double> values, double step) {
  const double rounded = std::max(step, largest_of(values) / kMostSteps);
  return static_cast<int>(
      std::clamp(std::ceil(-std::log10(rounded) - kPowerOfTen), -1.0 * kMostExponent, 1.0 * kMostExponent));
}

}  // namespace

void write_packed(JsonWriter& json, std::span<const double> values, double step) {
  const auto first = std::find_if(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (first == values.end()) {
    json.null();
    return;
  }
  if (std::all_of(values.begin(), values.end(), [&](double value) { return value == *first; })) {
    json.number(*first, kConstantDigits);
    return;
  }
  const int exponent = exponent_for(values, step);
  const double steps = std::pow(10, exponent);
  std::vector<Whole> best;
  double last = *first;  // is repeated where the numbers are undefined
  for (const double value : values) {
    if (std::isfinite(value)) last = value;
    best.push_back(std::llround(last * steps));
  }
  int order = 0;
  std::vector<Whole> numbers = best;
  for (int n = 1; n <= kMostDifferences; ++n) {
    take_differences(numbers);
    if (length_of(numbers) < length_of(best)) {
      best = numbers;
      order = n;
    }
  }
  json.open('[').integer(exponent).integer(order).string(text_of(best));
  write_gaps(json, values);
  json.close(']');
}

}  // namespace higherpair
