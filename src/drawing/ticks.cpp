#include "ticks.hpp"

#include "tolerances.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr double kValueMargin = 0.05;  // fraction of the span of the values, added above and below
constexpr int kLargestExponent = 5;    // numbers up to 99 999 are written out
constexpr int kSmallestExponent = -3;
constexpr int kLongestNumber = 7;    // exponent from which a single number has a power of ten
constexpr int kSmallestNumber = -4;  // the same for small numbers: below

double round_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - kOnTick)) {
      return factor * power;
    }
  }
  return 10 * power;
}

double degree_step(double least) {
  constexpr std::array<double, 6> kSteps = {15, 30, 45, 90, 180, 360};
  if (least <= 10) {
    return round_step(least);
  }
  for (const double step : kSteps) {
    if (step >= least * (1 - kOnTick)) {
      return step;
    }
  }
  return 360 * std::ceil(round_step(least / 360));
}

constexpr std::array<const char*, 10> kRaisedDigits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

std::string raised(int number) {
  std::string text;
  for (const char c : std::to_string(number)) {
    text += c == '-' ? "⁻" : kRaisedDigits[c - '0'];
  }
  return text;
}

// A power of ten, a multiple of 3, that leaves numbers with few digits; 0 if they have few anyway.
int exponent_of(double largest) {
  const int exponent = largest > 0 ? static_cast<int>(std::floor(std::log10(largest) + kOnTick)) : 0;
  if (exponent < kLargestExponent && exponent > kSmallestExponent) {
    return 0;
  }
  return static_cast<int>(std::floor(exponent / 3.0)) * 3;
}

}  // namespace

std::string printed_number(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, std::max(decimals, 0));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  if (text == "-0") text = "0";
  return text.front() == '-' ? "−" + text.substr(1) : text;
}

std::string printed_significant(double value, int digits) {
  const std::string rounded = fmt::format("{:.{}e}", std::abs(value), digits - 1);
  const std::size_t split = rounded.find('e');
  const int exponent = std::stoi(rounded.substr(split + 1));
  const double size = std::stod(rounded);
  const std::string sign = value < 0 && size > 0 ? "−" : "";
  if (size > 0 && (exponent >= kLongestNumber || exponent < kSmallestNumber)) {
    return sign + fmt::format("{}·10{}", std::stod(rounded.substr(0, split)), raised(exponent));
  }
  return sign + fmt::format("{}", size);
}

std::string Ticks::label(double value) const {
  const double unit = std::pow(10, exponent);
  const int decimals = static_cast<int>(std::ceil(-std::log10(step / unit) - kOnTick));
  const std::string text = fmt::format("{:.{}f}", value / unit, std::clamp(decimals, 0, 15));
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return text.front() == '-' ? (zero ? "" : "−") + text.substr(1) : text;
}

Ticks make_ticks(double low, double high, std::string_view unit, int most) {
  Ticks ticks;
  ticks.low = low;
  ticks.high = high;
  const double least = (high - low) / most;
  ticks.step = unit == "deg" ? degree_step(least) : round_step(least);
  ticks.exponent = exponent_of(std::max(std::abs(low), std::abs(high)));
  const double first = std::ceil(low / ticks.step - kOnTick);
  const double last = std::floor(high / ticks.step + kOnTick);
  for (double k = first; k <= last; ++k) {
    ticks.values.push_back(k * ticks.step);
  }
  return ticks;
}

AxisRange padded_range(double lowest, double highest, double noise) {
  const double largest = std::max(std::abs(lowest), std::abs(highest));
  if (largest < std::max(noise, kLeastTickValue)) {
    return {-1, 1};
  }
  const double span = highest - lowest;
  if (span < kNoTickSpread * largest) {
    return {lowest - 0.5 * largest, highest + 0.5 * largest};
  }
  return {lowest - kValueMargin * span, highest + kValueMargin * span};
}

std::string printed_unit(std::string_view unit) {
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    int power = 0;
    const char* const rest = unit.data() + i + 1;
    const auto [end, status] = std::from_chars(rest, unit.data() + unit.size(), power);
    if (unit[i] == '^' && status == std::errc()) {
      text += raised(power);
      i += static_cast<std::size_t>(end - rest);
    } else {
      text += unit[i] == '*' ? "·" : std::string(1, unit[i]);
    }
  }
  return text == "1" ? "" : text;
}

std::string printed_unit(std::string_view unit, int exponent) {
  const std::string factor = exponent == 0 ? "" : "×10" + raised(exponent);
  const std::string name = printed_unit(unit);
  return factor + (factor.empty() || name.empty() ? "" : " ") + name;
}

}  // namespace higherpair
