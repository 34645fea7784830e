#pragma once

#include "plot_layout.hpp"
#include "svg_writer.hpp"

#include <string>
#include <vector>

namespace higherpair {

struct Stroke {
  std::string color;
  std::string dash;
  double width = 1.7;  ///< [px]
};

/// The stroke of a series, which distinguishes it from the others of its panel in black and white as well.
[[nodiscard]] Stroke stroke_of(const PlotPanel& panel, const PlotSeries& series);

/// A series as a path on the screen. Points that coincide there are left out, except the ends of a piece; an
/// isolated point becomes a line without length.
[[nodiscard]] SvgPath path_of(const PlotSeries& series, const PlotScale& x, const PlotScale& y);

/// The isolated points of a series on the screen [px]: no line leads to them, so that they need a dot.
[[nodiscard]] std::vector<Vector2d> isolated_points(const PlotSeries& series, const PlotScale& x,
                                                    const PlotScale& y);

/// Boxes along the lines of a panel, for labels to keep clear of.
[[nodiscard]] std::vector<TextBox> ink_of(const PlotPanel& panel, const PlotScale& x);

}  // namespace higherpair
