#include "draw_foot.hpp"

#include "higherpair/geometry/pose.hpp"
#include "higherpair/numeric/contains.hpp"
#include "text_layout.hpp"
#include "ticks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr double kFootHead = 8;     // length of an arrow's head [px]
constexpr double kShortest = 0.5;   // shortest arrow that is drawn [px]
constexpr double kFootMargin = 12;  // [px], as all lengths here
constexpr double kFirstLine = 26;
constexpr double kLine = 20;  // from one line of samples to the next
constexpr double kFootFont = 14;
constexpr double kArcRadius = 6;
constexpr double kLongestFootArrow = 90;

// The largest of the numbers 1, 2 or 5 times a power of ten that do not exceed the value.
double round_down(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

std::string quantity(double value, const PictureUnit& unit) {
  return printed_significant(value, 6) + " " + printed_unit(unit.name);
}

}  // namespace

void draw_arrow(SvgWriter& svg, std::span<const double> px, const std::string& style, const std::string& role,
                const std::string& name) {
  const Vector2d from(px[0], px[1]), to(px[2], px[3]);
  const double length = (to - from).norm();
  if (!(length > kShortest)) {
    return;
  }
  svg.element("path",
              {{"class", style}, {"data-role", role}, {"data-name", name}, {"d", SvgPath().polyline(px)}});
  const Vector2d d = (to - from) / length * std::min(kFootHead, length);
  const Vector2d a = to - d + 0.32 * perp(d), b = to - d - 0.32 * perp(d);
  const std::vector<double> head{to.x(), to.y(), a.x(), a.y(), b.x(), b.y()};
  svg.element(
      "path",
      {{"class", style + " head"}, {"data-role", role + "-head"}, {"d", SvgPath().polyline(head, true)}});
}

DrawFoot::DrawFoot(const Scene& scene, const DrawSettings& settings, const std::vector<Role>& layers,
                   double scale, double width, const std::string& caption)
    : caption_(caption), width_(width) {
  const double unit = settings.length.si * kMillimetresPerMetre;
  const double length = round_down(settings.width / scale / unit / 5);
  samples_.push_back({"scale", length * unit * scale, 0, quantity(length, settings.length)});
  const auto add_arrow = [&](Role role, double mm_per_si, const PictureUnit& of) {
    const double px = scale * mm_per_si * of.si;
    if (!contains(layers, role) || !(px > 0)) return;
    const double value = round_down(std::min(kLongestFootArrow, 0.12 * settings.width) / px);
    samples_.push_back({std::string(name_of(role)), value * px, 0, quantity(value, of)});
  };
  add_arrow(Role::kVelocity, scene.velocity_scale * kMillimetresPerMetre, settings.velocity);
  add_arrow(Role::kAcceleration, scene.acceleration_scale * kMillimetresPerMetre, settings.acceleration);
  add_arrow(Role::kForce, scene.force_scale, settings.force);
  const double turn = scene.torque_scale * settings.torque.si;
  if (contains(layers, Role::kForce) && turn > 0) {
    const double value = round_down(1.5 * kPi / turn);
    samples_.push_back({"force", 2 * kArcRadius, value * turn, quantity(value, settings.torque)});
  }
  lay_out(width);
}

void DrawFoot::lay_out(double width) {
  double x = kFootMargin;
  int line = 0;
  for (Sample& sample : samples_) {
    const bool above = &sample == &samples_.front();  // its text is above it
    const double needed = sample.length + (above ? 0 : 6 + text_width(sample.text, kFootFont));
    if (x > kFootMargin && x + needed > width - kFootMargin) {
      x = kFootMargin;
      ++line;
    }
    sample.x = x;
    sample.line = line;
    x += needed + 2 * kFootMargin;
  }
  if (x + text_width(caption_, kFootFont) > width - kFootMargin) ++line;
  caption_line_ = line;
}

double DrawFoot::height() const {
  return kFirstLine + kLine * (caption_.empty() ? samples_.back().line : caption_line_);
}

void DrawFoot::draw(SvgWriter& svg, double top) const {
  for (const Sample& sample : samples_) {
    draw_sample(svg, sample, top + kFirstLine - 9 + kLine * sample.line);
  }
  if (!caption_.empty()) {
    svg.text({{"class", "caption"},
              {"style", "text-anchor:end"},
              {"data-role", "caption"},
              {"x", width_ - kFootMargin},
              {"y", top + kFirstLine - 9 + kLine * caption_line_}},
             caption_);
  }
}

void DrawFoot::draw_sample(SvgWriter& svg, const Sample& sample, double y) const {
  const double left = sample.x, right = sample.x + sample.length;
  if (&sample == &samples_.front()) {
    SvgPath bar;
    bar.move_to(left, y - 4).line_to(left, y + 4).move_to(left, y).line_to(right, y);
    svg.element(
        "path",
        {{"class", "scale"}, {"data-role", "scale"}, {"d", bar.move_to(right, y - 4).line_to(right, y + 4)}});
    svg.text({{"data-role", "scale"}, {"x", (left + right) / 2}, {"y", y - 10}}, sample.text);
    return;
  }
  if (sample.turn > 0) {
    const Vector2d center(left + kArcRadius, y);
    const auto at = [&](double turn) {
      const Vector2d d = unit_vector(kPi / 2 + turn);
      return Vector2d(center.x() + kArcRadius * d.x(), center.y() - kArcRadius * d.y());
    };
    const Vector2d from = at(0), to = at(sample.turn);
    SvgPath arc;
    arc.move_to(from.x(), from.y()).arc_to(kArcRadius, sample.turn > kPi, false, to.x(), to.y());
    svg.element("path",
                {{"class", sample.role}, {"data-role", "scale"}, {"data-name", "torque"}, {"d", arc}});
  } else {
    draw_arrow(svg, std::vector{left, y, right, y}, sample.role, "scale", sample.role);
  }
  svg.text(
      {{"class", "sample"}, {"data-role", "scale"}, {"data-name", sample.role}, {"x", right + 6}, {"y", y}},
      sample.text);
}

}  // namespace higherpair
