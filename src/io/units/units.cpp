#include "higherpair/io/units.hpp"

#include "unit_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <fmt/core.h>

namespace higherpair {
namespace {

using io_detail::DoubleDouble;

constexpr DoubleDouble kPrecisePi = {3.141592653589793116, 1.2246467991473532e-16};

// Every unit is numerator/denominator of the SI unit, times π for angles that need it; all these integers are
// exact as doubles.
struct UnitRow {
  Unit unit;
  std::string_view name;
  Dimension dimension;
  double numerator;
  double denominator;
  bool times_pi = false;
};

constexpr std::array<UnitRow, 19> kUnitTable = {{
    {Unit::kMetre, "m", dimension::kLength, 1, 1},
    {Unit::kCentimetre, "cm", dimension::kLength, 1, 100},
    {Unit::kMillimetre, "mm", dimension::kLength, 1, 1000},
    {Unit::kMicrometre, "um", dimension::kLength, 1, 1'000'000},
    {Unit::kKilometre, "km", dimension::kLength, 1000, 1},
    {Unit::kInch, "in", dimension::kLength, 254, 10'000},
    {Unit::kFoot, "ft", dimension::kLength, 3048, 10'000},
    {Unit::kDegree, "deg", dimension::kAngle, 1, 180, true},
    {Unit::kRadian, "rad", dimension::kAngle, 1, 1},
    {Unit::kRevolution, "rev", dimension::kAngle, 2, 1, true},
    {Unit::kKilogram, "kg", dimension::kMass, 1, 1},
    {Unit::kGram, "g", dimension::kMass, 1, 1000},
    {Unit::kPound, "lb", dimension::kMass, 45'359'237, 100'000'000},
    {Unit::kSecond, "s", dimension::kTime, 1, 1},
    {Unit::kMillisecond, "ms", dimension::kTime, 1, 1000},
    {Unit::kMinute, "min", dimension::kTime, 60, 1},
    {Unit::kNewton, "N", dimension::kForce, 1, 1},
    {Unit::kKilonewton, "kN", dimension::kForce, 1000, 1},
    {Unit::kPoundForce, "lbf", dimension::kForce, 44'482'216'152'605, 10'000'000'000'000},
}};

constexpr bool units_follow_the_enum() {
  for (std::size_t i = 0; i < kUnitTable.size(); ++i) {
    if (static_cast<std::size_t>(kUnitTable[i].unit) != i) return false;
  }
  return true;
}
static_assert(units_follow_the_enum());

const UnitRow& row_of(Unit unit) {
  return kUnitTable[static_cast<std::size_t>(unit)];
}

struct NamedDimension {
  Dimension dimension;
  std::string_view words;
};

constexpr std::array<NamedDimension, 18> kDimensionNames = {{
    {dimension::kNumber, "a pure number"},
    {dimension::kLength, "a length"},
    {dimension::kAngle, "an angle"},
    {dimension::kMass, "a mass"},
    {dimension::kTime, "a time"},
    {dimension::kForce, "a force"},
    {dimension::kVelocity, "a velocity"},
    {dimension::kAcceleration, "an acceleration"},
    {dimension::kAngularVelocity, "an angular velocity"},
    {dimension::kAngularAcceleration, "an angular acceleration"},
    {dimension::kTorque, "a torque"},
    {dimension::kInertia, "a moment of inertia"},
    {dimension::kStiffness, "a stiffness"},
    {dimension::kAngularStiffness, "an angular stiffness"},
    {dimension::kDamping, "a damping"},
    {dimension::kAngularDamping, "an angular damping"},
    {dimension::kNumber / dimension::kLength, "a curvature"},
    {dimension::kForce / (dimension::kLength * dimension::kLength), "a pressure"},
}};

struct BasePower {
  Unit unit;
  int exponent;
};

// Base units in the order in which they are written: N*mm, kg*mm^2, deg/s.
std::array<BasePower, 5> base_powers(const Dimension& dimension, const Units& units) {
  return {{{units.force, dimension.force},
           {units.mass, dimension.mass},
           {units.length, dimension.length},
           {units.angle, dimension.angle},
           {units.time, dimension.time}}};
}

std::string factors_text(const std::array<BasePower, 5>& powers, int sign) {
  std::string text;
  for (const BasePower& power : powers) {
    const int exponent = sign * power.exponent;
    if (exponent <= 0) {
      continue;
    }
    text += fmt::format("{}{}", text.empty() ? "" : "*", name_of(power.unit));
    if (exponent > 1) {
      text += fmt::format("^{}", exponent);
    }
  }
  return text;
}

}  // namespace

namespace io_detail {

UnitProduct times_power(const UnitProduct& product, Unit unit, int exponent) {
  const UnitRow& row = row_of(unit);
  UnitProduct result = product;
  DoubleDouble& above = exponent > 0 ? result.numerator : result.denominator;
  DoubleDouble& below = exponent > 0 ? result.denominator : result.numerator;
  for (int i = 0; i < std::abs(exponent); ++i) {
    above = above * DoubleDouble{row.numerator, 0};
    below = below * DoubleDouble{row.denominator, 0};
    if (row.times_pi) {
      above = above * kPrecisePi;
    }
    result.dimension = exponent > 0 ? result.dimension * row.dimension : result.dimension / row.dimension;
  }
  return result;
}

UnitProduct product_of(const Dimension& dimension, const Units& units) {
  UnitProduct product;
  for (const BasePower& power : base_powers(dimension, units)) {
    product = times_power(product, power.unit, power.exponent);
  }
  return product;
}

Scaling scaling(const UnitProduct& from, const UnitProduct& to) {
  const DoubleDouble factor = (from.numerator * to.denominator) / (from.denominator * to.numerator);
  return {factor.high, factor.low};
}

}  // namespace io_detail

namespace {

// Whether the parts of the number and their products are far from overflow and underflow.
bool is_splittable(double value) {
  return std::abs(value) > 0x1p-400 && std::abs(value) < 0x1p400;
}

// ab - product, exactly, by Dekker's splitting into halves of 26 bits. It is used instead of std::fma, which
// is a function call on target processors without such an instruction.
double error_of_product(double a, double b, double product) {
  const auto upper_half = [](double x) {
    const double shifted = 0x1.0000002p27 * x;
    return shifted - (shifted - x);
  };
  const double a_high = upper_half(a);
  const double b_high = upper_half(b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

}  // namespace

double Scaling::apply(double value) const {
  const double product = value * high_;
  if (low_ == 0 || !std::isfinite(product)) {
    return product;
  }
  const double error = is_splittable(value) && is_splittable(high_) ? error_of_product(value, high_, product)
                                                                    : std::fma(value, high_, -product);
  return product + (value * low_ + error);
}

Scaling to_si(const Dimension& dimension, const Units& units) {
  return io_detail::scaling(io_detail::product_of(dimension, units), {});
}

Scaling from_si(const Dimension& dimension, const Units& units) {
  return io_detail::scaling({}, io_detail::product_of(dimension, units));
}

std::string_view name_of(Unit unit) {
  return row_of(unit).name;
}

Dimension dimension_of(Unit unit) {
  return row_of(unit).dimension;
}

std::optional<Unit> find_unit(std::string_view name) {
  const auto* row = std::find_if(kUnitTable.begin(), kUnitTable.end(),
                                 [&](const UnitRow& candidate) { return candidate.name == name; });
  return row == kUnitTable.end() ? std::nullopt : std::optional(row->unit);
}

std::string unit_text(const Dimension& dimension, const Units& units) {
  const auto powers = base_powers(dimension, units);
  const std::string above = factors_text(powers, 1);
  const std::string below = factors_text(powers, -1);
  return fmt::format("{}{}{}", above.empty() ? "1" : above, below.empty() ? "" : "/", below);
}

std::string unit_per(const std::string& quantity, const std::string& other) {
  if (other == "1") {
    return quantity;
  }
  const bool compound = other.find_first_of("/*") != std::string::npos;
  return compound ? fmt::format("{}/({})", quantity, other) : fmt::format("{}/{}", quantity, other);
}

std::string with_unit(double si, const Dimension& dimension, const Units& units, int digits) {
  return fmt::format("{:.{}g} {}", from_si(dimension, units).apply(si), digits, unit_text(dimension, units));
}

std::string describe(const Dimension& dimension) {
  for (const NamedDimension& named : kDimensionNames) {
    if (named.dimension == dimension) {
      return std::string(named.words);
    }
  }
  return "a quantity in " + unit_text(dimension, Units{});
}

}  // namespace higherpair
