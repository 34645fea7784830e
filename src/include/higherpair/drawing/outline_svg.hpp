#pragma once

#include "higherpair/drawing/picture.hpp"
#include "higherpair/geometry/arc_polyline.hpp"

#include <string>
#include <vector>

namespace higherpair {

struct NamedOutline {
  std::string name;
  ArcPolyline line;  ///< in metres
};

/// Outlines at their true size (96 px to the inch, as in CSS and drawing programs) as an SVG picture, with a
/// cross at the origin of their frame if that is within the picture. Elements carry data-role (`outline`,
/// `origin`) and data-name, the top element data-scale (px per unit) and data-origin ("x y" in px, y up).
/// \pre at least one outline, each with two vertices
[[nodiscard]] std::string outline_svg(const std::vector<NamedOutline>& outlines, const std::string& title,
                                      const PictureUnit& length);

}  // namespace higherpair
