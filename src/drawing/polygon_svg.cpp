#include "higherpair/drawing/picture.hpp"
#include "polygon_layout.hpp"
#include "rich_text.hpp"
#include "svg_writer.hpp"
#include "text_layout.hpp"
#include "ticks.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr double kArrowHead = 10;                    // length of an arrow's head [px]
constexpr double kShortestBar = 60;                  // shortest scale bar [px]
constexpr double kNameAt = 28;                       // in the table of arrows: where names begin [px]
constexpr double kLengthRoom = 58, kAngleRoom = 62;  // columns of the numbers [px]
constexpr const char* kIndent = "   ";               // of an equation's further lines

constexpr const char* kPolygonStyle = R"(
.hp-polygon text { font-family: sans-serif; font-size: 12px; fill: #000; }
.hp-polygon .title { font-size: 14px; font-weight: bold; }
.hp-polygon .head { font-weight: bold; }
.hp-polygon .name { paint-order: stroke; stroke: #fff; stroke-width: 3px; stroke-linejoin: round; }
.hp-polygon .point { font-style: italic; paint-order: stroke; stroke: #fff; stroke-width: 3px; }
.hp-polygon .stem { stroke: #999; stroke-width: 0.7; }
.hp-polygon .bar { stroke: #000; stroke-width: 1.2; fill: none; }
.hp-polygon .rule { stroke: #ccc; stroke-width: 0.8; }
)";

using ArrowKind = PolygonArrow::Kind;

struct ArrowLook {
  const char* part;
  const char* color;
  const char* dash;
  double width;
};

ArrowLook look_of(ArrowKind kind) {
  switch (kind) {
    case ArrowKind::kAbsolute:
      return {"absolute", "#000000", "none", 1.9};
    case ArrowKind::kRelative:
      return {"relative", "#0072b2", "none", 1.6};
    case ArrowKind::kNormal:
      return {"normal", "#d55e00", "6 3", 1.5};
    case ArrowKind::kTangential:
      return {"tangential", "#009e73", "2.5 2.5", 1.5};
    case ArrowKind::kSliding:
      return {"sliding", "#b0528c", "9 3 2 3", 1.6};
    case ArrowKind::kCoriolis:
      return {"coriolis", "#a87000", "14 4", 1.6};
    case ArrowKind::kForce:
      break;
  }
  return {"force", "#000000", "none", 1.7};
}

const char* role_of(Polygon::Kind kind) {
  return kind == Polygon::Kind::kVelocity       ? "velocity"
         : kind == Polygon::Kind::kAcceleration ? "acceleration"
                                                : "force";
}

// Where equations and tables begin [px].
double text_left(double width) {
  return kDrawnShare * width + kPolygonAround + 8;
}

// The parts between which a line may be broken: each begins with its sign.
std::vector<std::string_view> terms_of(std::string_view equation) {
  std::vector<std::string_view> terms;
  while (!equation.empty()) {
    const std::size_t next =
        std::min({equation.find(" + ", 1), equation.find(" −", 1), equation.find(" = ", 1), equation.size()});
    terms.push_back(equation.substr(0, next));
    equation.remove_prefix(next);
  }
  return terms;
}

// The room beside the drawn part in which no name reaches into the numbers, and no term is cut off [px].
double text_room(const Polygon& polygon) {
  double room = 0;
  for (const PolygonArrow& arrow : polygon.arrows) {
    room = std::max(room, kNameAt + rich_width(arrow.name, kPolygonFont) + kLengthRoom + kAngleRoom);
  }
  for (const std::string& equation : polygon.equations) {
    for (const std::string_view term : terms_of(equation)) {
      room = std::max(room, rich_width(kIndent + std::string(term), kPolygonFont));
    }
  }
  return room;
}

class PolygonWriter {
public:
  /// \param right  edge of the texts, the same for all polygons of the picture [px]
  PolygonWriter(SvgWriter& svg, const PolygonLayout& layout, double right)
      : svg_(svg), layout_(layout), polygon_(*layout.polygon), right_(right) {}

  /// Returns the bottom edge [px].
  double write() {
    svg_.open("g", {{"data-role", "polygon"},
                    {"data-name", polygon_.title},
                    {"data-unit", polygon_.unit},
                    {"data-scale", fmt::format("{:.12g}", layout_.scale)},
                    {"data-origin", svg_number(layout_.origin.x()) + " " + svg_number(layout_.origin.y())}});
    svg_.text({{"class", "head"}, {"x", kPolygonMargin}, {"y", layout_.top + kPolygonLine - 4}}, heading());
    if (!polygon_.arrows.empty()) {
      for (std::size_t i = 0; i < polygon_.arrows.size(); ++i) write_arrow(i);
      write_labels();
      write_bar();
    }
    const double bottom = write_texts();
    svg_.close();
    return std::max(bottom, layout_.bottom) + kPolygonMargin;
  }

private:
  [[nodiscard]] std::string heading() const {
    const bool is_force = polygon_.kind == Polygon::Kind::kForce && !polygon_.arrows.empty();
    const std::string unit = layout_.unit();
    return (is_force ? "Forces on " : "") + polygon_.title + (unit.empty() ? "" : " [" + unit + "]");
  }

  void write_arrow(std::size_t index) {
    const PolygonArrow& arrow = polygon_.arrows[index];
    const ArrowLook look = look_of(arrow.kind);
    const auto& [from, to] = layout_.ends[index];
    const Vector2d along = (to - from).normalized();
    const double head = std::min(kArrowHead, 0.6 * (to - from).norm());
    const Vector2d base = to - head * along;
    const Vector2d side = 0.32 * head * perp(along);
    svg_.open("g", {{"data-role", role_of(polygon_.kind)},
                    {"data-name", arrow.item},
                    {"data-part", look.part},
                    {"data-label", plain_text(arrow.name)}});
    svg_.element("line", {{"x1", from.x()},
                          {"y1", from.y()},
                          {"x2", base.x()},
                          {"y2", base.y()},
                          {"stroke", look.color},
                          {"stroke-width", look.width},
                          {"stroke-dasharray", look.dash}});
    SvgPath path;
    path.move_to(to.x(), to.y()).line_to(base.x() + side.x(), base.y() + side.y());
    path.line_to(base.x() - side.x(), base.y() - side.y()).close();
    svg_.element("path", {{"d", path}, {"fill", look.color}});
    svg_.close();
  }

  void write_labels() {
    for (const PolygonLabel& label : place_polygon_labels(layout_)) {
      if (label.far) {
        const double x = std::clamp(label.names.x(), label.at.x(), label.at.x() + label.width);
        svg_.element("line", {{"class", "stem"},
                              {"x1", label.names.x()},
                              {"y1", label.names.y()},
                              {"x2", x},
                              {"y2", label.at.y() - 4}});
      }
      svg_.open("g", {{"data-role", "label"}, {"data-name", plain_text(label.text)}});
      rich_text(svg_, label.at.x(), label.at.y(), label.text, kPolygonFont,
                label.is_point ? "point" : "name");
      svg_.close();
    }
  }

  void write_bar() {
    const Ticks ticks = make_ticks(0, kShortestBar / layout_.scale, "", 1);
    const double length = ticks.step * layout_.scale;
    const double x = kPolygonMargin + 4;
    const double y = layout_.bottom - 4;
    SvgPath path;
    path.move_to(x, y - 4).line_to(x, y + 4).move_to(x, y).line_to(x + length, y);
    path.move_to(x + length, y - 4).line_to(x + length, y + 4);
    svg_.element("path", {{"class", "bar"}, {"data-role", "scale"}, {"d", path}});
    svg_.text({{"x", x + length + 8}, {"y", y + 4}},
              printed_number(ticks.step / std::pow(10, layout_.exponent), 9) + " " + layout_.unit());
  }

  // Writes the equations and a list of the arrows; returns the bottom edge [px].
  double write_texts() {
    const double left = text_left(layout_.width);
    double y = layout_.top + kPolygonLine - 4;
    const auto lines = [&](const std::vector<std::string>& texts) {
      for (const std::string& text : texts) {
        rich_text(svg_, left, y, text, kPolygonFont);
        y += kPolygonLine;
      }
    };
    for (const std::string& note : polygon_.notes) {
      lines(wrapped(note, kPolygonFont, right_ - left));
    }
    if (layout_.flat) lines({"all on one line, drawn side by side"});
    lines(wrapped_equations(right_ - left));
    if (polygon_.arrows.empty()) return y;
    svg_.element("line", {{"class", "rule"}, {"x1", left}, {"y1", y - 9}, {"x2", right_}, {"y2", y - 9}});
    y += 6;
    for (const PolygonArrow& arrow : polygon_.arrows) {
      write_value(arrow, left, y);
      y += kPolygonLine;
    }
    return y;
  }

  // Breaks equations that are too long, before a sign.
  [[nodiscard]] std::vector<std::string> wrapped_equations(double room) const {
    std::vector<std::string> lines;
    for (const std::string& equation : polygon_.equations) {
      std::string line;
      for (const std::string_view term : terms_of(equation)) {
        if (!line.empty() && rich_width(line + std::string(term), kPolygonFont) > room) {
          lines.push_back(line);
          line = kIndent;
        }
        line += term;
      }
      lines.push_back(line);
    }
    return lines;
  }

  void write_value(const PolygonArrow& arrow, double left, double y) {
    const ArrowLook look = look_of(arrow.kind);
    const Vector2d vector = arrow.to - arrow.from;
    const double length = vector.norm() / std::pow(10, layout_.exponent);
    const double degrees = angle_of(vector) * 180 / kPi;
    svg_.element("line", {{"x1", left},
                          {"y1", y - 4},
                          {"x2", left + 20},
                          {"y2", y - 4},
                          {"stroke", look.color},
                          {"stroke-width", look.width},
                          {"stroke-dasharray", look.dash}});
    rich_text(svg_, left + kNameAt, y, arrow.name, kPolygonFont);
    svg_.text({{"x", right_ - kAngleRoom}, {"y", y}, {"text-anchor", "end"}}, significant(length));
    svg_.text({{"x", right_}, {"y", y}, {"text-anchor", "end"}}, printed_number(degrees, 1) + "°");
  }

  // Formats a value with four digits.
  static std::string significant(double value) {
    const int before = value > 0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
    return fmt::format("{:.{}f}", value, std::clamp(4 - before, 0, 9));
  }

  SvgWriter& svg_;
  const PolygonLayout& layout_;
  const Polygon& polygon_;
  double right_;
};

// \param drawn  width that the drawn parts take their share of \param width  of the picture [px]
double write_all(SvgWriter& svg, const std::vector<Polygon>& polygons, const std::string& title, double drawn,
                 double width) {
  const double right = width - kPolygonMargin;
  double y = kPolygonMargin;
  for (const std::string& line : wrapped(title, kBoldWidth * 14, right - kPolygonMargin)) {
    y += kPolygonLine;
    svg.text({{"class", "title"}, {"x", kPolygonMargin}, {"y", y - 4}}, line);
  }
  y += 8;
  for (const Polygon& polygon : polygons) y = PolygonWriter(svg, lay_out(polygon, drawn, y), right).write();
  return y;
}

}  // namespace

std::string polygons_svg(const std::vector<Polygon>& polygons, const std::string& title, double asked) {
  const double drawn = picture_width(asked);
  double width = drawn;  // more of it where names are long
  for (const Polygon& polygon : polygons) {
    width = std::max(width, text_left(drawn) + text_room(polygon) + kPolygonMargin);
  }
  SvgWriter rehearsal({width, 1, "", ""});  // only to find the height
  const double height = write_all(rehearsal, polygons, title, drawn, width);
  SvgWriter svg({width, height, title, kPolygonStyle}, {{"class", "hp-polygon"}});
  svg.element("rect", {{"width", width}, {"height", height}, {"fill", "#fff"}});
  write_all(svg, polygons, title, drawn, width);
  return std::move(svg).finish();
}

}  // namespace higherpair
