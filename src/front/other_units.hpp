#pragma once

#include "higherpair/io/units.hpp"

#include <optional>
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

/// The variant for which `misfit` returns the least value; none if that is not below `least`.
template <class Misfit>
[[nodiscard]] std::optional<OtherUnit> best_unit(const std::string& unit, const Units& units, double least,
                                                 Misfit misfit) {
  std::optional<OtherUnit> best;
  for (const OtherUnit& other : other_units(unit, units)) {
    const double there = misfit(other);
    if (!(there < least)) continue;
    least = there;
    best = other;
  }
  return best;
}

}  // namespace higherpair
