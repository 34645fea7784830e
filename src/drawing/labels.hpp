#pragma once

#include "higherpair/geometry/pose.hpp"

#include <string>
#include <vector>

namespace higherpair {

/// A name in a picture; coordinates in px, y down.
struct Label {
  std::string text;
  bool is_body = false;
  Vector2d at = Vector2d::Zero();      ///< what it names
  Vector2d away = Vector2d::Zero();    ///< preferred direction of the text; 0: none
  Vector2d placed = Vector2d::Zero();  ///< the result: middle of the text
  std::string role = "label";
  bool stays_close = false;  ///< farther away it would be mistaken for the label of something else
};

/// Places the labels so that they do not cover each other and, as far as there is room, no lines either. A
/// label for which there is no room is left out, and of several labels at one position only the first is
/// kept.
/// \param ink   points on the lines of the picture
/// \param size  of the picture [px]
void place_labels(std::vector<Label>& labels, const std::vector<Vector2d>& ink, const Vector2d& size,
                  double font);

}  // namespace higherpair
