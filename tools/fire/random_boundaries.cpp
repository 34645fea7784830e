#include "random_boundaries.hpp"

#include "draw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/core.h>

namespace higherpair::fire {
namespace {

double involute(double alpha) {
  return std::tan(alpha) - alpha;
}

Vector2d mirrored(const Vector2d& p) {
  return {p.x(), -p.y()};
}

std::string segment(const Vector2d& from, const Vector2d& to) {
  return fmt::format(R"({{ type = "segment", from = [{}, {}], to = [{}, {}] }})", from.x(), from.y(), to.x(),
                     to.y());
}

}  // namespace

Sketch random_flank_pair(std::uint64_t seed) {
  Draw draw(seed);
  const double module = draw.between(0.02, 0.1);
  const double alpha = draw.between(20, 25) * kPi / 180;
  const std::array teeth{20 + draw.pick(40), 20 + draw.pick(40)};
  const std::array shift{draw.between(-0.1, 0.3), draw.between(-0.1, 0.3)};
  const double mean = module * (teeth[0] + teeth[1]) / 2;
  // Working pressure angle of a mesh without backlash, from inv = inv α + 2 tan α (x1 + x2)/(z1 + z2),
  // slightly enlarged.
  const double wanted = involute(alpha) + 2 * std::tan(alpha) * (shift[0] + shift[1]) / (teeth[0] + teeth[1]);
  double working = alpha;
  for (int i = 0; i < 50; ++i) {
    working -= (involute(working) - wanted) / std::pow(std::tan(working), 2);
  }
  working += draw.between(0, 0.02);
  const double distance = mean * std::cos(alpha) / std::cos(working);
  const double action = distance * std::sin(working);  // length between the base circles

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
  // The rolls of both flanks add up to the line of action. Right flanks are the mirror image of left ones.
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
  twin.joints.push_back(
      {Sketch::JointKind::kGears, {1, 0}, {2, 0}, 0, double(teeth[0]) / teeth[1], false, 0});
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
  // The middle of the face is over the pivot; the slide's point is the body's origin.
  mount(sketch, O + 2.5 * size * unit_vector(out), out, false, out);
  const double half = size * draw.between(0.1, 1.2);
  const double round = size * draw.between(1.2, 4);
  const bool flat = draw.chance(0.5);
  const Vector2d end =
      flat ? Vector2d(0, half) : Vector2d(Vector2d(round, 0) - round * unit_vector(-half / round));
  const Vector2d inner =
      flat ? Vector2d(half, half) : Vector2d(Vector2d(round, 0) - 0.7 * round * unit_vector(-half / round));
  const std::string face =
      flat ? segment(end, mirrored(end))
           : fmt::format(R"({{ type = "arc", center = [{}, 0], radius = {}, from = {}, to = {} }})", round,
                         round, kPi - half / round, kPi + half / round);
  Sketch twin = sketch;
  sketch.bodies[2].outlines.push_back({{}, false, 0, face});
  twin.bodies[2].outlines.push_back({{},
                                     false,
                                     0,
                                     fmt::format(R"({{ type = "chain", spans = [{}, {}, {}, {}] }})", face,
                                                 segment(mirrored(end), mirrored(inner)),
                                                 segment(mirrored(inner), inner), segment(inner, end))});
  sketch.contacts.push_back({{2, 0}, {1, 0}, false, true});
  twin.contacts = sketch.contacts;
  sketch.twin = {twin};
  return sketch;
}

Sketch with_offset(Sketch cam, std::uint64_t seed) {
  Draw draw(seed);
  Sketch::Contact& contact = cam.contacts.front();
  auto& outlines = cam.bodies[contact.first.body].outlines;
  Shape& roller = cam.bodies[contact.second.body].curves[contact.second.item];
  const double by = outlines.front().fillet * draw.between(0.2, 0.8) * (draw.chance(0.5) ? 1 : -1);
  roller.kind = CurveKind::kCircle;
  roller.a = std::max(roller.a, 0.1) + std::abs(by);
  Sketch twin = cam;
  twin.bodies[contact.second.body].curves[contact.second.item].a += by;
  outlines.push_back({{}, false, 0, fmt::format(R"({{ type = "offset", of = "K0", by = {} }})", by)});
  contact.first.item = 1;
  cam.twin = {twin};
  return cam;
}

}  // namespace higherpair::fire
