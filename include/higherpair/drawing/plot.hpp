#pragma once

#include <string>
#include <vector>

namespace higherpair {

// A plot as plain data, and its picture. Numbers are in the units that are named beside them; NaN is
// undefined and leaves a gap.

struct PlotAxis {
  std::string name;  ///< "driver"
  std::string unit;  ///< as in tables: "deg/s^2"; "1" or empty: a pure number
};

/// How a line is drawn.
enum class PlotLine {
  kOwn,       ///< in a colour and a dash pattern of its own
  kEmphasis,  ///< the one to look at
  kFaint,     ///< in the background
};

/// A line. Those of one unit share a panel; panels are stacked in the order of their first lines.
struct PlotSeries {
  std::string name;
  std::string unit;
  std::vector<double> x;
  std::vector<double> y;  ///< as many
  PlotLine line = PlotLine::kOwn;
};

/// Something that happens at x, in all panels: a thin vertical line with a label.
struct PlotMark {
  double x = 0;
  std::string label;   ///< short
  std::string name;    ///< what it happens at, for data-name
  std::string detail;  ///< a sentence, shown where a pointer rests on the mark
};

/// Something that happens at a point of the panel of `unit`: a small circle with a label.
struct PlotPoint {
  double x = 0;
  double y = 0;
  std::string unit;
  std::string label;
  std::string name;
  std::string detail;
};

/// A range of x that is shaded and named.
struct PlotRange {
  double from = 0;
  double to = 0;
  std::string label;
};

struct PlotData {
  std::string title;
  PlotAxis x;
  std::string y_name;  ///< of the quantity that all series show; empty: their names say it
  std::vector<PlotSeries> series;
  std::vector<PlotMark> marks;
  std::vector<PlotPoint> points;
  std::vector<PlotRange> ranges;
  std::vector<std::string> notes;  ///< lines of text below the plot
};

/// The plots as one SVG picture, one below the other. Elements carry data-role (`axis`, `tick`, `series`,
/// `event`, `status`) and data-name; each axis carries data-domain, its two ends in its unit, and data-range,
/// the same in px, so that what is drawn can be read back.
/// \param width  [px], at least 200
[[nodiscard]] std::string plots_svg(const std::vector<PlotData>& plots, double width = 720);

}  // namespace higherpair
