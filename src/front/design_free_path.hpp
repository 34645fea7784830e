#pragma once

#include "design_paths.hpp"

#include <functional>
#include <span>
#include <vector>

namespace higherpair {

/// The same path with other points.
[[nodiscard]] DesignTask::PointPath with_points(const DesignTask::PointPath& path,
                                                std::vector<Vector2d> points);

/// Where a path without times comes nearest to its points when it is moved, turned and scaled as far as it is
/// free to be, and how it is placed then: the least sum of squared distances. Stretches of the path of every
/// length are laid on the points first, the best of them followed downhill.
/// \param points  of the path in the rows \param loop  whether they are closed
/// \param rows_for, places_for  the rows and the places of the path that are nearest to points in its own
/// frame
[[nodiscard]] std::vector<PathMiss> nearest_when_free(
    const DesignTask::PointPath& path, std::span<const Vector2d> points, bool loop,
    const std::function<std::vector<std::size_t>(const DesignTask::PointPath&)>& rows_for,
    const std::function<std::vector<PathMiss>(const DesignTask::PointPath&)>& places_for);

}  // namespace higherpair
