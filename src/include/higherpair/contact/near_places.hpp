#pragma once

#include "higherpair/contact/common_normal.hpp"
#include "higherpair/geometry/boundary.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// A local minimum of the distance of two boundaries, or a local maximum of their overlap: at a common
/// normal, or where an end of an open boundary is opposite the other one. For an end with an edge only
/// normals that do not belong to the edge count as the latter.
struct NearPlace {
  CommonNormal at;  ///< ρ: +∞ on a face, 0 at a corner or an end
  BoundaryPlace place1, place2;
  int end = 0;  ///< 1, 2: the place on this boundary is an end; 0: neither is, the normal is common
};

/// All such places at which the boundaries are at most `reach` [m] apart or overlap by at most that. A common
/// normal counts where the gap g along it is a minimum: κ1 + κ2 + g κ1 κ2 > 0. Pieces between neighbouring
/// samples of both boundaries are compared in blocks (distance, opposed normals), and those that may hold a
/// common normal are refined by Newton's method: two places closer to each other than the samples may be
/// reported as one.
[[nodiscard]] std::vector<NearPlace> near_places(const Boundary& boundary1, const Pose<double>& X_W1,
                                                 const Boundary& boundary2, const Pose<double>& X_W2,
                                                 double reach);

/// The same place after the bodies have moved a little; none where it cannot be followed, or is not a minimum
/// of the gap any more.
[[nodiscard]] std::optional<NearPlace> moved_place(const Boundary& boundary1, const Pose<double>& X_W1,
                                                   const Boundary& boundary2, const Pose<double>& X_W2,
                                                   const NearPlace& before);

}  // namespace higherpair
