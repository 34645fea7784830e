#include "random_law_cam.hpp"

#include "draw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>

namespace higherpair::fire {
namespace {

// A law over one turn that begins and ends with a dwell, and the largest values of its first and second
// derivative.
struct Lift {
  std::string segments;
  double fastest = 0, steepest = 0;
};

Lift random_lift(Draw& draw, double height) {
  constexpr std::array kLaws{"parabolic",          "harmonic",       "cycloidal",      "modified-sine",
                             "modified-trapezoid", "polynomial-345", "polynomial-4567"};
  const int moves = 2 * (1 + draw.pick(2));
  std::vector<double> lengths;
  for (int i = 0; i < 2 * moves + 1; ++i) {
    lengths.push_back(i % 2 == 0 ? draw.between(0.1, 1) : draw.between(0.7, 1.5));
  }
  double sum = 0;
  for (const double length : lengths) {
    sum += length;
  }
  Lift lift;
  double reached = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double over = lengths[i] * 2 * kPi / sum;
    if (i % 2 == 0) {
      lift.segments += fmt::format("  {{ over = {}, law = \"dwell\" }},\n", over);
      continue;
    }
    const double rise = reached != 0 ? -reached : height * draw.between(0.5, 1);
    reached += rise;
    const char* law = kLaws[draw.pick(static_cast<int>(kLaws.size()))];
    lift.segments += fmt::format("  {{ over = {}, law = \"{}\", rise = {} }},\n", over, law, rise);
    // Bounds of the steepest of these laws, polynomial-4567 (see docs/laws.md).
    lift.fastest = std::max(lift.fastest, 2.1875 * std::abs(rise) / over);
    lift.steepest = std::max(lift.steepest, 7.52 * std::abs(rise) / (over * over));
  }
  return lift;
}

std::string law_table(const Lift& lift, double origin, double start) {
  return fmt::format("\n[laws.lift]\norigin = {}\nstart = {}\nsegments = [\n{}]\n", origin, start,
                     lift.segments);
}

}  // namespace

Sketch random_law_cam(std::uint64_t seed) {
  Draw draw(seed);
  const Vector2d O(draw.between(-1, 1), draw.between(-1, 1));
  const double angle = draw.angle();
  const double out = draw.angle();
  const bool swings = draw.chance(0.5);
  const int face = draw.pick(3);              // roller, flat face, knife edge
  const bool flat_arm = swings && face == 1;  // must swing much more slowly than the cam turns
  const double height = draw.between(0.05, 0.3) * (flat_arm ? 0.3 : 1);
  // The arm's length, and the side of the line from the cam's pivot on which the follower's pivot lies.
  const double arm = draw.between(0.8, 2);
  const double side = draw.chance(0.5) ? 1 : -1;
  const Lift lift = random_lift(draw, swings ? side * height / arm : height);
  // With this radius the pitch curve has no radius of curvature below 0.35 of it; a flat face needs more than
  // s + s''.
  const double lever = swings ? arm : 1;
  const double radius = lever * std::max(lift.fastest, lift.steepest / (face == 1 ? 0.8 : 1.2)) *
                        draw.between(swings ? 2 : 1, 4);
  const double beside = swings ? 0 : radius * draw.between(-0.3, 0.3);
  const Vector2d along = unit_vector(out);
  const Vector2d touch = O + std::sqrt(radius * radius - beside * beside) * along + beside * perp(along);

  Sketch sketch = driven_at(O, angle, 2 * kPi);
  const double reach = flat_arm ? arm : std::max(arm, draw.between(1, 2) * radius);
  const Vector2d pivot = swings ? Vector2d(touch - side * reach * perp(along)) : touch;
  const double turned = draw.angle();
  mount(sketch, pivot, turned, swings, out);
  sketch.drivers.front().velocity = 1;
  Shape shape;
  shape.kind = std::array{CurveKind::kCircle, CurveKind::kLine, CurveKind::kPoint}[face];
  const Vector2d p = Rotation<double>::from_angle(-turned) * Vector2d(touch - pivot);
  shape.x = p.x();
  shape.y = p.y();
  shape.a = radius * draw.between(0.05, 0.3);
  shape.angle = out + kPi - turned;
  sketch.bodies[2].curves = {shape};

  Sketch twin = sketch;
  twin.bodies[2].curves.clear();
  twin.tables = law_table(lift, 0, swings ? turned : 0);
  Sketch::Driver by_law;
  by_law.joint = 1;
  by_law.law = "lift";
  twin.drivers.push_back(by_law);
  sketch.tables = law_table(lift, angle, 0);
  sketch.bodies[1].outlines.push_back({{}, false, 0, R"({ type = "cam", law = "lift", contact = "k0" })"});
  sketch.contacts.push_back({{1, 0}, {2, 0}, false, true});
  sketch.twin = {twin};
  return sketch;
}

}  // namespace higherpair::fire
