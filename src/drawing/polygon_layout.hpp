#pragma once

#include "higherpair/drawing/picture.hpp"

#include <string>
#include <utility>
#include <vector>

namespace higherpair {

inline constexpr double kPolygonFont = 12;    // [px], as all lengths here
inline constexpr double kPolygonLine = 18;    // from one line of text to the next
inline constexpr double kPolygonMargin = 16;  // around the picture
inline constexpr double kPolygonAround = 34;  // around a polygon, for labels
inline constexpr double kDrawnShare = 0.58;   // fraction of the width taken by the drawn part

/// The position of a polygon in the picture [px].
struct PolygonLayout {
  const Polygon* polygon = nullptr;
  double width = 0;  ///< of the picture
  double top = 0;
  double longest = 0;                  ///< longest arrow, in the polygon's unit
  int exponent = 0;                    ///< values are shown divided by 10^exponent
  double scale = 1;                    ///< px per unit
  Vector2d origin = Vector2d::Zero();  ///< position of the pole
  /// All arrows are on one line and would cover each other: they are drawn side by side.
  bool flat = false;
  std::vector<std::pair<Vector2d, Vector2d>> ends;  ///< of the arrows
  double bottom = 0;                                ///< of the drawn part

  [[nodiscard]] Vector2d px(const Vector2d& p) const {
    return {origin.x() + scale * p.x(), origin.y() - scale * p.y()};
  }
  /// Whether an arrow is long enough to have a name beside it.
  [[nodiscard]] bool is_long(std::size_t arrow) const;
  /// "×10³ cm/s²"
  [[nodiscard]] std::string unit() const;
};

[[nodiscard]] PolygonLayout lay_out(const Polygon& polygon, double width, double top);

/// A name beside a point or an arrow.
struct PolygonLabel {
  std::string text;  ///< with `_{…}` and `^{…}`
  bool is_point = false;
  Vector2d names = Vector2d::Zero();  ///< position of the point or arrow that it names
  Vector2d at = Vector2d::Zero();     ///< left end of its baseline
  double width = 0;
  bool far = false;  ///< a line joins it to what it names
};

/// The labels for which there is room. Points have priority over arrows; coinciding points share a label.
[[nodiscard]] std::vector<PolygonLabel> place_polygon_labels(const PolygonLayout& layout);

}  // namespace higherpair
