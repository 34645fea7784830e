#pragma once

#include "higherpair/drawing/picture.hpp"
#include "higherpair/io/units.hpp"

#include <vector>

namespace higherpair {

/// Converts polygons from SI units to those of tables.
void to_units(std::vector<Polygon>& polygons, const Units& units);

}  // namespace higherpair
