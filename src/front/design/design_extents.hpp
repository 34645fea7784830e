#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/io/design_task.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <vector>

namespace higherpair {

/// The row in which a term of an extent, its reach along one direction, is largest.
struct ExtentTerm {
  Vector2d direction_W = Vector2d::Zero();  ///< zero for a reach, which has no direction
  double far = -kInf;                       ///< [m]
  std::size_t row = 0;
};

/// The terms that an extent is the sum of, or the larger of two sums; no row has been considered yet.
[[nodiscard]] std::vector<ExtentTerm> terms_of(const DesignTask::Extent& extent);

/// How far the bodies of an extent reach along a direction [m], over their points, circles, ellipses and
/// boundaries; for zero direction, the distance between the two points of the extent.
[[nodiscard]] double far_along(const DesignTask::Extent& extent, const Vector2d& direction_W,
                               const Mechanism& mechanism, const std::vector<BodyMotion>& bodies);

/// Those of all terms whose sum is the extent.
[[nodiscard]] std::vector<ExtentTerm> terms_that_count(const DesignTask::Extent& extent,
                                                       const std::vector<ExtentTerm>& terms);

}  // namespace higherpair
