#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/io/design_task.hpp"

#include <limits>
#include <vector>

namespace higherpair {

/// The row in which an extent is largest along one direction.
struct ExtentTerm {
  Vector2d direction_W = Vector2d::Zero();                ///< 0: of a reach, which has none
  double far = -std::numeric_limits<double>::infinity();  ///< [m]
  std::size_t row = 0;
};

/// Those that an extent is the sum of, or of which the larger sum counts; nothing is known of rows yet.
[[nodiscard]] std::vector<ExtentTerm> terms_of(const DesignTask::Extent& extent);

/// How far the bodies of an extent come along a direction, or its point from the other one, where they are
/// [m]: points, circles and ellipses, and boundaries.
[[nodiscard]] double far_along(const DesignTask::Extent& extent, const Vector2d& direction_W,
                               const Mechanism& mechanism, const std::vector<BodyMotion>& bodies);

/// Those of all terms that the extent is the sum of.
[[nodiscard]] std::vector<ExtentTerm> terms_that_count(const DesignTask::Extent& extent,
                                                       const std::vector<ExtentTerm>& terms);

}  // namespace higherpair
