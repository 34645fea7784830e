#include "case.hpp"

#include "contact/pair_follower.hpp"
#include "higherpair/contact/finder.hpp"

#include <cmath>

#include <fmt/core.h>

namespace higherpair::fire {
namespace {

CurveResult curve_of(const Shape& s) {
  switch (s.kind) {
    case CurveKind::kCircle:
      return make_circle({s.x, s.y}, s.a, s.side);
    case CurveKind::kEllipse:
      return make_ellipse({s.x, s.y}, {s.a, s.b}, s.angle, s.side);
    case CurveKind::kParabola:
      return make_parabola({s.x, s.y}, s.a, s.angle, s.side);
    case CurveKind::kHyperbola:
      return make_hyperbola({s.x, s.y}, {s.a, s.b}, s.angle, s.side);
    case CurveKind::kLine:
      return make_line({s.x, s.y}, unit_vector(s.angle));
    case CurveKind::kPoint:
    case CurveKind::kSupport:
    case CurveKind::kChain:
      break;
  }
  return make_point({s.x, s.y});
}

OneFreedom freedom_of(const Mount& m) {
  OneFreedom freedom;
  freedom.turns = m.turns;
  freedom.p_WO = {m.x, m.y};
  freedom.p_BO = {m.bx, m.by};
  freedom.direction_W = unit_vector(m.direction);
  freedom.theta = m.theta;
  freedom.R_WB = Rotation<double>::from_angle(m.theta);
  return freedom;
}

std::vector<double*> lengths(Case& one) {
  std::vector<double*> all;
  for (Shape* s : {&one.curve1, &one.curve2}) {
    all.insert(all.end(), {&s->x, &s->y, &s->a, &s->b});
  }
  for (Mount* m : {&one.mount1, &one.mount2}) {
    all.insert(all.end(), {&m->x, &m->y, &m->bx, &m->by});
  }
  if (!one.mount1.turns) {
    all.insert(all.end(), {&one.u, &one.step});
  }
  if (!one.mount2.turns) {
    all.push_back(&one.q);
  }
  if (one.crank) {
    all.insert(all.end(), {&one.crank->x, &one.crank->y, &one.crank->length, &one.crank->cx, &one.crank->cy});
  }
  return all;
}

std::string point_text(const std::string& name, double x, double y) {
  return fmt::format("points.{} = [{}, {}]\n", name, x, y);
}

std::string body_text(const std::string& name, const Shape& s, const Mount& m, double at) {
  const Pose<double> X_WB = pose_at(freedom_of(m), at);
  return fmt::format(
      "[bodies.{}]\npose = {{ x = {}, y = {}, angle = {} }}\npoints.O = [{}, {}]\ncurves.edge = {}\n", name,
      X_WB.p_WB.x(), X_WB.p_WB.y(), m.turns ? at : m.theta, m.bx, m.by, curve_text(s));
}

std::string joint_text(const std::string& name, const Mount& m, int number) {
  const std::string between = fmt::format(R"(between = ["ground.O{}", "{}.O"])", number, name);
  if (m.turns) {
    return fmt::format("[joints.joint{}]\ntype = \"revolute\"\n{}\n", number, between);
  }
  return fmt::format("[joints.joint{}]\ntype = \"prismatic\"\n{}\ndirection = {}\nangle = {}\n", number,
                     between, m.direction, m.theta);
}

// The crank, its rod and their joints, placed so that the linkage closes at the start.
std::string crank_text(const Case& one) {
  const Crank& c = *one.crank;
  const Vector2d p_WA = Vector2d(c.x, c.y) + c.length * unit_vector(c.angle);
  const Vector2d p_WC = pose_at(freedom_of(one.mount1), one.u) * Vector2d(c.cx, c.cy);
  const Vector2d rod = p_WC - p_WA;
  return fmt::format(

      "[bodies.crank]\npose = {{ x = {}, y = {}, angle = {} }}\npoints.O = [0, 0]\npoints.A = [{}, 0]\n"
      "[bodies.rod]\npose = {{ x = {}, y = {}, angle = {} }}\npoints.A = [0, 0]\npoints.C = [{}, 0]\n"
      "[joints.joint3]\ntype = \"revolute\"\nbetween = [\"ground.O3\", \"crank.O\"]\n"
      "[joints.a]\ntype = \"revolute\"\nbetween = [\"crank.A\", \"rod.A\"]\n"
      "[joints.c]\ntype = \"revolute\"\nbetween = [\"rod.C\", \"first.C\"]\n",
      c.x, c.y, c.angle, c.length, p_WA.x(), p_WA.y(), angle_of(rod), rod.norm());
}

}  // namespace

std::string curve_text(const Shape& s) {
  const char* side = s.side == Side::kOutside ? R"(, side = "outside")" : "";
  switch (s.kind) {
    case CurveKind::kCircle:
      return fmt::format(R"({{ type = "circle", center = [{}, {}], radius = {}{} }})", s.x, s.y, s.a, side);
    case CurveKind::kEllipse:
    case CurveKind::kHyperbola:
      return fmt::format(R"({{ type = "{}", center = [{}, {}], semi_axes = [{}, {}], rotation = {}{} }})",
                         s.kind == CurveKind::kEllipse ? "ellipse" : "hyperbola", s.x, s.y, s.a, s.b, s.angle,
                         side);
    case CurveKind::kParabola:
      return fmt::format(R"({{ type = "parabola", vertex = [{}, {}], focal_length = {}, rotation = {}{} }})",
                         s.x, s.y, s.a, s.angle, side);
    case CurveKind::kLine:
      return fmt::format(R"({{ type = "line", point = [{}, {}], normal = {} }})", s.x, s.y, s.angle);
    case CurveKind::kPoint:
    case CurveKind::kSupport:
    case CurveKind::kChain:  // not among the random shapes
      break;
  }
  return fmt::format(R"({{ type = "point", at = [{}, {}] }})", s.x, s.y);
}

Shape Cases::shape(int kind, bool ring) {
  Shape s;
  s.kind = static_cast<CurveKind>(kind);
  s.side = ring ? Side::kOutside : Side::kInside;
  s.x = between(-1, 1);
  s.y = between(-1, 1);
  const int decades = pick(8);
  s.a = (ring ? 4 : 1) * std::pow(10.0, decades == 0   ? between(-6, 6)
                                        : decades == 1 ? between(-3, 3)
                                                       : between(-0.7, 0.3));
  s.b = s.a * std::pow(10.0, pick(8) == 0 ? between(-5, 0) : between(-1, 0));
  s.angle = between(-kPi, kPi);
  return s;
}

Mount Cases::mount() {
  return {pick(2) == 0,   between(-2, 2),     between(-2, 2),    between(-1, 1),
          between(-1, 1), between(-kPi, kPi), between(-kPi, kPi)};
}

// Makes the curvatures nearly opposite: κ1 + κ2 differs from 0 only by a few digits.
void Cases::make_conforming(Case& one) {
  Shape& inner = one.curve1;
  if (inner.kind == CurveKind::kLine || inner.kind == CurveKind::kPoint) {
    inner.kind = CurveKind::kEllipse;
  }
  inner.side = Side::kInside;
  one.curve2 = inner;
  one.curve2.x += between(-0.1, 0.1);
  one.curve2.side = Side::kOutside;
  const double larger = 1 + std::pow(10.0, between(-9, -1));
  one.curve2.a *= larger;
  one.curve2.b *= larger;
}

// Moves the start so close to a limit of the driver that most digits of the rates depend on the last digits
// of u.
void Cases::move_beside_limit(Case& one) {
  const auto pair = pair_of(one);
  const FindResult found = find_nearest_contact(*pair, one.u, one.q);
  if (found.status != FindStatus::kFound || found.branch == 0) {
    return;
  }
  FollowedContact track = start_track(*pair, found.at, found.branch);
  const TrackResult moved = follow_to(track, one.u + 2 * kPi * (one.mount1.turns ? 1 : 2));
  if (moved.limit) {
    one.step = -std::pow(10.0, between(-9, -2));
    one.u = moved.limit->u + one.step * between(0, 1);
    one.q = moved.limit->q;
  }
}

// Makes a joint that hardly changes the distance of the curves: a pivot near the centre of a curve, or a
// slide almost along a face.
void Cases::make_singular(Case& one) {
  const double off = std::pow(10.0, between(-14, -1));
  Shape& shape = pick(2) == 0 ? one.curve1 : one.curve2;
  Mount& mount = &shape == &one.curve1 ? one.mount1 : one.mount2;
  if (shape.kind == CurveKind::kLine) {
    mount.turns = false;
    mount.direction = mount.theta + shape.angle + kPi / 2 + off;
    return;
  }
  mount.turns = true;
  mount.bx = shape.x + off * between(-1, 1);
  mount.by = shape.y + off * between(-1, 1);
}

// Puts both bodies on joints of the same type close to each other, so that they move almost as one.
void Cases::make_parallel(Case& one) {
  const double off = std::pow(10.0, between(-14, -1));
  one.mount2.turns = one.mount1.turns;
  one.mount2.x = one.mount1.x + off * between(-1, 1);
  one.mount2.y = one.mount1.y + off * between(-1, 1);
  one.mount2.direction = one.mount1.direction + off;
}

Case Cases::next() {
  Case one;
  const int kind1 = pick(6);
  const bool ring1 = kind1 < 4 && pick(5) == 0;
  int kind2 = pick(6);
  while ((kind1 >= 4 && kind2 == kind1) || (ring1 && kind2 == 4)) {
    kind2 = pick(6);
  }
  const bool ring2 = !ring1 && kind1 != 4 && kind2 < 4 && pick(5) == 0;
  one.curve1 = shape(kind1, ring1);
  one.curve2 = shape(kind2, ring2);
  one.mount1 = mount();
  one.mount2 = mount();
  one.u = between(-kPi, kPi);
  one.q = between(-kPi, kPi);
  switch (pick(10)) {
    case 0:
      make_conforming(one);
      break;
    case 1:
      move_beside_limit(one);
      break;
    case 2:
      for (double* number : numbers(one)) {
        *number = std::round(4 * *number) / 4 + 0.0;  // avoids -0
      }
      for (Shape* s : {&one.curve1, &one.curve2}) {
        s->a = std::max(s->a, 0.25);
        s->b = std::max(s->b, 0.25);
      }
      one.step = 0.03125;
      break;
    case 3:
      make_singular(one);
      break;
    case 4:
      make_parallel(one);
      break;
    default:
      break;
  }
  if (one.mount1.turns && pick(4) == 0) {
    one.crank = Crank{between(-4, 4),     between(-4, 4), between(0.1, 1),
                      between(-kPi, kPi), between(-3, 3), between(-3, 3)};
  }
  const double size = std::pow(10.0, between(-6, 6));
  for (double* length : lengths(one)) {
    *length *= size;
  }
  return one;
}

std::vector<double*> numbers(Case& one) {
  std::vector<double*> all = lengths(one);
  for (Shape* s : {&one.curve1, &one.curve2}) {
    all.push_back(&s->angle);
  }
  for (Mount* m : {&one.mount1, &one.mount2}) {
    all.insert(all.end(), {&m->direction, &m->theta});
  }
  if (one.mount1.turns) {
    all.insert(all.end(), {&one.u, &one.step});
  }
  if (one.mount2.turns) {
    all.push_back(&one.q);
  }
  if (one.crank) {
    all.push_back(&one.crank->angle);
  }
  return all;
}

std::optional<ContactPair> pair_of(const Case& one) {
  const CurveResult curve1 = curve_of(one.curve1);
  const CurveResult curve2 = curve_of(one.curve2);
  if (!curve1 || !curve2) {
    return std::nullopt;
  }
  return ContactPair{*curve1, freedom_of(one.mount1), *curve2, freedom_of(one.mount2)};
}

std::string profile_of(const Case& one, const std::string& title) {
  const double start = one.crank ? one.crank->angle : one.u;
  return fmt::format(
      "title = \"{}\"\n[units]\nlength = \"m\"\nangle = \"rad\"\n\n[bodies.ground]\npoints.O1 = [{}, {}]\n"
      "points.O2 = [{}, {}]\n{}{}{}{}{}{}{}[contacts.touch]\nbetween = [\"first.edge\", \"second.edge\"]\n"
      "[driver]\njoint = \"joint{}\"\nstart = {}\nend = {}\nsamples = {}\nvelocity = 1\n",
      title, one.mount1.x, one.mount1.y, one.mount2.x, one.mount2.y,
      one.crank ? point_text("O3", one.crank->x, one.crank->y) : "",
      body_text("first", one.curve1, one.mount1, one.u),
      one.crank ? point_text("C", one.crank->cx, one.crank->cy) : "",
      body_text("second", one.curve2, one.mount2, one.q), joint_text("first", one.mount1, 1),
      joint_text("second", one.mount2, 2), one.crank ? crank_text(one) : std::string(), one.crank ? 3 : 1,
      start, start + one.rows * one.step, one.rows + 1);
}

}  // namespace higherpair::fire
