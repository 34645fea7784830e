#pragma once

#include "double_double.hpp"
#include "higherpair/io/units.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair::io_detail {

/// A product of units: its size in SI units is numerator/denominator, both exact unless π is a factor.
struct UnitProduct {
  DoubleDouble numerator = {1, 0};
  DoubleDouble denominator = {1, 0};
  Dimension dimension;
};

/// `product` times the unit to an integer power.
[[nodiscard]] UnitProduct times_power(const UnitProduct& product, Unit unit, int exponent);

/// The unit of a dimension in the given base units.
[[nodiscard]] UnitProduct product_of(const Dimension& dimension, const Units& units);

/// What is wrong with a unit.
struct UnitFault {
  std::string message;
  std::string unknown;  ///< the word that is no unit, if that is what is wrong
  std::size_t at = 0;   ///< where that begins
};

/// The unit that a text names, "kg m^2/s".
[[nodiscard]] tl::expected<UnitProduct, UnitFault> parse_unit(std::string_view text);

/// Whether both are one quantity, a force as such or as mass·length/time².
[[nodiscard]] bool same_quantity(const Dimension& a, const Dimension& b);

/// How numbers in one unit become SI units, and units of the profile.
struct UnitScalings {
  Scaling to_si;
  Scaling to_profile;
};

/// Of a unit as a text, which must be one of the dimension `expected`.
[[nodiscard]] tl::expected<UnitScalings, std::string> scalings_of(std::string_view unit,
                                                                  const Dimension& expected,
                                                                  const Units& units);

/// The units that a quantity may have: those of profiles, rpm, and the units of pressure.
[[nodiscard]] std::vector<std::string> all_unit_names();
[[nodiscard]] bool is_unit_name(std::string_view name);

/// What to write instead of a word that is no unit: ": write rev/s", " (did you mean `N m`?)", or which units
/// there are of a length. Only of what is expected; empty if that is not clear.
/// \param text     the whole unit, "Nm/deg"
/// \param unknown  the word in it, "Nm"
[[nodiscard]] std::string unit_advice(std::string_view text, std::string_view unknown,
                                      const Dimension& expected);

/// What to say of lists and lines with twice as many numbers as expected.
inline constexpr const char* kPointNotComma = ": decimals are written with a point, not a comma";

/// The factor from multiples of `from` to multiples of `to`.
[[nodiscard]] Scaling scaling(const UnitProduct& from, const UnitProduct& to);

}  // namespace higherpair::io_detail
