#include "higherpair/drawing/outline_svg.hpp"

#include "svg_writer.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr double kPxPerMetre = 96 / 0.0254;
constexpr double kOutlineMargin = 10;  // [px]
constexpr double kCross = 6;           // half the size of the cross at the origin [px]

constexpr const char* kOutlineStyle = R"(
.hp-outline path { fill: none; stroke: #000; stroke-width: 0.5; }
)";

class Sheet {
public:
  explicit Sheet(const Eigen::AlignedBox2d& box)
      : origin_(kOutlineMargin - kPxPerMetre * box.min().x(), kOutlineMargin + kPxPerMetre * box.max().y()),
        size_(kPxPerMetre * box.sizes() + Vector2d::Constant(2 * kOutlineMargin)) {}

  [[nodiscard]] const Vector2d& origin() const { return origin_; }
  [[nodiscard]] const Vector2d& size() const { return size_; }
  [[nodiscard]] bool has(const Vector2d& px) const {
    return (px.array() >= 0).all() && (px.array() <= size_.array()).all();
  }
  [[nodiscard]] Vector2d at(const Vector2d& p_B) const {
    return {origin_.x() + kPxPerMetre * p_B.x(), origin_.y() - kPxPerMetre * p_B.y()};
  }

private:
  Vector2d origin_;
  Vector2d size_;
};

SvgPath path_of(const ArcPolyline& line, const Sheet& sheet) {
  SvgPath path;
  const std::size_t count = line.vertices.size();
  const Vector2d first = sheet.at(line.vertices.front().p_B);
  path.move_to(first.x(), first.y());
  for (std::size_t i = 0; i < (line.closed ? count : count - 1); ++i) {
    const double b = line.vertices[i].bulge;
    const Vector2d from = sheet.at(line.vertices[i].p_B);
    const Vector2d to = sheet.at(line.vertices[(i + 1) % count].p_B);
    if (b == 0) {
      path.line_to(to.x(), to.y());
    } else {
      // A counter-clockwise arc also appears counter-clockwise on the screen.
      path.arc_to((to - from).norm() * (1 + b * b) / (4 * std::abs(b)), std::abs(b) > 1, b < 0, to.x(),
                  to.y());
    }
  }
  if (line.closed) path.close();
  return path;
}

}  // namespace

std::string outline_svg(const std::vector<NamedOutline>& outlines, const std::string& title,
                        const PictureUnit& length) {
  Eigen::AlignedBox2d box;
  for (const NamedOutline& outline : outlines) {
    box.extend(box_of(outline.line));
  }
  const Sheet sheet(box);
  const Vector2d& origin = sheet.origin();
  SvgWriter svg(
      {.width = sheet.size().x(), .height = sheet.size().y(), .title = title, .style = kOutlineStyle},
      {{"class", "hp-outline"},
       {"data-scale", fmt::format("{:.12g}", kPxPerMetre * length.si)},
       {"data-origin", svg_number(origin.x()) + " " + svg_number(origin.y())}});
  for (const NamedOutline& outline : outlines) {
    svg.element("path",
                {{"data-role", "outline"}, {"data-name", outline.name}, {"d", path_of(outline.line, sheet)}});
  }
  if (sheet.has(origin)) {
    SvgPath cross;
    cross.move_to(origin.x() - kCross, origin.y()).line_to(origin.x() + kCross, origin.y());
    cross.move_to(origin.x(), origin.y() - kCross).line_to(origin.x(), origin.y() + kCross);
    svg.element("path", {{"data-role", "origin"}, {"d", cross}});
  }
  return std::move(svg).finish();
}

}  // namespace higherpair
