#pragma once

#include "higherpair/geometry/pose.hpp"

#include <string>
#include <vector>

namespace higherpair {

/// A name in a picture; px, y down.
struct Label {
  std::string text;
  bool is_body = false;
  Vector2d at = Vector2d::Zero();      ///< what it names
  Vector2d away = Vector2d::Zero();    ///< direction in which it is best off; 0: none
  Vector2d placed = Vector2d::Zero();  ///< middle of the text: the result
  std::string role = "label";
  bool stays_close = false;  ///< would be taken for that of something else farther away
};

/// Places the labels so that they cover neither each other nor, as far as there is room, any of the points.
/// Of labels at one place the first stays.
/// \param ink  points on the lines of the picture  \param size  of the picture [px]
void place_labels(std::vector<Label>& labels, const std::vector<Vector2d>& ink, const Vector2d& size,
                  double font);

}  // namespace higherpair
