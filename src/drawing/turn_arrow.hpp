#pragma once

#include "higherpair/geometry/pose.hpp"

#include <vector>

namespace higherpair {

/// An arrow round a centre, as of a torque or of a turning body: counter-clockwise if `turn` > 0.
struct TurnArrow {
  Vector2d center = Vector2d::Zero();
  double radius = 1;
  double from = 0;  ///< angle at which it begins [rad]
  double turn = 0;  ///< [rad]
};

/// The points of its arc, and the corners of its head, which is at most `longest` long.
[[nodiscard]] std::vector<double> arc_of(const TurnArrow& arrow);
[[nodiscard]] std::vector<double> head_of(const TurnArrow& arrow, double longest);

}  // namespace higherpair
