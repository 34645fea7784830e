#pragma once

#include "higherpair/geometry/arc_polyline.hpp"
#include "higherpair/io/units.hpp"

#include <string>
#include <vector>

namespace higherpair {

/// What is drawn on one layer.
struct DxfOutline {
  std::string layer;  ///< letters, digits, - and _; R12 knows 31 of them, what is beyond is cut off
  ArcPolyline line;   ///< in metres
};

/// An ASCII DXF of release 12, which needs neither handles nor objects and which every CAD program reads: a
/// POLYLINE with bulges for each outline, a CIRCLE where that is a whole circle of arcs, each on its layer.
/// The header says in which unit the numbers are ($INSUNITS, $MEASUREMENT); they are written with all digits
/// that a double has. \param length  a unit of length
[[nodiscard]] std::string dxf_text(const std::vector<DxfOutline>& outlines, Unit length);

}  // namespace higherpair
