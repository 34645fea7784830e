#pragma once

#include "higherpair/geometry/arc_polyline.hpp"
#include "higherpair/io/units.hpp"

#include <string>
#include <vector>

namespace higherpair {

/// An outline and the name of its layer.
struct DxfOutline {
  std::string layer;  ///< letters, digits, - and _; cut off after 31, the limit of R12, and numbered (cam-2)
                      ///< if an outline before it has the same
  ArcPolyline line;   ///< in metres
};

/// An ASCII DXF of release 12, which needs neither handles nor objects and which every CAD program reads: a
/// POLYLINE with bulges for each outline, or a CIRCLE if its arcs form a whole circle, each on its layer. The
/// header gives the unit of the numbers ($INSUNITS, $MEASUREMENT); they are written with all digits of a
/// double. \param length  a unit of length
[[nodiscard]] std::string dxf_text(const std::vector<DxfOutline>& outlines, Unit length);

}  // namespace higherpair
