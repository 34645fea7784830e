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
/// isolated point becomes a short line.
[[nodiscard]] SvgPath path_of(const PlotSeries& series, const PlotScale& x, const PlotScale& y);

/// Boxes along the lines of a panel, for labels to keep clear of.
[[nodiscard]] std::vector<TextBox> ink_of(const PlotPanel& panel, const PlotScale& x);

}  // namespace higherpair
