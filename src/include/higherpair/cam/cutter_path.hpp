#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <tl/expected.hpp>

namespace higherpair {

/// Why a round cutter cannot cut a flank.
struct CutterFault {
  enum class Kind {
    kHollow,    ///< the flank is hollower than the cutter is round: it would cut away more (gouge, undercut)
    kNotch,     ///< a hollow corner, which no round cutter can cut
    kCrossing,  ///< while it cuts one part of the flank it would cut into another
  } kind = Kind::kHollow;
  Vector2d at_B = Vector2d::Zero();  ///< point of the flank, or where the path crosses itself
  double largest = 0;                ///< radius of the largest cutter that can [m]; kNotch: 0
};

/// Path of the centre of a round cutter, or roller, of this radius [m] that touches the flank throughout: the
/// flank's offset along its outward normals. Where the flank's radius of curvature is hollow and not larger
/// than the cutter's the path has a cusp and turns back (but about a hollow arc of its own radius the cutter
/// waits, and its path has a notch); where the path crosses itself the cutter is too
/// large as well (Rothbart, Cam Design Handbook, on undercutting). Around convex corners it is an arc. The
/// largest cutter is -1/κ at the hollowest place, to within rounding, or by bisection to 1e-9 of the radius
/// what just does not make the path cross itself (see find_self_crossing). \pre radius > 0
[[nodiscard]] tl::expected<Boundary, CutterFault> cutter_path(const Boundary& flank, double radius);

/// The place of least signed curvature of a boundary's spans but corners, to within rounding of the zero of
/// dκ/ds between four times as many places as show the shape. None of corners alone.
struct HollowestPlace {
  BoundaryPlace place;
  SpanPoint point;
};
[[nodiscard]] HollowestPlace hollowest_place(const Boundary& boundary);

}  // namespace higherpair
