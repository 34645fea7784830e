#pragma once

#include "double_double.hpp"
#include "higherpair/io/units.hpp"

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

/// The factor from multiples of `from` to multiples of `to`.
[[nodiscard]] Scaling scaling(const UnitProduct& from, const UnitProduct& to);

}  // namespace higherpair::io_detail
