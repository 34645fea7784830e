#pragma once

#include "text_layout.hpp"

#include <vector>

namespace higherpair {

/// A point on the screen and the text beside it [px].
struct LabelledPoint {
  double x = 0;
  double y = 0;
  double width = 0;    ///< of the text
  TextBox box;         ///< the result: where the text goes
  bool far = false;    ///< too far from the point to be read as its label: a line has to join them
  bool shown = false;  ///< false: no room was found, or the text is empty
};

/// Finds a position within `frame` for every text, where it covers no other text, no point and none of
/// `taken`.
void place_labels(std::vector<LabelledPoint>& points, const TextBox& frame,
                  const std::vector<TextBox>& taken = {});

}  // namespace higherpair
