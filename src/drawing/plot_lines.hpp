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

/// How a line of a panel is drawn: differently from the others, in black and white as well.
[[nodiscard]] Stroke stroke_of(const PlotPanel& panel, const PlotSeries& series);

/// A line on the screen. Points that lie on each other there are left out, but for the ends of a piece; a
/// point on its own is a short line.
[[nodiscard]] SvgPath path_of(const PlotSeries& series, const PlotScale& x, const PlotScale& y);

/// Places that the lines of a panel pass through, for labels to keep clear of.
[[nodiscard]] std::vector<TextBox> ink_of(const PlotPanel& panel, const PlotScale& x);

}  // namespace higherpair
