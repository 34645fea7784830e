#pragma once

#include "design_paths.hpp"

#include <functional>
#include <span>
#include <vector>

namespace higherpair {

/// The same path with other target points.
[[nodiscard]] DesignTask::PointPath with_points(const DesignTask::PointPath& path,
                                                std::vector<Vector2d> points);

/// Fits a path without times to its target points by moving, turning and scaling it as far as it is free to
/// be, so that the sum of squared distances is least; returns its places nearest to the points. Stretches of
/// the path of all lengths are laid on the points first, and the best of them are refined by descent.
/// \param points  of the path in the rows \param loop  whether they are closed
/// \param rows_for, places_for  the rows, and the places, of the path nearest to points given in its own
/// frame
[[nodiscard]] std::vector<PathMiss> nearest_when_free(
    const DesignTask::PointPath& path, std::span<const Vector2d> points, bool loop,
    const std::function<std::vector<std::size_t>(const DesignTask::PointPath&)>& rows_for,
    const std::function<std::vector<PathMiss>(const DesignTask::PointPath&)>& places_for);

}  // namespace higherpair
