#pragma once

#include "higherpair/io/design_task.hpp"

#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// The first row from which the driver turns back by more than rounding; none where it goes one way.
[[nodiscard]] std::optional<std::size_t> turning_row(std::span<const double> positions);

/// Whether the driver goes one way around a closed path, which may then begin anywhere.
/// \param points  of the path in the rows \param at  positions of the driver
[[nodiscard]] bool goes_around(const DesignTask::PointPath& path, std::span<const Vector2d> points,
                               const std::vector<double>& at);

/// The row nearest to each target point of a path: in the order of the targets if they have one, then with
/// the least sum of squared distances.
[[nodiscard]] std::vector<std::size_t> nearest_rows(const DesignTask::PointPath& path,
                                                    std::span<const Vector2d> points,
                                                    const std::vector<double>& at);

}  // namespace higherpair
