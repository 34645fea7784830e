#include "random_flank.hpp"

#include "higherpair/geometry/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <fmt/format.h>

namespace higherpair::fire {
namespace {

using JointKind = Sketch::JointKind;

class Draw {
public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  int pick(int count) { return static_cast<int>(between(0, count)); }
  bool chance(double p) { return between(0, 1) < p; }
  double angle() { return between(-kPi, kPi); }

private:
  std::mt19937_64 engine_;
};

Sketch::Point as_point(const Vector2d& p) {
  return {p.x(), p.y()};
}

// A body that turns about O on ground and is driven from `angle`.
Sketch driven_at(const Vector2d& O, double angle, double range) {
  Sketch sketch;
  sketch.bodies.front().points = {as_point(O)};
  sketch.bodies.push_back({O.x(), O.y(), angle, {{}}, {}, {}});
  sketch.joints.push_back({JointKind::kRevolute, {0, 0}, {1, 0}});
  sketch.drivers.push_back({0, angle, angle + range});
  return sketch;
}

// Another body on ground: about its origin, or along a direction.
void mount(Sketch& sketch, const Vector2d& at, double angle, bool turns, double direction) {
  sketch.bodies.front().points.push_back(as_point(at));
  sketch.bodies.push_back({at.x(), at.y(), angle, {{}}, {}, {}});
  sketch.joints.push_back({turns ? JointKind::kRevolute : JointKind::kPrismatic, {0, 1}, {2, 0}, direction});
}

// A law over one turn that begins and ends with a dwell, and the largest of its first and second derivative.
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
    const char* law = kLaws[static_cast<std::size_t>(draw.pick(static_cast<int>(kLaws.size())))];
    lift.segments += fmt::format("  {{ over = {}, law = \"{}\", rise = {} }},\n", over, law, rise);
    // The steepest of the laws is polynomial-4567: docs/laws.md.
    lift.fastest = std::max(lift.fastest, 2.1875 * std::abs(rise) / over);
    lift.steepest = std::max(lift.steepest, 7.52 * std::abs(rise) / (over * over));
  }
  return lift;
}

std::string law_table(const Lift& lift, double origin, double start) {
  return fmt::format("\n[laws.lift]\norigin = {}\nstart = {}\nsegments = [\n{}]\n", origin, start,
                     lift.segments);
}

double involute(double alpha) {
  return std::tan(alpha) - alpha;
}

}  // namespace

Sketch random_law_cam(std::uint64_t seed) {
  Draw draw(seed);
  const Vector2d O(draw.between(-1, 1), draw.between(-1, 1));
  const double angle = draw.angle();
  const double out = draw.angle();
  const bool swings = draw.chance(0.5);
  const int face = draw.pick(3);              // a roller, a flat face, a knife edge
  const bool flat_arm = swings && face == 1;  // must swing much slower than the cam turns
  const double height = draw.between(0.05, 0.3) * (flat_arm ? 0.3 : 1);
  // The arm's length and the heading from the cam's pivot to the follower's: both turns of it.
  const double arm = draw.between(0.8, 2);
  const double side = draw.chance(0.5) ? 1 : -1;
  const Lift lift = random_lift(draw, swings ? side * height / arm : height);
  // Then the pitch curve is nowhere sharper than 0.35 of its radius; a flat face needs more than s + s''.
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
  shape.kind =
      std::array{CurveKind::kCircle, CurveKind::kLine, CurveKind::kPoint}[static_cast<std::size_t>(face)];
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

Sketch random_flank_pair(std::uint64_t seed) {
  Draw draw(seed);
  const double module = draw.between(0.02, 0.1);
  const double alpha = draw.between(20, 25) * kPi / 180;
  const std::array teeth{20 + draw.pick(40), 20 + draw.pick(40)};
  const std::array shift{draw.between(-0.1, 0.3), draw.between(-0.1, 0.3)};
  const double mean = module * (teeth[0] + teeth[1]) / 2;
  // The angle of a mesh without play, by inv = inv α + 2 tan α (x1 + x2)/(z1 + z2), and a little more.
  const double wanted = involute(alpha) + 2 * std::tan(alpha) * (shift[0] + shift[1]) / (teeth[0] + teeth[1]);
  double working = alpha;
  for (int i = 0; i < 50; ++i) {
    working -= (involute(working) - wanted) / std::pow(std::tan(working), 2);
  }
  working += draw.between(0, 0.02);
  const double distance = mean * std::cos(alpha) / std::cos(working);
  const double action = distance * std::sin(working);  // between the base circles

  std::array<double, 2> base{}, start{}, root{}, tip{};
  std::array<std::string, 2> flank;
  const bool left = draw.chance(0.5);
  for (std::size_t i = 0; i < 2; ++i) {
    const double pitch = module * teeth[i] / 2;
    base[i] = pitch * std::cos(alpha);
    start[i] = (kPi / 2 + 2 * shift[i] * std::tan(alpha)) / teeth[i] + involute(alpha);
    root[i] = (pitch * std::sin(alpha) - (1 - shift[i]) * module / std::sin(alpha)) / base[i];
    tip[i] = std::sqrt(std::pow((pitch + (1 + shift[i]) * module) / base[i], 2) - 1);
    flank[i] = fmt::format(
        R"({{ type = "involute", center = [0, 0], module = {}, teeth = {}, pressure_angle = {}, profile_shift = {}, hand = "{}" }})",
        module, teeth[i], alpha, shift[i], left ? "left" : "right");
  }
  // The rolls of both flanks add up to the line of action; the left one is mirrored for the right.
  const double from = std::max(root[0], (action - base[1] * tip[1]) / base[0]);
  const double to = std::min(tip[0], (action - base[1] * root[1]) / base[0]);
  const double roll = std::lerp(from, to, draw.between(0.02, 0.3));
  const double range = (to - from) * draw.between(0.1, 0.65);
  const double hand = left ? 1 : -1;
  const double out = draw.angle();
  const double u = out + hand * (roll - working - start[0]);
  const double other = (action - base[0] * roll) / base[1];
  const Vector2d O(draw.between(-1, 1), draw.between(-1, 1));

  Sketch sketch = driven_at(O, u, hand * range);
  mount(sketch, O + distance * unit_vector(out), out + kPi + hand * (other - working - start[1]), true, 0);
  sketch.drivers.front().velocity = draw.between(-5, 5);
  sketch.drivers.front().acceleration = draw.between(-10, 10);
  Sketch twin = sketch;
  twin.joints.push_back({JointKind::kGears, {1, 0}, {2, 0}, 0, double(teeth[0]) / teeth[1], false, 0});
  sketch.bodies[1].outlines.push_back({{}, false, 0, flank[0]});
  sketch.bodies[2].outlines.push_back({{}, false, 0, flank[1]});
  sketch.contacts.push_back({{1, 0}, {2, 0}, false, true, true});
  sketch.twin = {twin};
  return sketch;
}

Sketch random_open_face(std::uint64_t seed) {
  Draw draw(seed);
  const Vector2d O(draw.between(-1, 1), draw.between(-1, 1));
  const double out = draw.angle();
  const double size = draw.between(0.2, 0.6);
  const double range = 2 * kPi * draw.between(0.2, 1);
  Sketch sketch = driven_at(O, draw.angle(), draw.chance(0.5) ? range : -range);
  Shape shape;
  shape.kind = CurveKind::kEllipse;
  shape.x = size * draw.between(-0.3, 0.3);
  shape.y = size * draw.between(-0.3, 0.3);
  shape.a = size;
  shape.b = size * draw.between(0.5, 1);
  shape.angle = draw.angle();
  sketch.bodies[1].curves = {shape};
  sketch.drivers.front().velocity = draw.between(-5, 5);
  // Its middle lies over the pivot; a point of the slide is the body's origin.
  mount(sketch, O + 2.5 * size * unit_vector(out), out, false, out);
  const double half = size * draw.between(0.1, 1.2);
  const double round = size * draw.between(1.2, 4);
  sketch.bodies[2].outlines.push_back(
      {{},
       false,
       0,
       draw.chance(0.5)
           ? fmt::format(R"({{ type = "segment", from = [0, {}], to = [0, {}] }})", half, -half)
           : fmt::format(R"({{ type = "arc", center = [{}, 0], radius = {}, from = {}, to = {} }})", round,
                         round, kPi - half / round, kPi + half / round)});
  sketch.contacts.push_back({{2, 0}, {1, 0}, false, true});
  return sketch;
}

Sketch with_offset(Sketch cam, std::uint64_t seed) {
  Draw draw(seed);
  Sketch::Contact& contact = cam.contacts.front();
  auto& outlines = cam.bodies[static_cast<std::size_t>(contact.first.body)].outlines;
  Shape& roller = cam.bodies[static_cast<std::size_t>(contact.second.body)]
                      .curves[static_cast<std::size_t>(contact.second.item)];
  const double by = outlines.front().fillet * draw.between(0.2, 0.8) * (draw.chance(0.5) ? 1 : -1);
  roller.kind = CurveKind::kCircle;
  roller.a = std::max(roller.a, 0.1) + std::abs(by);
  Sketch twin = cam;
  twin.bodies[static_cast<std::size_t>(contact.second.body)]
      .curves[static_cast<std::size_t>(contact.second.item)]
      .a += by;
  outlines.push_back({{}, false, 0, fmt::format(R"({{ type = "offset", of = "K0", by = {} }})", by)});
  contact.first.item = 1;
  cam.twin = {twin};
  return cam;
}

}  // namespace higherpair::fire
