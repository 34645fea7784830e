#pragma once

#include <string>
#include <vector>

namespace higherpair {

/// How a body, or a point or curve of it, is drawn where not as usual.
struct Look {
  std::string name;      ///< in the picture; empty: its own
  std::string colour;    ///< "#rrggbb" or "#rgb": what fills it, of a point its trace; empty: the usual one
  bool hide = false;     ///< not drawn; a point's name and trace
  bool outline = false;  ///< a line, not filled
};

struct BodyLook {
  Look body;
  std::vector<Look> points;  ///< of Body::points
  std::vector<Look> curves;  ///< of Body::curves
};

/// Of Mechanism::bodies; empty: all are drawn as usual.
using Looks = std::vector<BodyLook>;

}  // namespace higherpair
