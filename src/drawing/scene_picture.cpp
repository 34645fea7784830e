#include "scene_picture.hpp"

#include "draw_foot.hpp"
#include "higherpair/drawing/printed_number.hpp"
#include "higherpair/numeric/contains.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr double kFont = 14;  // [px]
constexpr double kTargetRadius = 3.5;
constexpr double kInkEvery = 5;  // distance of the points that labels keep clear of [px]

using Kind = Shape::Kind;

// The numbers of a shape of the scene, mapped to px: points of paths and arrows, centre and radius of
// circles.
std::vector<double> on_screen(const Scene& scene, const Shape& shape, const Screen& screen) {
  const Scene::Place& place = scene.places[shape.body];
  const double c = std::cos(place.theta), s = std::sin(place.theta);
  std::vector<double> px = shape.numbers;
  const std::size_t points = shape.kind == Kind::kCircle || shape.kind == Kind::kText ? 2 : px.size();
  for (std::size_t i = 0; i + 1 < points; i += 2) {
    const Vector2d p(place.x + c * px[i] - s * px[i + 1], place.y + s * px[i] + c * px[i + 1]);
    const Vector2d q = screen(p);
    px[i] = q.x();
    px[i + 1] = q.y();
  }
  if (shape.kind == Kind::kCircle) {
    px[2] *= screen.scale;
  } else if (shape.kind == Kind::kText) {
    const Vector2d d(px[2], px[3]);
    px[2] = c * d.x() - s * d.y();
    px[3] = -(s * d.x() + c * d.y());
  }
  return px;
}

// The colour of a filled shape is that of its area (its lines stay black), of any other shape that of its
// lines.
std::string colour_of(const Shape& shape, bool ghost) {
  const bool filled = shape.closed && !shape.outline;
  std::string style = shape.outline ? "fill:none" : "";
  if (!shape.colour.empty() && !ghost) {
    if (!style.empty()) style += ';';
    style += filled ? "fill:" : "stroke:";
    style += shape.colour;
  }
  return style;
}

std::string length_text(double length_mm, const PictureUnit& unit) {
  return printed_significant(length_mm / kMillimetresPerMetre / unit.si, 4) + " " + unit.name;
}

}  // namespace

void ScenePicture::draw(const Scene& scene, bool ghost) {
  for (int role = 0; role < kRoleCount; ++role) {
    const auto draw_of_role = [&](const auto& shapes) {
      for (const Shape& shape : shapes) {
        if (static_cast<int>(shape.role) == role && is_shown(shape, ghost)) {
          draw(scene, shape, ghost);
        }
      }
    };
    draw_of_role(scene.fixed);
    draw_of_role(scene.moving);
  }
}

void ScenePicture::draw_targets(const std::vector<Vector2d>& targets) {
  for (const Vector2d& target : targets) {
    const Vector2d px = screen_(target);
    svg_.element("circle", {{"class", "target"},
                            {"style", "fill:#fff;stroke:#b0306a;stroke-width:1.6"},
                            {"data-role", "target"},
                            {"cx", px.x()},
                            {"cy", px.y()},
                            {"r", kTargetRadius}});
  }
}

void ScenePicture::draw_labels(const Vector2d& size) {
  place_labels(labels_, ink_, size, kFont);
  for (const Label& label : labels_) {
    svg_.text({{"class", label.is_body ? "label name" : "label"},
               {"data-role", label.role},
               {"data-name", label.text},
               {"x", label.placed.x()},
               {"y", label.placed.y()}},
              label.text);
  }
}

bool ScenePicture::is_shown(const Shape& shape, bool ghost) const {
  const bool moves = shape.role == Role::kBody || shape.role == Role::kLink || shape.role == Role::kJoint;
  return !shape.numbers.empty() && (!ghost || (moves && shape.body > 0)) && contains(layers_, shape.role);
}

void ScenePicture::draw(const Scene& scene, const Shape& shape, bool ghost) {
  const std::vector<double> px = on_screen(scene, shape, screen_);
  const std::string role(name_of(shape.role));
  const std::string style = role + (shape.closed && !shape.outline ? " filled" : "");
  const bool told = shape.kind != Kind::kText && !shape.text.empty();
  if (told) {
    svg_.open("g", {});
    svg_.element("title", {}, shape.text);
  }
  switch (shape.kind) {
    case Kind::kText:
      add_label(shape, px);
      return;
    case Kind::kCircle:
      svg_.element("circle", {{"class", style},
                              {"style", colour_of(shape, ghost)},
                              {"data-role", role},
                              {"data-name", shape.name},
                              {"cx", px[0]},
                              {"cy", px[1]},
                              {"r", px[2]}});
      break;
    case Kind::kPath:
      svg_.element("path", {{"class", style},
                            {"style", colour_of(shape, ghost)},
                            {"data-role", role},
                            {"data-name", shape.name},
                            {"d", SvgPath().polyline(px, shape.closed)}});
      break;
    case Kind::kArrow:
      draw_arrow(svg_, px, role, role, shape.name);
      break;
  }
  if (told) svg_.close();
  if (!ghost) add_ink(shape, px);
}

void ScenePicture::add_label(const Shape& shape, const std::vector<double>& px) {
  labels_.push_back(
      {px.size() > 4 ? fmt::format("{} = {}", shape.text, length_text(px[4], length_)) : shape.text,
       shape.name.find('.') == std::string::npos,
       {px[0], px[1]},
       {px[2], px[3]},
       {0, 0},
       std::string(name_of(shape.role)),
       px.size() > 4});
}

void ScenePicture::add_ink(const Shape& shape, std::vector<double> px) {
  if (shape.kind == Kind::kCircle) {
    const int count = std::clamp(static_cast<int>(2 * kPi * px[2] / kInkEvery), 4, 400);
    for (int i = 0; i < count; ++i) {
      ink_.emplace_back(Vector2d(px[0], px[1]) + px[2] * unit_vector(2 * kPi * i / count));
    }
    return;
  }
  if (shape.closed) px.insert(px.end(), {px[0], px[1]});  // the last side, often a long one
  for (std::size_t i = 0; i + 3 < px.size(); i += 2) {
    const Vector2d a(px[i], px[i + 1]), b(px[i + 2], px[i + 3]);
    if (!a.allFinite() || !b.allFinite()) {
      continue;
    }
    const int count = std::clamp(static_cast<int>((b - a).norm() / kInkEvery), 1, 400);
    for (int k = 0; k < count; ++k) {
      ink_.emplace_back(a + (b - a) * k / count);
    }
  }
}

}  // namespace higherpair
