#pragma once

#include "higherpair/io/units.hpp"

#include <string>
#include <vector>

namespace higherpair {

/// A unit that numbers may be in by mistake.
struct OtherUnit {
  std::string unit;
  double factor = 1;  ///< from it to the one that is meant
};

/// A unit of tables with another base unit in the place of one of its own: "rad/s" of "deg/s".
[[nodiscard]] std::vector<OtherUnit> other_units(const std::string& unit, const Units& units);

}  // namespace higherpair
