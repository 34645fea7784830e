#pragma once

#include "design_placement.hpp"
#include "design_rows.hpp"

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// How far a point's path misses one of its target points.
struct PathMiss {
  Vector2d p_W = Vector2d::Zero();  ///< the place on the path that is compared with the target [m]
  Vector2d along =
      Vector2d::Zero();  ///< unit tangent there; 0: the place is a given row, or an end of the path
  double driver = 0;     ///< position of the driver there [rad or m]
  std::optional<std::size_t> row = std::nullopt;  ///< set: the place is this row

  /// Targets that would be nearest to the path in another order share a place: one of them stands for all,
  /// with the distance of their mean; the others have a distance that does not depend on the path.
  struct Shared {
    Vector2d center = Vector2d::Zero();  ///< mean of the targets [m]
    double factor = 0;                   ///< on the distance of the mean; 0: of the others
    double rest = 0;                     ///< distance of the others [m]
  };
  std::optional<Shared> shared = std::nullopt;

  [[nodiscard]] const Vector2d& compared_with(const Vector2d& target) const {
    return shared ? shared->center : target;
  }
};

/// The place of the path nearest to each of its target points: in the given row if the path is timed, else
/// anywhere on the path, in the order of the points if they have one. Places between rows are found to within
/// rounding. They are places of the path itself even where it is free to be placed elsewhere; placement_of
/// gives its placement. \param points  of the path in the rows \param timed_rows  for a timed path, the row
/// of each of its points
[[nodiscard]] std::vector<PathMiss> nearest_places(const DesignTask::PointPath& path, DesignRows& rows,
                                                   std::span<const Vector2d> points,
                                                   std::span<const std::size_t> timed_rows);

/// For a timed path: x and y of each place less its target point; else the distance, for places inside the
/// path signed by the side on which the target lies. In units of the length `unit` [m].
[[nodiscard]] Eigen::VectorXd misses_of(const DesignTask::PointPath& path, std::span<const PathMiss> misses,
                                        double unit);

/// PathMiss::along of each.
[[nodiscard]] std::vector<Vector2d> tangents_of(std::span<const PathMiss> misses);

/// The placement of a free path.
[[nodiscard]] PathPlacement placement_of(const DesignTask::PointPath& path, std::span<const PathMiss> misses);

/// Number of values that misses_of returns.
[[nodiscard]] Eigen::Index miss_count(const DesignTask::PointPath& path);

}  // namespace higherpair
