#include "higherpair/drawing/picture.hpp"
#include "plot_layout.hpp"
#include "plot_lines.hpp"
#include "point_labels.hpp"
#include "svg_writer.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr double kTickLength = 4;     // [px]
constexpr double kPointRadius = 3.2;  // [px]
constexpr double kDotRadius = 2.6;    // of a point of a line that is joined to no other [px]

constexpr const char* kPlotStyle = R"(
.hp-plot { background: #fff; }
.hp-plot text { font-family: sans-serif; font-size: 12px; fill: #000; }
.hp-plot .title { font-size: 13px; font-weight: bold; }
.hp-plot .frame { fill: none; stroke: #000; stroke-width: 1; }
.hp-plot .grid { stroke: #ddd; stroke-width: 0.6; }
.hp-plot .zero { stroke: #999; stroke-width: 0.8; }
.hp-plot .tick { stroke: #000; stroke-width: 1; }
.hp-plot .line { fill: none; stroke-width: 1.7; stroke-linejoin: round; }
.hp-plot .mark { stroke: #000; stroke-width: 0.7; stroke-dasharray: 3 3; }
.hp-plot .stem { stroke: #000; stroke-width: 0.7; }
.hp-plot .point { fill: #fff; stroke: #000; stroke-width: 1.2; }
.hp-plot .range { fill: #000; fill-opacity: 0.09; }
.hp-plot .halo { paint-order: stroke; stroke: #fff; stroke-width: 3px; stroke-linejoin: round; }
)";

class PlotWriter {
public:
  PlotWriter(SvgWriter& svg, const PlotLayout& layout) : svg_(svg), layout_(layout), data_(*layout.data) {}

  void write() {
    svg_.open("g", {{"data-role", "plot"}, {"data-name", data_.title}});
    write_lines(layout_.title, layout_.title_top, "title");
    for (const PlotPanel& panel : layout_.panels) write_panel(panel);
    write_x_axis();
    write_flags();
    write_lines(layout_.notes, layout_.notes_top, "note");
    svg_.close();
  }

private:
  void line(std::string_view kind, double x1, double y1, double x2, double y2) {
    svg_.element("line", {{"class", kind}, {"x1", x1}, {"y1", y1}, {"x2", x2}, {"y2", y2}});
  }

  void write_lines(const std::vector<std::string>& lines, double top, std::string_view kind) {
    for (const std::string& text : lines) {
      top += kPlotLine;
      svg_.text({{"class", kind}, {"x", layout_.x.begin}, {"y", top - 4}}, text);
    }
  }

  void write_panel(const PlotPanel& panel) {
    svg_.open("g", {{"data-role", "panel"}, {"data-name", panel.unit}});
    write_ranges(panel);
    write_y_axis(panel);
    write_marks(panel);
    for (const PlotSeries* series : panel.series) write_series(panel, *series);
    write_points(panel);
    write_legend(panel);
    svg_.close();
  }

  void write_ranges(const PlotPanel& panel) {
    for (const PlotRange& range : data_.ranges) {
      const double from = layout_.x.px(std::min(range.from, range.to));
      const double to = layout_.x.px(std::max(range.from, range.to));
      svg_.element("rect", {{"class", "range"},
                            {"data-role", "status"},
                            {"data-name", range.label},
                            {"x", from},
                            {"y", panel.y.end},
                            {"width", std::max(to - from, 1.0)},
                            {"height", panel.y.begin - panel.y.end}});
    }
  }

  void write_y_axis(const PlotPanel& panel) {
    const PlotScale& y = panel.y;
    const PlotScale& x = layout_.x;
    for (const double value : x.ticks.values) line("grid", x.px(value), y.begin, x.px(value), y.end);
    open_axis("y", panel.unit, y);
    for (const double value : y.ticks.values) {
      const double at = y.px(value);
      const bool zero = std::abs(value) < kTickAtZero * y.ticks.step;
      line(zero ? "zero" : "grid", x.begin, at, x.end, at);
      svg_.open("g", {{"data-role", "tick"}});
      line("tick", x.begin - kTickLength, at, x.begin, at);
      svg_.text({{"x", x.begin - kTickLength - 4}, {"y", at + 4}, {"text-anchor", "end"}},
                y.ticks.label(value));
      svg_.close();
    }
    svg_.close();
    svg_.element("rect", {{"class", "frame"},
                          {"x", x.begin},
                          {"y", y.end},
                          {"width", x.end - x.begin},
                          {"height", y.begin - y.end}});
  }

  void open_axis(std::string_view name, const std::string& unit, const PlotScale& scale) {
    const auto pair = [](double a, double b) { return svg_number(a) + " " + svg_number(b); };
    svg_.open("g", {{"data-role", "axis"},
                    {"data-name", name},
                    {"data-unit", unit},
                    {"data-domain", fmt::format("{:.9g} {:.9g}", scale.ticks.low, scale.ticks.high)},
                    {"data-range", pair(scale.begin, scale.end)}});
  }

  void write_x_axis() {
    if (layout_.panels.empty()) return;
    const PlotScale& x = layout_.x;
    const double bottom = layout_.panels.back().y.begin;
    open_axis("x", data_.x.unit, x);
    for (const double value : x.ticks.values) {
      svg_.open("g", {{"data-role", "tick"}});
      for (const PlotPanel& panel : layout_.panels) {
        line("tick", x.px(value), panel.y.begin, x.px(value), panel.y.begin + kTickLength);
      }
      svg_.text({{"x", x.px(value)}, {"y", bottom + 17}, {"text-anchor", "middle"}}, x.ticks.label(value));
      svg_.close();
    }
    const std::string unit = printed_unit(data_.x.unit, x.ticks.exponent);
    svg_.text({{"x", (x.begin + x.end) / 2}, {"y", bottom + 2 * kPlotLine}, {"text-anchor", "middle"}},
              data_.x.name + (unit.empty() ? "" : " [" + unit + "]"));
    svg_.close();
  }

  void write_marks(const PlotPanel& panel) {
    for (const PlotMark& mark : data_.marks) {
      line("mark", layout_.x.px(mark.x), panel.y.begin, layout_.x.px(mark.x), panel.y.end);
    }
  }

  void write_series(const PlotPanel& panel, const PlotSeries& series) {
    const Stroke stroke = stroke_of(panel, series);
    const SvgPath path = path_of(series, layout_.x, panel.y);
    if (path.empty()) return;
    svg_.element("path", {{"class", "line"},
                          {"data-role", "series"},
                          {"data-name", series.name},
                          {"stroke", stroke.color},
                          {"stroke-dasharray", stroke.dash},
                          {"style", "stroke-width: " + svg_number(stroke.width)},
                          {"d", path}});
    for (const Vector2d& point : isolated_points(series, layout_.x, panel.y)) {
      svg_.element("circle", {{"data-role", "dot"},
                              {"data-name", series.name},
                              {"cx", point.x()},
                              {"cy", point.y()},
                              {"r", kDotRadius},
                              {"fill", stroke.color}});
    }
  }

  void write_points(const PlotPanel& panel) {
    std::vector<LabelledPoint> points;
    for (const PlotPoint* point : panel.points) {
      LabelledPoint& place = points.emplace_back();
      place.x = layout_.x.px(point->x);
      place.y = panel.y.px(point->y);
      place.width = text_width(point->label, kPlotFont);
    }
    if (points.empty()) return;
    place_labels(points, {layout_.x.begin, panel.y.end, layout_.x.end, panel.y.begin},
                 ink_of(panel, layout_.x));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PlotPoint& point = *panel.points[i];
      const LabelledPoint& place = points[i];
      svg_.open("g", {{"data-role", "event"}, {"data-name", point.name}});
      if (!point.detail.empty()) svg_.element("title", {}, point.detail);
      if (place.far) line("stem", place.x, place.y, place.box.left, (place.box.top + place.box.bottom) / 2);
      svg_.element("circle", {{"class", "point"}, {"cx", place.x}, {"cy", place.y}, {"r", kPointRadius}});
      if (place.shown) {
        svg_.text({{"class", "halo"}, {"x", place.box.left}, {"y", place.box.bottom - 3}}, point.label);
      }
      svg_.close();
    }
  }

  void write_legend(const PlotPanel& panel) {
    for (const LegendEntry& entry : panel.legend) {
      const double y = panel.legend_top + kPlotLine * entry.line + kPlotLine - 4;
      double x = entry.x;
      if (entry.series != nullptr) {
        const Stroke stroke = stroke_of(panel, *entry.series);
        svg_.element("line", {{"class", "line"},
                              {"x1", x},
                              {"y1", y - 4},
                              {"x2", x + kSampleLength},
                              {"y2", y - 4},
                              {"stroke", stroke.color},
                              {"stroke-dasharray", stroke.dash},
                              {"style", "stroke-width: " + svg_number(stroke.width)}});
        x += kSampleLength + 6;
      }
      svg_.text({{"x", x}, {"y", y}}, entry.text);
    }
  }

  void write_flags() {
    if (layout_.panels.empty()) return;
    const double bottom = layout_.panels.front().y.end;
    for (const PlotFlag& flag : layout_.flags) {
      const double top = bottom - kPlotLine * (flag.place.lane + 1);
      const double x = flag.place.x;
      svg_.open("g", {{"data-role", flag.mark != nullptr ? "event" : "status"}, {"data-name", flag.name}});
      if (flag.mark != nullptr && !flag.mark->detail.empty()) {
        svg_.element("title", {}, flag.mark->detail);
      }
      line("stem", x, bottom, x, top + 3);
      svg_.text({{"x", x + (flag.place.leftward ? -4 : 4)},
                 {"y", top + kPlotLine - 5},
                 {"text-anchor", flag.place.leftward ? "end" : "start"}},
                flag.label);
      svg_.close();
    }
    for (const PlotRange* range : layout_.wide_ranges) {
      svg_.text({{"data-role", "status"},
                 {"data-name", range->label},
                 {"x", (layout_.x.px(range->from) + layout_.x.px(range->to)) / 2},
                 {"y", bottom + kPlotLine},
                 {"text-anchor", "middle"}},
                range->label);
    }
  }

  SvgWriter& svg_;
  const PlotLayout& layout_;
  const PlotData& data_;
};

bool can_be_drawn(double value) {
  return std::abs(value) <= kLargestPlotted;
}

// Without what cannot be drawn.
PlotData drawable(PlotData data) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (PlotSeries& series : data.series) {
    series.y.resize(series.x.size(), kNan);
    for (std::vector<double>* values : {&series.x, &series.y}) {
      std::replace_if(
          values->begin(), values->end(), [](double value) { return !can_be_drawn(value); }, kNan);
    }
  }
  std::erase_if(data.marks, [](const PlotMark& mark) { return !can_be_drawn(mark.x); });
  std::erase_if(data.points,
                [](const PlotPoint& point) { return !can_be_drawn(point.x) || !can_be_drawn(point.y); });
  std::erase_if(data.ranges,
                [](const PlotRange& range) { return !can_be_drawn(range.from) || !can_be_drawn(range.to); });
  return data;
}

}  // namespace

std::string plots_svg(const std::vector<PlotData>& given, double asked) {
  const double width = picture_width(asked);
  std::vector<PlotData> plots;
  std::transform(given.begin(), given.end(), std::back_inserter(plots), drawable);
  std::vector<PlotLayout> layouts;
  double bottom = 0;
  for (const PlotData& data : plots) {
    layouts.push_back(lay_out(data, width, bottom));
    bottom = layouts.back().bottom;
  }
  SvgWriter svg({width, std::max(bottom, 1.0), plots.empty() ? "" : plots.front().title, kPlotStyle},
                {{"class", "hp-plot"}});
  svg.element("rect", {{"width", width}, {"height", std::max(bottom, 1.0)}, {"fill", "#fff"}});
  for (const PlotLayout& layout : layouts) {
    PlotWriter(svg, layout).write();
  }
  return std::move(svg).finish();
}

}  // namespace higherpair
