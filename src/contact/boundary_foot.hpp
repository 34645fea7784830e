#pragma once

#include "higherpair/geometry/boundary.hpp"

#include <optional>

namespace higherpair {

/// The place of a boundary in front of which a point is, on its normal, by Newton's method from a place near
/// it; none where an end or a concave corner is in the way. \param near  how far beside that normal the point
/// may be, of the boundary's size
[[nodiscard]] std::optional<BoundaryPlace> foot_near(const Boundary& boundary, const Vector2d& p_B,
                                                     BoundaryPlace place, double near);

}  // namespace higherpair
