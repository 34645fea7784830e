#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <tl/expected.hpp>

namespace higherpair {

/// Why a round cutter cannot cut a flank.
struct CutterFault {
  enum class Kind {
    kHollow,    ///< the flank's concave radius is smaller than the cutter's: it would cut away more (gouge,
                ///< undercut)
    kNotch,     ///< a concave corner, which no round cutter can cut
    kCrossing,  ///< while cutting one part of the flank it would cut into another
  } kind = Kind::kHollow;
  Vector2d at_B = Vector2d::Zero();  ///< point of the flank, or where the path crosses itself
  double largest = 0;                ///< radius of the largest possible cutter [m]; kNotch: 0
};

/// Path of the centre of a round cutter, or roller, of this radius [m] that touches the flank throughout: the
/// flank's offset along its outward normals; around convex corners it is an arc. Where the flank is concave
/// with a radius of curvature not larger than the cutter's, the path has a cusp and turns back (but along a
/// concave arc of its own radius the cutter's centre rests, and its path has a notch). Where the path crosses
/// itself the cutter is too large as well (Rothbart, Cam Design Handbook, on undercutting). The largest
/// cutter is -1/κ at the place of least curvature, to within rounding, or found by bisection, to 1e-9 of the
/// radius, as the largest whose path does not cross itself (see find_self_crossing). \pre radius > 0
[[nodiscard]] tl::expected<Boundary, CutterFault> cutter_path(const Boundary& flank, double radius);

}  // namespace higherpair
