#include "outline.hpp"

#include "higherpair/geometry/pose.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kPointsPerTurn = 96;

// Convex hull by Andrew's monotone chain, counter-clockwise.
std::vector<Vector2d> hull_of(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) {
    return points;
  }
  std::vector<Vector2d> hull;
  const auto add = [&](const Vector2d& p, std::size_t least) {
    while (hull.size() >= least + 2 &&
           cross<double>(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vector2d& p : points) {
    add(p, 0);
  }
  const std::size_t lower = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) {
    add(*p, lower);
  }
  hull.pop_back();
  return hull;
}

// Adds an arc about the centre, from the angle `from` to the angle `to`, both included.
void append_arc(std::vector<double>& path, const Vector2d& center, double radius, double from, double to) {
  const int steps =
      std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / (2 * kPi) * kPointsPerTurn)));
  for (int i = 0; i <= steps; ++i) {
    append(path, center + radius * unit_vector(from + (to - from) * i / steps));
  }
}

// Solves y² = 2 ℓ x - q x² for x on the branch of the vertex.
double conic_x(const Curve& curve, double y) {
  const double l = curve.semi_latus;
  return y * y / (l + std::sqrt(std::max(0.0, l * l - curve.q * y * y)));
}

std::vector<double> ellipse(const Curve& curve, double wider) {
  const auto [a, b] = semi_axes(curve);
  const Vector2d middle = center(curve);
  const Vector2d across = perp(curve.axis_B);
  std::vector<double> path;
  for (int i = 0; i < 2 * kPointsPerTurn; ++i) {
    const Vector2d n = unit_vector(kPi * i / kPointsPerTurn);
    append(path, middle + n.x() * (a + wider) * curve.axis_B + n.y() * (b + wider) * across);
  }
  return path;
}

std::vector<double> strip(const Curve& curve, double thickness, const std::array<double, 2>& range) {
  const Vector2d across = perp(curve.axis_B);
  const double sense = curve.side == Side::kOutside ? -1 : 1;
  const bool flat = is_line(curve);
  const int steps = flat ? 1 : kPointsPerTurn;
  std::vector<double> path;
  for (int i = 0; i <= steps; ++i) {
    const double y = std::lerp(range[0], range[1], static_cast<double>(i) / steps);
    append(path, curve.vertex_B + y * across + (flat ? 0 : conic_x(curve, y)) * curve.axis_B);
  }
  const double deepest = flat ? 0 : std::max(conic_x(curve, range[0]), conic_x(curve, range[1]));
  const double back = sense > 0 ? deepest + thickness : -thickness;
  append(path, curve.vertex_B + range[1] * across + back * curve.axis_B);
  append(path, curve.vertex_B + range[0] * across + back * curve.axis_B);
  return path;
}

}  // namespace

void append_break(std::vector<double>& path) {
  path.insert(path.end(), {kNoValue, kNoValue});
}

std::vector<double> rounded_hull(std::vector<Vector2d> points, double radius) {
  const std::vector<Vector2d> hull = hull_of(std::move(points));
  std::vector<double> path;
  const std::size_t n = hull.size();
  if (n == 1) {
    append_arc(path, hull[0], radius, 0, 2 * kPi);
    return path;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d in = hull[i] - hull[(i + n - 1) % n];
    const Vector2d out = hull[(i + 1) % n] - hull[i];
    const double from = angle_of(in) - kPi / 2;
    const double turn = angle_from_to(in, out);
    append_arc(path, hull[i], radius, from, from + (turn <= 0 ? kPi : turn));
  }
  return path;
}

std::vector<double> rectangle(const Vector2d& middle, const Vector2d& along, double length, double width) {
  const Vector2d a = length / 2 * along;
  const Vector2d b = width / 2 * perp(along);
  std::vector<double> path;
  for (const Vector2d& corner : {Vector2d(-a - b), Vector2d(a - b), Vector2d(a + b), Vector2d(b - a)}) {
    append(path, middle + corner);
  }
  return path;
}

std::vector<double> material(const Curve& curve, double thickness, const std::array<double, 2>& range) {
  if (is_line(curve) || curve.q <= 0) {
    return strip(curve, thickness, range);
  }
  if (curve.side == Side::kInside) {
    return ellipse(curve, 0);
  }
  std::vector<double> ring = ellipse(curve, thickness);
  append_break(ring);
  const std::vector<double> hole = ellipse(curve, 0);
  ring.insert(ring.end(), hole.begin(), hole.end());
  return ring;
}

}  // namespace higherpair
