#include "plot_layout.hpp"

#include "higherpair/numeric/special_values.hpp"
#include "numeric/utf8.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kPlotMargin = 14;      // around the picture [px]
constexpr double kTickGap = 8;          // from an axis to the labels of its ticks [px]
constexpr double kSingleHeight = 280;   // of the only panel [px]
constexpr double kStackedHeight = 150;  // of each of several [px]
constexpr double kTicksApart = 64;      // least distance along x [px]
constexpr double kTicksApartUp = 25;    // least distance along y [px]
constexpr double kEntryGap = 18;        // between names above a panel [px]
constexpr double kPanelGap = 12;        // [px]

// The range of the finite numbers added.
struct ValueRange {
  double low = kInf;
  double high = -kInf;

  void add(double value) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  [[nodiscard]] bool empty() const { return !(low <= high); }
};

AxisRange x_range(const PlotData& data) {
  ValueRange extent;
  for (const PlotSeries& series : data.series) {
    for (const double x : series.x) extent.add(x);
  }
  for (const PlotRange& range : data.ranges) {
    extent.add(range.from);
    extent.add(range.to);
  }
  if (extent.empty()) {
    return {0, 1};
  }
  const AxisRange padded = padded_range(extent.low, extent.high, kNoTickValue);
  const bool wide =
      extent.high - extent.low > kNoTickSpread * std::max(std::abs(extent.low), std::abs(extent.high));
  return wide && data.points.empty() && is_monotone(data) ? AxisRange{extent.low, extent.high} : padded;
}

AxisRange y_range(const PlotPanel& panel) {
  ValueRange extent;
  double noise = panel.series.empty() ? kNoTickValue : kInf;
  for (const PlotSeries* series : panel.series) {
    for (const double y : series->y) extent.add(y);
    noise = std::min(noise, series->noise);
  }
  for (const PlotPoint* point : panel.points) extent.add(point->y);
  return extent.empty() ? AxisRange{0, 1} : padded_range(extent.low, extent.high, noise);
}

std::vector<PlotPanel> make_panels(const PlotData& data) {
  std::vector<PlotPanel> panels;
  const auto of_unit = [&](const std::string& unit) -> PlotPanel& {
    const auto found = std::find_if(panels.begin(), panels.end(),
                                    [&](const PlotPanel& panel) { return panel.unit == unit; });
    if (found != panels.end()) return *found;
    panels.emplace_back().unit = unit;
    return panels.back();
  };
  for (const PlotSeries& series : data.series) of_unit(series.unit).series.push_back(&series);
  for (const PlotPoint& point : data.points) of_unit(point.unit).points.push_back(&point);
  return panels;
}

std::string unit_in_brackets(const PlotPanel& panel) {
  const std::string unit = printed_unit(panel.unit, panel.y.ticks.exponent);
  return unit.empty() ? "" : "[" + unit + "]";
}

// Lays out the names above a panel from left to right; returns the number of lines that they take.
int lay_out_legend(PlotPanel& panel, const PlotData& data, double left, double right) {
  const std::string unit = unit_in_brackets(panel);
  const bool single = panel.series.size() == 1 && data.y_name.empty();
  const std::string name = single ? panel.series[0]->name : data.y_name;
  if (const std::string head = name + (name.empty() || unit.empty() ? "" : " ") + unit; !head.empty()) {
    panel.legend.push_back({nullptr, head});
  }
  for (const PlotSeries* series : panel.series) {
    if (!single && !series->name.empty()) panel.legend.push_back({series, series->name});
  }
  double x = left;
  int line = 0;
  for (LegendEntry& entry : panel.legend) {
    const double width =
        text_width(entry.text, kPlotFont) + (entry.series != nullptr ? kSampleLength + 6 : 0);
    if (x > left && x + width > right) {
      x = left;
      ++line;
    }
    entry.x = x;
    entry.line = line;
    x += width + kEntryGap;
  }
  return panel.legend.empty() ? 0 : line + 1;
}

double widest_label(const std::vector<PlotPanel>& panels) {
  double widest = 0;
  for (const PlotPanel& panel : panels) {
    for (const double value : panel.y.ticks.values) {
      widest = std::max(widest, text_width(panel.y.ticks.label(value), kPlotFont));
    }
  }
  return widest;
}

// The text, or as much of it as has room.
std::string shortened(const std::string& text, double room) {
  if (text_width(text, kPlotFont) <= room) return text;
  std::string shown = text;
  while (!shown.empty() && text_width(shown + "…", kPlotFont) > room) {
    while (!shown.empty() && !begins_character(shown.back())) shown.pop_back();
    if (!shown.empty()) shown.pop_back();
  }
  return shown + "…";
}

// Lays out the flags; returns the number of lanes.
int lay_out_flags(PlotLayout& layout) {
  const PlotData& data = *layout.data;
  std::vector<PlotFlag>& flags = layout.flags;
  const auto add = [&](double x, const std::string& label, const std::string& name, const PlotMark* mark) {
    PlotFlag& flag = flags.emplace_back();
    flag.place.x = layout.x.px(x);
    // It has room on one side of its line or on the other.
    const double room = std::max(flag.place.x - layout.x.begin, layout.x.end - flag.place.x);
    flag.label = shortened(label, room - 4);
    flag.place.width = text_width(flag.label, kPlotFont) + 4;
    flag.name = name;
    flag.mark = mark;
  };
  for (const PlotRange& range : data.ranges) {
    const double room = std::abs(layout.x.px(range.to) - layout.x.px(range.from));
    if (text_width(range.label, kPlotFont) + 8 < room) {
      layout.wide_ranges.push_back(&range);
    } else {
      add((range.from + range.to) / 2, range.label, range.label, nullptr);
    }
  }
  for (const PlotMark& mark : data.marks) add(mark.x, mark.label, mark.name, &mark);
  std::stable_sort(flags.begin(), flags.end(),
                   [](const PlotFlag& a, const PlotFlag& b) { return a.place.x < b.place.x; });
  std::vector<Flag> places;
  for (const PlotFlag& flag : flags) places.push_back(flag.place);
  place_flags(places, layout.x.begin, layout.x.end);
  int lanes = 0;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    flags[i].place = places[i];
    lanes = std::max(lanes, places[i].lane + 1);
  }
  return lanes;
}

}  // namespace

bool is_monotone(const PlotData& data) {
  return std::all_of(data.series.begin(), data.series.end(), [](const PlotSeries& series) {
    return std::is_sorted(series.x.begin(), series.x.end()) ||
           std::is_sorted(series.x.rbegin(), series.x.rend());
  });
}

PlotLayout lay_out(const PlotData& data, double width, double top) {
  PlotLayout layout;
  layout.data = &data;
  layout.title_top = top + kPlotMargin;
  layout.panels = make_panels(data);
  const double height = layout.panels.size() == 1 ? kSingleHeight : kStackedHeight;
  for (PlotPanel& panel : layout.panels) {
    const AxisRange range = y_range(panel);
    panel.y.ticks = make_ticks(range.low, range.high, panel.unit, static_cast<int>(height / kTicksApartUp));
  }
  layout.x.begin = kPlotMargin + widest_label(layout.panels) + kTickGap;
  layout.x.end = width - kPlotMargin - 8;
  layout.title = wrapped(data.title, kBoldWidth * (kPlotFont + 1), layout.x.end - layout.x.begin);
  const AxisRange range = x_range(data);
  const double room = std::max(layout.x.end - layout.x.begin, kTicksApart);
  layout.x.ticks = make_ticks(range.low, range.high, data.x.unit, static_cast<int>(room / kTicksApart));
  const int lanes = lay_out_flags(layout);

  double y = layout.title_top + kPlotLine * static_cast<double>(layout.title.size()) + 4;
  for (PlotPanel& panel : layout.panels) {
    panel.legend_top = y;
    y += kPlotLine * lay_out_legend(panel, data, layout.x.begin, layout.x.end) + 6;
    if (&panel == &layout.panels.front()) y += kPlotLine * lanes;
    panel.y.end = y;
    panel.y.begin = y + height;
    y += height + kPanelGap;
  }
  layout.notes_top = y + 2 * kPlotLine + 4;
  for (const std::string& note : data.notes) {
    for (std::string& line : wrapped(note, kPlotFont, layout.x.end - layout.x.begin)) {
      layout.notes.push_back(std::move(line));
    }
  }
  layout.bottom = layout.notes_top + kPlotLine * static_cast<double>(layout.notes.size()) + kPlotMargin;
  return layout;
}

}  // namespace higherpair
