#include "plot_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kShortestPiece = 0.3;  // points of a line that are closer than this count as one [px]

// The colours of Okabe and Ito without yellow; the dash patterns distinguish the lines in black and white.
constexpr std::array<const char*, 7> kColors = {"#0072b2", "#d55e00", "#009e73", "#000000",
                                                "#cc79a7", "#a87000", "#3a93c8"};
constexpr std::array<const char*, 6> kDashes = {"none", "8 3", "2 2.5", "9 3 2 3", "14 4", "5 2 1.5 2 1.5 2"};

// Hundredths of a px are enough, and make shorter numbers.
double rounded(double px) {
  return std::round(px * 100) / 100;
}

bool is_defined(const PlotSeries& series, std::size_t i) {
  return i < series.x.size() && std::isfinite(series.x[i]) && std::isfinite(series.y[i]);
}

// Whether a line leads from the point before to this one.
bool is_joined(const PlotSeries& series, std::size_t i) {
  return i > 0 && is_defined(series, i - 1) && is_defined(series, i) &&
         !std::binary_search(series.breaks.begin(), series.breaks.end(), i);
}

}  // namespace

Stroke stroke_of(const PlotPanel& panel, const PlotSeries& series) {
  switch (series.line) {
    case PlotLine::kEmphasis:
      return {"#000000", "none", 2.8};
    case PlotLine::kFaint:
      return {"#8a8a8a", "4 3", 1.2};
    case PlotLine::kOwn:
      break;
  }
  std::size_t index = 0;
  for (const PlotSeries* other : panel.series) {
    if (other == &series) break;
    index += other->line == PlotLine::kOwn ? 1 : 0;
  }
  return {kColors[index % kColors.size()], kDashes[index % kDashes.size()], 1.7};
}

SvgPath path_of(const PlotSeries& series, const PlotScale& x_scale, const PlotScale& y_scale) {
  SvgPath path;
  double x_last = 0;
  double y_last = 0;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!is_defined(series, i)) continue;
    const double x = rounded(x_scale.px(series.x[i]));
    const double y = rounded(y_scale.px(series.y[i]));
    const bool first = !is_joined(series, i);
    const bool last = !is_joined(series, i + 1);
    if (first) {
      path.move_to(x, y);
      if (last) path.line_to(x, y);
    } else if (last || std::hypot(x - x_last, y - y_last) >= kShortestPiece) {
      path.line_to(x, y);
    } else {
      continue;
    }
    x_last = x;
    y_last = y;
  }
  return path;
}

std::vector<Vector2d> isolated_points(const PlotSeries& series, const PlotScale& x_scale,
                                      const PlotScale& y_scale) {
  std::vector<Vector2d> points;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!is_defined(series, i) || is_joined(series, i) || is_joined(series, i + 1)) continue;
    points.emplace_back(x_scale.px(series.x[i]), y_scale.px(series.y[i]));
  }
  return points;
}

std::vector<TextBox> ink_of(const PlotPanel& panel, const PlotScale& x) {
  constexpr double kAway = 1.5;
  constexpr double kApart = 4;
  std::vector<TextBox> boxes;
  for (const PlotSeries* series : panel.series) {
    double left = -1e9;
    double top = -1e9;
    for (std::size_t i = 0; i < series->x.size(); ++i) {
      if (!is_defined(*series, i)) continue;
      const double at_x = x.px(series->x[i]);
      const double at_y = panel.y.px(series->y[i]);
      if (std::hypot(at_x - left, at_y - top) < kApart) continue;
      boxes.push_back({at_x - kAway, at_y - kAway, at_x + kAway, at_y + kAway});
      left = at_x;
      top = at_y;
    }
  }
  return boxes;
}

}  // namespace higherpair
