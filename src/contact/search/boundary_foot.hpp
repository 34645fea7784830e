#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <optional>

namespace higherpair {

/// The foot of the perpendicular from a point to a boundary, by Newton's method from a place near it; at a
/// concave corner in the way, that corner; none where an end of the boundary is in the way.
/// \param near  largest distance of the point from the foot's normal, relative to the boundary's size
[[nodiscard]] std::optional<BoundaryPlace> foot_near(const Boundary& boundary, const Vector2d& p_B,
                                                     BoundaryPlace place, double near);

}  // namespace higherpair
