#pragma once

#include "higherpair/drawing/picture.hpp"
#include "text_layout.hpp"
#include "ticks.hpp"

#include <string>
#include <vector>

namespace higherpair {

inline constexpr double kPlotFont = 12;      // [px]
inline constexpr double kPlotLine = 17;      // from one line of text to the next [px]
inline constexpr double kSampleLength = 24;  // length of the sample line beside a name [px]

/// The straight map from an axis to the screen.
struct PlotScale {
  Ticks ticks;
  double begin = 0;  ///< position of the low end [px]
  double end = 1;

  [[nodiscard]] double px(double value) const {
    return begin + (value - ticks.low) / (ticks.high - ticks.low) * (end - begin);
  }
};

/// A name above a panel, with a sample of its line if the panel has several.
struct LegendEntry {
  const PlotSeries* series = nullptr;
  std::string text;
  double x = 0;  ///< [px]
  int line = 0;
};

/// The series of one unit, and their position on the screen.
struct PlotPanel {
  std::string unit;
  std::vector<const PlotSeries*> series;
  std::vector<const PlotPoint*> points;
  std::vector<LegendEntry> legend;
  double legend_top = 0;  ///< [px]
  PlotScale y;            ///< `begin` is below `end`
};

/// The label of a mark, or of a range too narrow to contain its label.
struct PlotFlag {
  Flag place;
  std::string label;
  std::string name;
  const PlotMark* mark = nullptr;  ///< null: a range
};

struct PlotLayout {
  const PlotData* data = nullptr;
  std::vector<std::string> title;  ///< its lines
  double title_top = 0;
  PlotScale x;
  std::vector<PlotPanel> panels;
  std::vector<PlotFlag> flags;                ///< in ascending order of x
  std::vector<const PlotRange*> wide_ranges;  ///< ranges wide enough to contain their labels
  std::vector<std::string> notes;             ///< lines
  double notes_top = 0;
  double bottom = 0;
};

/// Computes the positions of all parts.
/// \param top  of the plot in the picture [px]
[[nodiscard]] PlotLayout lay_out(const PlotData& data, double width, double top);

/// Whether x never changes direction in any of the series.
[[nodiscard]] bool is_monotone(const PlotData& data);

}  // namespace higherpair
