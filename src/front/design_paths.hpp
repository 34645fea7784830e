#pragma once

#include "design_placement.hpp"
#include "design_rows.hpp"

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// How far a point's path misses one of the points that it is to lead through.
struct PathMiss {
  Vector2d p_W = Vector2d::Zero();  ///< the place of the path that counts [m]
  Vector2d along =
      Vector2d::Zero();  ///< unit tangent there; 0: the place is a given row, or an end of the path
  double driver = 0;     ///< position of the driver there [rad or m]
  std::optional<std::size_t> row = std::nullopt;  ///< set: the place is this row
};

/// Where the path of a task comes nearest to its points, each of them: in its row if it is timed, else
/// wherever it comes by, in the order of the points if they have one. Places between rows are found to
/// rounding. Places are those of the path itself, also where it is free to be placed elsewhere; placement_of
/// says where it lies then. \param points  of the path in the rows \param timed_rows  of a timed path, of
/// each of its points
[[nodiscard]] std::vector<PathMiss> nearest_places(const DesignTask::PointPath& path, DesignRows& rows,
                                                   std::span<const Vector2d> points,
                                                   std::span<const std::size_t> timed_rows);

/// Of a timed path: x and y of each point less the place; else the distance, of places within the path with
/// the sign of the side on which the point lies. In units of the length `unit` [m].
[[nodiscard]] Eigen::VectorXd misses_of(const DesignTask::PointPath& path, std::span<const PathMiss> misses,
                                        double unit);

/// PathMiss::along of each.
[[nodiscard]] std::vector<Vector2d> tangents_of(std::span<const PathMiss> misses);

/// Of a free path: how it is placed.
[[nodiscard]] PathPlacement placement_of(const DesignTask::PointPath& path, std::span<const PathMiss> misses);

/// How many numbers misses_of gives.
[[nodiscard]] Eigen::Index miss_count(const DesignTask::PointPath& path);

}  // namespace higherpair
