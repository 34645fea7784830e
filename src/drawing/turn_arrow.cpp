#include "turn_arrow.hpp"

#include "outline.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kArcStep = kPi / 24;

}  // namespace

std::vector<double> arc_of(const TurnArrow& arrow) {
  std::vector<double> points;
  const int count = 1 + static_cast<int>(std::abs(arrow.turn) / kArcStep);
  for (int i = 0; i <= count; ++i) {
    append(points, arrow.center + arrow.radius * unit_vector(arrow.from + arrow.turn * i / count));
  }
  return points;
}

std::vector<double> head_of(const TurnArrow& arrow, double longest) {
  const Vector2d outward = unit_vector(arrow.from + arrow.turn);
  const Vector2d base = arrow.center + arrow.radius * outward;
  const double length = std::min(longest, arrow.radius * std::abs(arrow.turn));
  const Vector2d along = std::copysign(length, arrow.turn) * perp(outward);
  const Vector2d a = base + 0.4 * length * outward, b = base - 0.4 * length * outward, tip = base + along;
  return {tip.x(), tip.y(), a.x(), a.y(), b.x(), b.y()};
}

}  // namespace higherpair
