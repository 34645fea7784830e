#include "higherpair/io/names.hpp"
#include "higherpair/io/units.hpp"
#include "higherpair/numeric/contains.hpp"
#include "numeric/decimal.hpp"
#include "unit_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <regex>
#include <string>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

using io_detail::DoubleDouble;
using io_detail::UnitFault;
using io_detail::UnitProduct;
using Refusal = tl::unexpected<std::string>;

constexpr int kLargestPower = 9;

// With force written as mass·length/time², so that both spellings compare equal.
Dimension without_force(Dimension dimension) {
  dimension.mass += dimension.force;
  dimension.length += dimension.force;
  dimension.time -= 2 * dimension.force;
  dimension.force = 0;
  return dimension;
}

// Units of pressure, in N/m².
constexpr std::pair<std::string_view, double> kPressures[] = {
    {"Pa", 1}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}};

// Signs used for units elsewhere, and how to write them here.
constexpr std::pair<std::string_view, std::string_view> kSigns[] = {
    {"°", "deg"}, {"·", "* or a space"}, {"×", "* or a space"}, {"²", "^2"}, {"³", "^3"}, {"⁻", "^-1"}};

// Takes the factors of "kg m^2/s" one by one from the front of its text.
class UnitParser {
public:
  explicit UnitParser(std::string_view text) : text_(text), rest_(io_detail::trimmed(text)) {}

  tl::expected<UnitProduct, UnitFault> parse() {
    while (!rest_.empty()) {
      if (auto done = take_operator(); !done) return fault(done.error());
      if (auto done = take_factor(); !done) return fault(done.error());
      rest_ = io_detail::trimmed(rest_);
    }
    return product_;
  }

private:
  using Step = tl::expected<void, std::string>;

  [[nodiscard]] tl::unexpected<UnitFault> fault(const std::string& message) const {
    const auto at = unknown_.empty() ? 0 : static_cast<std::size_t>(unknown_.data() - text_.data());
    return tl::unexpected(UnitFault{message, std::string(unknown_), at});
  }

  Step take_operator() {
    const bool is_first = !after_factor_;
    if (rest_.front() == '/') {
      if (divides_) return Refusal("has more than one `/`: factors after the first one all divide");
      divides_ = true;
    } else if (rest_.front() != '*') {
      return {};
    } else if (is_first) {
      return Refusal("has a `*` without a unit before it");
    }
    rest_ = io_detail::trimmed(rest_.substr(1));
    return {};
  }

  Step take_factor() {
    const std::string_view name = take_name();
    if (name.empty()) {
      for (const auto& [sign, spelled] : kSigns) {
        if (rest_.starts_with(sign)) {
          return Refusal(fmt::format("has the sign {}: write {}", sign, spelled));
        }
      }
      if (after_factor_ && rest_.size() > 1 && (rest_[0] == '.' || rest_[0] == '-') &&
          io_detail::is_letter(rest_[1])) {
        return Refusal(fmt::format("has `{}` between two units: write * or a space", rest_[0]));
      }
      const bool is_power = after_factor_ && rest_.find_first_of("-0123456789") == 0;
      return Refusal(rest_.empty() ? std::string("ends where a unit is expected")
                                   : fmt::format("has `{}` where a unit is expected{}", rest_,
                                                 is_power ? ": a power is written with ^, as in mm^2" : ""));
    }
    const auto power = take_power();
    if (!power) return Refusal(power.error());
    after_factor_ = true;
    return multiply(name, divides_ ? -*power : *power);
  }

  std::string_view take_name() {
    const bool is_micro = rest_.starts_with("µ") || rest_.starts_with("μ");  // of two bytes each
    const auto* end = std::find_if_not(rest_.begin() + (is_micro ? 2 : 0), rest_.end(), io_detail::is_letter);
    auto length = static_cast<std::size_t>(end - rest_.begin());
    // In "1/s" the 1 is a numerator without units.
    if (length == 0 && !after_factor_ && !divides_ && !rest_.empty() && rest_.front() == '1') {
      const std::string_view after = io_detail::trimmed(rest_.substr(1));
      length = after.empty() || after.front() == '/' ? 1 : 0;
    }
    const std::string_view name = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return name;
  }

  tl::expected<int, std::string> take_power() {
    if (rest_.empty() || rest_.front() != '^') {
      return 1;
    }
    rest_.remove_prefix(1);
    int power = 0;
    const auto [end, status] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), power);
    if (status != std::errc() || std::abs(power) > kLargestPower) {
      return Refusal(fmt::format("has a power that is no integer from -{0} to {0}", kLargestPower));
    }
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return power;
  }

  Step multiply(std::string_view name, int power) {
    if (name == "1") {
      return {};
    }
    if (name == "rpm") {
      product_ = times_power(times_power(product_, Unit::kRevolution, power), Unit::kMinute, -power);
      return {};
    }
    for (const auto& [pressure, size] : kPressures) {
      if (name == pressure) {
        multiply_pressure(size, power);
        return {};
      }
    }
    const auto unit = find_unit(name);
    if (!unit) {
      unknown_ = name;
      return Refusal(fmt::format("{} is no unit", name));
    }
    product_ = times_power(product_, *unit, power);
    return {};
  }

  void multiply_pressure(double size, int power) {
    product_ = times_power(times_power(product_, Unit::kNewton, power), Unit::kMetre, -2 * power);
    for (int i = 0; i < std::abs(power); ++i) {
      DoubleDouble& part = power > 0 ? product_.numerator : product_.denominator;
      part = part * DoubleDouble{size, 0};
    }
  }

  std::string_view text_;
  std::string_view rest_;
  std::string_view unknown_;  // a word that is no unit
  UnitProduct product_;
  bool divides_ = false;
  bool after_factor_ = false;
};

// The number that 1/4 in or 1 1/4 in is, with its unit; empty for all else. \param rest  what follows the
// number
std::string quotient_of(double number, std::string_view rest) {
  static const std::regex kQuotient(R"((?:\s+(\d{1,6}))?\s*/\s*(\d{1,6})\s*(.*))");
  std::cmatch match;
  if (!std::regex_match(rest.data(), rest.data() + rest.size(), match, kQuotient) || match[2] == "0") {
    return "";
  }
  const double divisor = std::stod(match[2].str());
  const double value = match[1].matched ? number + std::copysign(std::stod(match[1].str()) / divisor, number)
                                        : number / divisor;
  return fmt::format("{}{}{}", value, match[3].length() > 0 ? " " : "", match[3].str());
}

struct NumberAndRest {
  double number;
  std::string_view rest;
};

tl::expected<NumberAndRest, std::string> take_number(std::string_view text) {
  std::string_view digits = text;
  if (!digits.empty() && digits.front() == '+') {
    digits.remove_prefix(1);
    if (!digits.empty() && digits.front() == '-') {
      return Refusal("does not begin with a number");
    }
  }
  double number = 0;
  const auto [end, status] = read_decimal(digits.data(), digits.data() + digits.size(), number);
  if (status == std::errc::result_out_of_range) {
    return Refusal("has a number out of the range of a double");
  }
  if (status != std::errc()) {
    return Refusal("does not begin with a number");
  }
  if (!std::isfinite(number)) {
    return Refusal("must be a finite number");
  }
  const std::string_view rest = digits.substr(static_cast<std::size_t>(end - digits.data()));
  if (io_detail::trimmed(rest).find_first_of("0123456789,.'/") == 0) {
    const std::string advice = separator_advice(text);
    if (!advice.empty()) return Refusal(advice);
    const std::string quotient = quotient_of(number, rest);
    if (!quotient.empty()) return Refusal("nothing is worked out here: write " + quotient);
  }
  return NumberAndRest{number, rest};
}

std::string example(const Dimension& expected, const Units& units) {
  return fmt::format("expected {}, such as \"25.4 {}\"", describe(expected), unit_text(expected, units));
}

std::string other_dimension(std::string_view unit, const Dimension& found, const Dimension& expected,
                            const Units& units) {
  const bool counts_turns =
      expected == dimension::kAngularVelocity && found == dimension::kNumber / dimension::kTime;
  return fmt::format("{} is {}, expected {}, such as {}{}", unit, describe(found), describe(expected),
                     unit_text(expected, units), counts_turns ? " or rpm" : "");
}

}  // namespace

std::vector<std::string> io_detail::all_unit_names() {
  std::vector<std::string> names = {"rpm"};
  for (const auto& [name, size] : kPressures) {
    names.emplace_back(name);
  }
  for (int i = 0; i <= static_cast<int>(Unit::kPoundForce); ++i) {
    names.emplace_back(name_of(static_cast<Unit>(i)));
  }
  return names;
}

bool io_detail::is_unit_name(std::string_view name) {
  return contains(all_unit_names(), name);
}

bool io_detail::same_quantity(const Dimension& a, const Dimension& b) {
  return without_force(a) == without_force(b);
}

tl::expected<UnitProduct, UnitFault> io_detail::parse_unit(std::string_view text) {
  return UnitParser(text).parse();
}

tl::expected<io_detail::UnitScalings, std::string> io_detail::scalings_of(std::string_view unit,
                                                                          const Dimension& expected,
                                                                          const Units& units) {
  unit = trimmed(unit);
  if (unit.empty() && expected != dimension::kNumber) {
    return Refusal(fmt::format("has no unit; {}, or the number without quotes for {}",
                               example(expected, units), unit_text(expected, units)));
  }
  const auto product = parse_unit(unit);
  if (!product) {
    const UnitFault& fault = product.error();
    return Refusal(fmt::format("{}{}; {}", fault.message,
                               fault.unknown.empty() ? "" : unit_advice(unit, fault.unknown, expected),
                               example(expected, units)));
  }
  if (!same_quantity(product->dimension, expected)) {
    return Refusal(other_dimension(unit, product->dimension, expected, units));
  }
  return UnitScalings{scaling(*product, {}), scaling(*product, product_of(expected, units))};
}

tl::expected<Quantity, std::string> parse_quantity(std::string_view text, const Dimension& expected,
                                                   const Units& units) {
  const std::string plain = io_detail::with_plain_blanks(text);
  const auto number = take_number(io_detail::trimmed(plain));
  if (!number) {
    return Refusal(fmt::format("{}; {}", number.error(), example(expected, units)));
  }
  const auto scalings = io_detail::scalings_of(number->rest, expected, units);
  if (!scalings) {
    return Refusal(scalings.error());
  }
  const Quantity quantity = {number->number, scalings->to_si.apply(number->number),
                             scalings->to_profile.apply(number->number)};
  if (!std::isfinite(quantity.si) || !std::isfinite(quantity.profile)) {
    return Refusal("is out of the range of a double");
  }
  return quantity;
}

}  // namespace higherpair
