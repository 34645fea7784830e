#include "draw_foot.hpp"
#include "higherpair/drawing/picture.hpp"
#include "higherpair/numeric/contains.hpp"
#include "scene_picture.hpp"
#include "svg_writer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr double kCaptionRoom = 24;    // below a picture of a strip [px]
constexpr double kNarrowest = 240;     // least width of a picture, including room on both sides [px]
constexpr double kWidestStrip = 4000;  // of pictures side by side; more of them are in several lines [px]

// Widths in px; dashes distinguish the lines where there are no colours.
constexpr const char* kStyle = R"(
svg { background: #fff; }
path, circle, line { fill: none; stroke: #111; stroke-width: 1.4; stroke-linejoin: round; stroke-linecap: round; }
text { font: 14px "Helvetica Neue", Arial, "Liberation Sans", sans-serif; fill: #111; text-anchor: middle;
  dominant-baseline: central; stroke: #fff; stroke-width: 3px; paint-order: stroke; stroke-linejoin: round; }
text.name { font-style: italic; }
.ground { stroke-width: 1; } .ground.filled { fill: #fff; stroke-width: 1.4; }
.body { fill: #dce6f0; fill-rule: evenodd; }
.link { fill: #f7f7f7; } .joint.filled { fill: #fff; }
.gear { stroke: #555; stroke-dasharray: 12 3 2 3; stroke-width: 1.1; }
.spring { stroke-width: 1.2; }
.normal, .tangent { stroke: #555; stroke-width: 0.8; stroke-dasharray: 8 3 1.5 3; }
.curvature { stroke: #0072b2; stroke-width: 1.1; stroke-dasharray: 5 3; }
.curvature.filled { fill: #0072b2; stroke: none; }
.contact { fill: #d55e00; stroke: #fff; stroke-width: 0.8; }
.linkage { stroke: #d55e00; stroke-width: 2.6; } .linkage.filled { fill: #fff; stroke-width: 1.8; }
.center { fill: #b0508a; stroke: #b0508a; stroke-width: 1.4; } text[data-role=center] { fill: #b0508a; }
.driver { stroke: #56419e; stroke-width: 2; } .driver.head, .driver.filled { fill: #56419e; }
.trace { stroke: #009e73; stroke-width: 1.3; }
.velocity { stroke: #0072b2; stroke-width: 1.6; } .velocity.head { fill: #0072b2; }
.acceleration { stroke: #d55e00; stroke-width: 1.6; stroke-dasharray: 6 2; }
.acceleration.head { fill: #d55e00; stroke-dasharray: none; }
.force { stroke: #b0306a; stroke-width: 2.2; } .force.head, .force.filled { fill: #b0306a; }
.ghost path, .ghost circle { fill: none; stroke: #9aa5b1; stroke-width: 0.8; }
.scale { stroke-width: 1.2; } text.sample { text-anchor: start; stroke: none; fill: #111; }
)";

// How many pictures of a strip are side by side: all of them, or as many as make about a square.
std::size_t pictures_in_line(std::size_t count, double width, double height) {
  const double shown = static_cast<double>(count);
  const double most =
      std::max(std::floor(kWidestStrip / width), std::ceil(std::sqrt(shown * height / width)));
  const double lines = std::ceil(shown / std::clamp(most, 1.0, shown));
  return static_cast<std::size_t>(std::ceil(shown / lines));
}

// With the usual numbers in place of those with which nothing can be drawn.
DrawSettings usable(DrawSettings settings) {
  constexpr double kMost = 1e100;  // a picture of this size has numbers that a double holds
  const DrawSettings usual;
  const auto use = [](double& number, double otherwise) {
    number = number >= 1 / kMost && number <= kMost ? number : otherwise;
  };
  use(settings.width, usual.width);
  use(settings.most_height, usual.most_height);
  for (PictureUnit DrawSettings::*unit :
       {&DrawSettings::length, &DrawSettings::velocity, &DrawSettings::acceleration, &DrawSettings::force,
        &DrawSettings::torque}) {
    use((settings.*unit).si, (usual.*unit).si);
  }
  std::erase_if(settings.targets, [](const Vector2d& target) { return !target.allFinite(); });
  return settings;
}

// What the frame has room for: all that moves, and the arrows that are drawn, over the whole motion.
Box view_of(const Scene& scene, const std::vector<Role>& layers) {
  Box view = scene.view;
  for (const auto& [role, box] : scene.rooms) {
    if (contains(layers, role)) view = view.joined(box);
  }
  return view;
}

double caption_room(std::span<const Scene> scenes, bool strip) {
  const bool any = std::any_of(scenes.begin(), scenes.end(),
                               [](const Scene& scene) { return scene.defined && !scene.caption.empty(); });
  return strip && any ? kCaptionRoom : 0;
}

// Where the pictures of a strip are, each with its caption below it, or the only one [px].
struct StripLayout {
  Screen screen;           // of each picture
  Vector2d picture;        // size of one
  double line_height = 0;  // with the captions
  std::size_t columns = 1, lines = 1;

  [[nodiscard]] Vector2d size() const {
    return {picture.x() * static_cast<double>(columns), line_height * static_cast<double>(lines)};
  }
  /// The upper left corner of the picture with an index.
  [[nodiscard]] Vector2d corner(std::size_t index) const {
    return {picture.x() * static_cast<double>(index % columns),
            line_height * static_cast<double>(index / columns)};
  }
};

StripLayout layout_of(std::span<const Scene> scenes, const DrawSettings& settings,
                      const std::vector<Role>& layers) {
  const Box view = view_of(scenes.front(), layers);
  const Vector2d size = view.size();
  const double scale = std::min(settings.width / size.x(), settings.most_height / size.y());
  const double width = std::max(scale * size.x(), std::min(settings.width, kNarrowest));
  const std::size_t count = settings.strip ? scenes.size() : 1;
  StripLayout layout;
  layout.screen = {scale, {width / 2 - scale * (view.low.x() + size.x() / 2), scale * view.high.y()}};
  layout.picture = {width, scale * size.y()};
  layout.line_height = layout.picture.y() + caption_room(scenes, settings.strip);
  layout.columns = pictures_in_line(count, width, layout.picture.y());
  layout.lines = (count + layout.columns - 1) / layout.columns;
  return layout;
}

void draw_caption(SvgWriter& svg, const std::string& caption, const Vector2d& corner,
                  const Vector2d& picture) {
  svg.text({{"class", "caption"},
            {"data-role", "caption"},
            {"x", corner.x() + picture.x() / 2},
            {"y", corner.y() + picture.y() + kCaptionRoom / 2}},
           caption);
}

}  // namespace

std::vector<Role> default_layers() {
  return {Role::kFixed,   Role::kLink,    Role::kBody,   Role::kJoint,   Role::kGear,
          Role::kSpring,  Role::kContact, Role::kNormal, Role::kTangent, Role::kCurvature,
          Role::kLinkage, Role::kTrace,   Role::kDriver, Role::kLabel};
}

std::string draw_svg(std::span<const Scene> scenes, const DrawSettings& given) {
  assert(!scenes.empty());
  const DrawSettings settings = usable(given);
  const std::vector<Role> layers = settings.layers.empty() ? default_layers() : settings.layers;
  const StripLayout layout = layout_of(scenes, settings, layers);
  const Screen& screen = layout.screen;
  const Vector2d whole = layout.size();
  DrawSettings fitted = settings;
  fitted.width = layout.picture.x();
  const std::string caption = settings.strip ? "" : scenes.back().caption;
  const DrawFoot foot(scenes.front(), fitted, layers, screen.scale, whole.x(), caption);
  SvgWriter svg(
      {whole.x(), whole.y() + foot.height(), settings.title, kStyle},
      {{"data-scale", fmt::format("{:.12g}", screen.scale * kMillimetresPerMetre * settings.length.si)},
       {"data-origin", svg_number(screen.origin.x()) + " " + svg_number(screen.origin.y())}});
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const bool ghost = !settings.strip && i + 1 < scenes.size();
    if (!scenes[i].defined) {
      continue;
    }
    const Vector2d corner = layout.corner(settings.strip ? i : 0);
    svg.open("svg", {{"class", ghost ? "ghost" : "scene"},
                     {"x", corner.x()},
                     {"y", corner.y()},
                     {"width", layout.picture.x()},
                     {"height", layout.picture.y()}});
    ScenePicture picture(svg, screen, layers, settings.length);
    picture.draw(scenes[i], ghost);
    if (!ghost) {
      picture.draw_targets(settings.targets);
      picture.draw_labels(layout.picture);
    }
    svg.close();
    if (settings.strip && !scenes[i].caption.empty()) {
      draw_caption(svg, scenes[i].caption, corner, layout.picture);
    }
  }
  foot.draw(svg, whole.y());
  return std::move(svg).finish();
}

}  // namespace higherpair
