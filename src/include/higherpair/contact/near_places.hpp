#pragma once

#include "higherpair/contact/common_normal.hpp"
#include "higherpair/geometry/boundary.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// Where two boundaries are nearest to each other, or deepest in each other, among the places around: at a
/// common normal, or where an end of an open boundary is opposite the other one. An end that is an edge does
/// so only with normals that are not on it.
struct NearPlace {
  CommonNormal at;  ///< ρ: of a face +∞, of a corner or an end 0
  BoundaryPlace place1, place2;
  int end = 0;  ///< 1, 2: this boundary's place is an end; 0: none is, the normal is common
};

/// All such places at which the boundaries are no farther than `reach` [m] from touching, or in each other by
/// no more than that. A common normal counts where the gap g along it is a least one: κ1 + κ2 + g κ1 κ2 > 0.
/// Pieces between neighbouring samples of both boundaries are compared in blocks (distance, opposed normals),
/// those that may hold a common normal are refined by Newton's method: two places closer to each other than
/// the samples may be taken as one.
[[nodiscard]] std::vector<NearPlace> near_places(const Boundary& boundary1, const Pose<double>& X_W1,
                                                 const Boundary& boundary2, const Pose<double>& X_W2,
                                                 double reach);

/// The same place after the bodies have moved a little; none where it cannot be followed, or is no longer a
/// least gap.
[[nodiscard]] std::optional<NearPlace> moved_place(const Boundary& boundary1, const Pose<double>& X_W1,
                                                   const Boundary& boundary2, const Pose<double>& X_W2,
                                                   const NearPlace& before);

}  // namespace higherpair
