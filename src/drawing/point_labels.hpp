#pragma once

#include "text_layout.hpp"

#include <vector>

namespace higherpair {

/// A point on the screen and the text beside it [px].
struct LabelledPoint {
  double x = 0;
  double y = 0;
  double width = 0;    ///< of the text
  TextBox box;         ///< where the text goes
  bool far = false;    ///< not beside the point: a line is needed
  bool shown = false;  ///< false: no room was found, or the text is empty
};

/// Finds a place for every text within `frame` in which it covers no other text, no point and nothing of
/// `taken`.
void place_labels(std::vector<LabelledPoint>& points, const TextBox& frame,
                  const std::vector<TextBox>& taken = {});

}  // namespace higherpair
