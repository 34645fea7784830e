#include "polygon_layout.hpp"

#include "point_labels.hpp"
#include "rich_text.hpp"
#include "text_layout.hpp"
#include "ticks.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace higherpair {
namespace {

constexpr double kTallest = 400;  // drawn part of a polygon of motion, and of forces [px]
constexpr double kTallestForces = 240;
constexpr double kApart = 11;  // between arrows that would cover each other [px]
constexpr double kNamed = 14;  // shortest arrow that gets a name [px]

// Contains the pole and all arrows.
Eigen::AlignedBox2d polygon_extent(const Polygon& polygon) {
  Eigen::AlignedBox2d extent(Vector2d::Zero(), Vector2d::Zero());
  for (const PolygonArrow& arrow : polygon.arrows) extent.extend(arrow.from).extend(arrow.to);
  return extent;
}

// The direction of the line through the pole on which all arrows lie; none if they do not.
std::optional<Vector2d> common_line(const Polygon& polygon, double longest) {
  const auto first = std::max_element(polygon.arrows.begin(), polygon.arrows.end(),
                                      [](const PolygonArrow& a, const PolygonArrow& b) {
                                        return (a.to - a.from).squaredNorm() < (b.to - b.from).squaredNorm();
                                      });
  if (first == polygon.arrows.end()) return std::nullopt;
  const Vector2d along = (first->to - first->from).normalized();
  const double flat = polygon.kind == Polygon::Kind::kForce ? kFlatForces : kFlatMotion;
  const bool all = std::all_of(polygon.arrows.begin(), polygon.arrows.end(), [&](const PolygonArrow& arrow) {
    return std::abs(cross(along, arrow.to)) < flat * longest;
  });
  return all ? std::optional(along) : std::nullopt;
}

void set_ends(PolygonLayout& layout, const std::optional<Vector2d>& along_W) {
  double shift = 0;
  Vector2d across = Vector2d::Zero();
  if (along_W) {
    across = perp(Vector2d(along_W->x(), -along_W->y()));
    if (across.y() < 0) across = -across;
  }
  for (const PolygonArrow& arrow : layout.polygon->arrows) {
    layout.ends.emplace_back(layout.px(arrow.from) + shift * across, layout.px(arrow.to) + shift * across);
    if (along_W && layout.is_long(layout.ends.size() - 1)) shift += kApart;
  }
}

// Points along the arrows, for labels to keep clear of.
std::vector<TextBox> ink_of(const PolygonLayout& layout) {
  constexpr double kStep = 5;
  constexpr double kAway = 1.5;
  std::vector<TextBox> boxes;
  for (const auto& [from, to] : layout.ends) {
    const double length = (to - from).norm();
    for (double s = 0; s <= length; s += kStep) {
      const Vector2d p = from + s / length * (to - from);
      boxes.push_back({p.x() - kAway, p.y() - kAway, p.x() + kAway, p.y() + kAway});
    }
  }
  return boxes;
}

std::vector<PolygonPoint> merged_points(const PolygonLayout& layout) {
  std::vector<PolygonPoint> merged;
  if (!layout.polygon->pole.empty()) merged.push_back({layout.polygon->pole, Vector2d::Zero()});
  for (const PolygonPoint& point : layout.polygon->points) {
    const auto same = std::find_if(merged.begin(), merged.end(), [&](const PolygonPoint& other) {
      return (other.at - point.at).norm() < kSameLabelledPoint * layout.longest;
    });
    if (same == merged.end()) {
      merged.push_back(point);
    } else {
      same->name += ", " + point.name;
    }
  }
  return merged;
}

}  // namespace

bool PolygonLayout::is_long(std::size_t arrow) const {
  return (ends[arrow].second - ends[arrow].first).norm() >= kNamed;
}

std::string PolygonLayout::unit() const {
  return printed_unit(polygon->unit, exponent);
}

PolygonLayout lay_out(const Polygon& polygon, double width, double top) {
  PolygonLayout layout;
  layout.polygon = &polygon;
  layout.width = width;
  layout.top = top;
  layout.bottom = top + kPolygonLine;
  for (const PolygonArrow& arrow : polygon.arrows) {
    layout.longest = std::max(layout.longest, (arrow.to - arrow.from).norm());
  }
  if (!(layout.longest > 0)) {
    return layout;
  }
  layout.exponent = make_ticks(0, layout.longest, "", 4).exponent;
  const bool is_force = polygon.kind == Polygon::Kind::kForce;
  const auto line = common_line(polygon, layout.longest);
  layout.flat = line.has_value() && polygon.arrows.size() > 1;
  const Eigen::AlignedBox2d extent = polygon_extent(polygon);
  const Vector2d size = extent.sizes();
  const double room = kDrawnShare * width - 2 * kPolygonAround;
  layout.scale =
      std::min(room / std::max(size.x(), kThinPolygon * layout.longest),
               (is_force ? kTallestForces : kTallest) / std::max(size.y(), kThinPolygon * layout.longest));
  const double left = kPolygonMargin + kPolygonAround + std::max(0.0, (room - size.x() * layout.scale) / 2);
  layout.origin = {left - extent.min().x() * layout.scale,
                   top + kPolygonLine + kPolygonAround + extent.max().y() * layout.scale};
  set_ends(layout, layout.flat ? line : std::nullopt);
  double lowest = layout.origin.y() - extent.min().y() * layout.scale;
  for (const auto& [from, to] : layout.ends) lowest = std::max({lowest, from.y(), to.y()});
  layout.bottom = lowest + kPolygonAround + kPolygonLine;
  return layout;
}

std::vector<PolygonLabel> place_polygon_labels(const PolygonLayout& layout) {
  std::vector<PolygonLabel> labels;
  for (const PolygonPoint& point : merged_points(layout)) {
    labels.push_back({point.name, true, layout.px(point.at)});
  }
  for (std::size_t i = 0; i < layout.ends.size(); ++i) {
    const auto& [from, to] = layout.ends[i];
    if (layout.is_long(i)) labels.push_back({layout.polygon->arrows[i].name, false, (from + to) / 2});
  }
  std::vector<LabelledPoint> places;
  for (const PolygonLabel& label : labels) {
    LabelledPoint& place = places.emplace_back();
    place.x = label.names.x();
    place.y = label.names.y();
    place.width = rich_width(label.text, kPolygonFont) + 4;
  }
  const TextBox frame = {4, layout.top + kPolygonLine, kDrawnShare * layout.width + kPolygonAround,
                         layout.bottom - kPolygonLine};
  place_labels(places, frame, ink_of(layout));
  std::vector<PolygonLabel> shown;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const LabelledPoint& place = places[i];
    if (!place.shown) continue;
    labels[i].at = {place.box.left + 2, place.box.bottom - 3};
    labels[i].width = place.width - 4;
    labels[i].far = place.far;
    shown.push_back(labels[i]);
  }
  return shown;
}

}  // namespace higherpair
