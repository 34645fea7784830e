#pragma once

#include "higherpair/io/units.hpp"

#include <string>
#include <vector>

namespace higherpair {

/// A unit in which numbers may have been given by mistake.
struct OtherUnit {
  std::string unit;
  double factor = 1;  ///< from it to the intended unit
};

/// The variants of a unit of tables in which one of its base units is replaced: "rad/s" for "deg/s".
[[nodiscard]] std::vector<OtherUnit> other_units(const std::string& unit, const Units& units);

}  // namespace higherpair
