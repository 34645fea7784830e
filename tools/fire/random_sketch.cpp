#include "random_sketch.hpp"

#include "draw.hpp"
#include "higherpair/geometry/pose.hpp"
#include "random_boundaries.hpp"
#include "random_law_cam.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair::fire {
namespace {

using JointKind = Sketch::JointKind;
using Ref = Sketch::Ref;

using Turn = Rotation<double>;

// Spreads consecutive numbers over all bits (splitmix64).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

// An unrotated curve about the origin, and the direction of its outward normal at the intended contact point.
struct Face {
  Shape shape;
  double normal = 0;
};

class Drawing : private Draw {
public:
  explicit Drawing(std::uint64_t seed) : Draw(seed) {}

  Sketch draw(SketchKind kind);

private:
  Vector2d place() {
    const double x = between(-1, 1);
    return {x, between(-1, 1)};
  }

  Sketch::Body& at(int body) { return sketch_.bodies[body]; }
  Vector2d in_body(int body, const Vector2d& p_W) {
    return Turn::from_angle(-at(body).angle) * Vector2d(p_W - Vector2d(at(body).x, at(body).y));
  }
  int body();
  Ref point(int body, const Vector2d& p_W);
  int joint_at(JointKind kind, int a, int b, const Vector2d& p_W);
  int joint(JointKind kind, int a, int b) { return joint_at(kind, a, b, place()); }
  int join(int a, int b) { return joint(chance(0.65) ? JointKind::kRevolute : JointKind::kPrismatic, a, b); }
  void gears(int wheel1, int wheel2, int carrier, const Vector2d& p1_W, const Vector2d& p2_W);
  Ref curve_at(int body, const Face& face, const Vector2d& p_W, double normal_W);
  Face face();
  void touch(int a, int b, bool rolling);

  int known() { return known_[pick(static_cast<int>(known_.size()))]; }
  int moving();
  void know(int body) { known_.push_back(body); }
  std::array<int, 2> two_known();

  void drive(int on);
  void set_range(Sketch::Driver& driver, bool turns);
  void dyad();
  void follower();
  void leg(int body, int base, bool contacts);
  void triad();
  void ternary();
  void ternary_pair();
  void ring_of_four();
  std::vector<int> holders(const std::vector<int>& parents, int root_freedoms);
  void coupled(int bodies);
  void wheels();
  void outlined_cam(bool any);
  void any_group();
  void groups(SketchKind kind);

  Sketch sketch_;
  std::vector<int> known_;
  bool drawn_in_place_ = false;  // the frames of all bodies coincide with that of ground
  bool rings_ = false;
  bool ends_ = false;  // slides and slots have lines with ends
};

int Drawing::body() {
  Sketch::Body made;
  if (!drawn_in_place_) {
    const Vector2d p = place();
    made.x = p.x();
    made.y = p.y();
    made.angle = angle();
  }
  sketch_.bodies.push_back(made);
  return static_cast<int>(sketch_.bodies.size()) - 1;
}

Ref Drawing::point(int body, const Vector2d& p_W) {
  const Vector2d p = in_body(body, p_W);
  at(body).points.push_back({p.x(), p.y()});
  return {body, static_cast<int>(at(body).points.size()) - 1};
}

// A joint at a point. For a slide the first body's point is elsewhere on the line half of the time.
int Drawing::joint_at(JointKind kind, int a, int b, const Vector2d& p_W) {
  if (chance(0.5)) {
    std::swap(a, b);
  }
  Sketch::Joint made;
  made.kind = kind;
  const double direction_W = angle();
  const double back = kind == JointKind::kRevolute || drawn_in_place_ || chance(0.5) ? 0 : between(-0.5, 0.5);
  made.first = point(a, p_W - back * unit_vector(direction_W));
  made.second = point(b, p_W);
  made.direction = kind == JointKind::kRevolute ? 0 : direction_W - at(a).angle;
  if (ends_ && kind != JointKind::kRevolute) {
    made.from = back - between(0.01, 0.6);
    made.to = back + between(0.01, 0.6);
  }
  sketch_.joints.push_back(made);
  return static_cast<int>(sketch_.joints.size()) - 1;
}

void Drawing::gears(int wheel1, int wheel2, int carrier, const Vector2d& p1_W, const Vector2d& p2_W) {
  Sketch::Joint made;
  made.kind = chance(0.5) ? JointKind::kGears : JointKind::kBelt;
  made.first = point(wheel1, p1_W);
  made.second = point(wheel2, p2_W);
  made.ratio = between(0.3, 3);
  made.same_sense = chance(0.5);
  made.carrier = carrier;
  sketch_.joints.push_back(made);
}

Face Drawing::face() {
  Face made;
  Shape& s = made.shape;
  s.kind = std::array{CurveKind::kCircle,    CurveKind::kCircle,  CurveKind::kEllipse,
                      CurveKind::kEllipse,   CurveKind::kEllipse, CurveKind::kParabola,
                      CurveKind::kHyperbola, CurveKind::kLine,    CurveKind::kPoint}[pick(9)];
  s.a = between(0.08, 0.8);
  s.a *= chance(0.2) ? 2.5 : 1;
  s.b = s.a * between(0.3, 1.5);
  made.normal = angle();
  if (s.kind == CurveKind::kParabola) {
    made.normal = kPi + between(-1, 1);
  } else if (s.kind == CurveKind::kHyperbola) {
    made.normal = kPi + between(-0.8, 0.8) * std::atan2(s.a, s.b);
  }
  return made;
}

// The radius of curvature of a circle or ellipse where it has the face's normal.
double curvature_radius(const Face& face) {
  const auto [a, b] =
      std::array{face.shape.a, face.shape.kind == CurveKind::kCircle ? face.shape.a : face.shape.b};
  return std::pow(a * b, 2) / std::pow(std::hypot(a * std::cos(face.normal), b * std::sin(face.normal)), 3);
}

// The point of an unrotated curve about the origin that has this outward normal.
Vector2d support_point(const Shape& s, double normal) {
  const double c = std::cos(normal);
  const double d = std::sin(normal);
  switch (s.kind) {
    case CurveKind::kCircle:
      return {s.a * c, s.a * d};
    case CurveKind::kEllipse: {
      const double h = std::hypot(s.a * c, s.b * d);
      return {s.a * s.a * c / h, s.b * s.b * d / h};
    }
    case CurveKind::kParabola:
      return {s.a * (d / c) * (d / c), -2 * s.a * d / c};
    case CurveKind::kHyperbola: {
      const double h = std::sqrt(std::pow(s.a * c, 2) - std::pow(s.b * d, 2));
      return {-s.a * s.a * c / h, s.b * s.b * d / h};
    }
    case CurveKind::kLine:
    case CurveKind::kPoint:
    case CurveKind::kSupport:
    case CurveKind::kChain:  // not among the random shapes
      break;
  }
  return Vector2d::Zero();
}

// Puts a face on a body so that its contact point is at p_W with the outward normal normal_W.
Ref Drawing::curve_at(int body, const Face& face, const Vector2d& p_W, double normal_W) {
  Shape shape = face.shape;
  const double normal_B = normal_W - at(body).angle + (shape.side == Side::kOutside ? kPi : 0);
  shape.angle = shape.kind == CurveKind::kLine ? normal_B : normal_B - face.normal;
  const Vector2d center =
      in_body(body, p_W) - Turn::from_angle(shape.angle) * support_point(shape, face.normal);
  shape.x = center.x();
  shape.y = center.y();
  at(body).curves.push_back(shape);
  return {body, static_cast<int>(at(body).curves.size()) - 1};
}

bool is_round(const Face& face) {
  return face.shape.kind == CurveKind::kCircle || face.shape.kind == CurveKind::kEllipse;
}

void Drawing::touch(int a, int b, bool rolling) {
  if (chance(0.5)) {
    std::swap(a, b);
  }
  const Vector2d p = place();
  const double normal = angle();
  Face one;
  Face two;
  const auto is_point = [](const Face& face) { return face.shape.kind == CurveKind::kPoint; };
  const auto is_flat = [](const Face& face) { return face.shape.kind == CurveKind::kLine; };
  do {
    one = face();
    two = face();
  } while ((is_point(one) && is_point(two)) || (is_flat(one) && is_flat(two)) ||
           (rolling && (is_point(one) || is_point(two))));
  if (rings_ && chance(0.7) && is_round(one) && (is_round(two) || is_point(two))) {
    const double rho2 = is_point(two) ? 0 : curvature_radius(two);
    double larger = 1.05 * std::max(1.0, rho2 / curvature_radius(one));
    larger *= chance(0.5) ? 1 : between(1, 3);
    one.shape.side = Side::kOutside;
    one.shape.a *= larger;
    one.shape.b *= larger;
  }
  const Ref first = curve_at(a, one, p, normal);
  const Ref second = curve_at(b, two, p, normal + kPi);
  sketch_.contacts.push_back({first, second, rolling});
}

int Drawing::moving() {
  int body = 0;
  while (body == 0) {
    // Prefer the newest body, so that the groups form a chain.
    body = chance(0.5) ? known_.back() : known();
  }
  return body;
}

// Two known bodies in random order, at least one of which moves.
std::array<int, 2> Drawing::two_known() {
  const int one = moving();
  int other = one;
  while (other == one) {
    other = known();
  }
  return chance(0.5) ? std::array{one, other} : std::array{other, one};
}

void Drawing::set_range(Sketch::Driver& driver, bool turns) {
  const double range = (turns ? 2 * kPi : 1.5) * std::pow(10.0, between(-1.3, 0));
  driver.end = driver.start + (chance(0.5) ? range : -range);
  driver.velocity = between(-5, 5);
  driver.acceleration = between(-10, 10);
}

// A new body driven relative to a known one.
void Drawing::drive(int on) {
  const int made = body();
  const bool turns = chance(0.75);
  const int index = joint(turns ? JointKind::kRevolute : JointKind::kPrismatic, made, on);
  const Sketch::Joint& driven = sketch_.joints[index];
  Sketch::Driver driver;
  driver.joint = index;
  const Sketch::Body& first = at(driven.first.body);
  const Sketch::Body& second = at(driven.second.body);
  if (turns) {
    driver.start = second.angle - first.angle;
  } else {
    const auto p_of = [](const Sketch::Body& owner, int item) {
      const Sketch::Point& p = owner.points[item];
      return Vector2d(Vector2d(owner.x, owner.y) + Turn::from_angle(owner.angle) * Vector2d(p.x, p.y));
    };
    driver.start = unit_vector(first.angle + driven.direction)
                       .dot(p_of(second, driven.second.item) - p_of(first, driven.first.item));
  }
  set_range(driver, turns);
  sketch_.drivers.push_back(driver);
  know(made);
}

void Drawing::dyad() {
  const auto [k1, k2] = two_known();
  const int a = body();
  const auto kind = [&] { return chance(0.6) ? JointKind::kRevolute : JointKind::kPrismatic; };
  if (chance(0.25)) {
    joint(kind(), a, k1);
    joint(JointKind::kSlot, a, k2);
    know(a);
    return;
  }
  const int b = body();
  std::array<JointKind, 3> kinds{kind(), kind(), kind()};
  if (std::count(kinds.begin(), kinds.end(), JointKind::kPrismatic) == 3) {
    kinds[pick(3)] = JointKind::kRevolute;
  }
  joint(kinds[0], a, k1);
  joint(kinds[1], a, b);
  joint(kinds[2], b, k2);
  know(a);
  know(b);
}

// A body on a pivot or slide that touches a known body, or an arm with a roller that rolls on it.
void Drawing::follower() {
  const auto [k1, k2] = two_known();
  const int a = body();
  join(a, k1);
  know(a);
  if (!chance(0.2)) {
    touch(a, k2, false);
    return;
  }
  const int roller = body();
  join(a, roller);
  touch(roller, k2, true);
  know(roller);
}

// Removes one degree of freedom of a body, by a link with two joints, a slot or a contact.
void Drawing::leg(int body, int base, bool contacts) {
  if (contacts && chance(0.5)) {
    touch(body, base, false);
    return;
  }
  if (chance(0.35)) {
    joint(JointKind::kSlot, body, base);
    return;
  }
  const int link = this->body();
  join(body, link);
  joint(JointKind::kRevolute, link, base);
  know(link);
}

void Drawing::ternary() {
  const auto [k1, k2] = two_known();
  const int t = body();
  leg(t, k1, false);
  leg(t, k2, false);
  leg(t, chance(0.5) ? k1 : k2, false);
  know(t);
}

void Drawing::ternary_pair() {
  const auto [k1, k2] = two_known();
  const int s = body();
  const int t = body();
  join(s, t);
  leg(s, k1, false);
  leg(s, k2, false);
  leg(t, k1, false);
  leg(t, k2, false);
  know(s);
  know(t);
}

// Four links in a ring, two of which are joined to known bodies.
void Drawing::ring_of_four() {
  const auto [k1, k2] = two_known();
  const std::array<int, 4> ring{body(), body(), body(), body()};
  for (std::size_t i = 0; i < 4; ++i) {
    join(ring[i], ring[(i + 1) % 4]);
  }
  joint(JointKind::kRevolute, ring[0], k1);
  joint(JointKind::kRevolute, ring[2], k2);
  for (const int one : ring) {
    know(one);
  }
}

void Drawing::triad() {
  switch (pick(4)) {
    case 0:
      return ternary_pair();
    case 1:
      return ring_of_four();
    default:
      return ternary();
  }
}

// Distributes the constraints that hold a tree of bodies, one for each degree of freedom, at random over the
// bodies, but so that no connected part gets more of them than it has freedoms. Returns a body for each
// constraint. parents[i] < i carries body i on a joint; the root has `root_freedoms` of its own.
std::vector<int> Drawing::holders(const std::vector<int>& parents, int root_freedoms) {
  const auto count = static_cast<int>(parents.size());
  std::vector<int> chosen;
  bool good = false;
  while (!good) {
    chosen.clear();
    for (int i = 0; i < root_freedoms + count - 1; ++i) {
      chosen.push_back(pick(count));
    }
    good = true;
    for (unsigned part = 1; part < (1U << static_cast<unsigned>(count)); ++part) {
      const auto has = [&](int body) { return ((part >> static_cast<unsigned>(body)) & 1U) != 0; };
      int freedoms = root_freedoms - 1;
      bool whole = true;  // contains the carrier of every body in it
      for (int i = 0; i < count; ++i) {
        freedoms += has(i) ? 1 : 0;
        whole = whole && (!has(i) || i == 0 || has(parents[i]));
      }
      good = good && (!whole || std::count_if(chosen.begin(), chosen.end(), has) <= freedoms);
    }
  }
  return chosen;
}

// New bodies joined to each other, with as many contacts and slots to known bodies as they have freedoms.
void Drawing::coupled(int bodies) {
  const auto [k1, k2] = two_known();
  const auto base = [&, one = k1, two = k2] { return chance(0.5) ? one : two; };
  std::vector<int> made{body()};
  const bool joined = bodies > 1 && chance(0.6);
  if (joined) {
    join(made.front(), base());
  }
  std::vector<int> parents{0};
  for (int i = 1; i < bodies; ++i) {
    parents.push_back(pick(i));
    made.push_back(body());
    join(made.back(), made[parents.back()]);
  }
  std::vector<int> chosen = holders(parents, joined ? 1 : 3);
  while (!chosen.empty()) {
    const int one = chosen.back();
    chosen.pop_back();
    const int held = made[one];
    const auto twin = std::find(chosen.begin(), chosen.end(), one);
    if (chance(0.3)) {
      joint(JointKind::kSlot, held, base());
    } else if (twin != chosen.end() && chance(0.3)) {
      chosen.erase(twin);
      touch(held, base(), true);
    } else {
      touch(held, base(), false);
    }
  }
  for (const int one : made) {
    know(one);
  }
}

// A wheel in mesh with the crank, or a planet on it. \pre the crank is driven about a pivot on ground
void Drawing::wheels() {
  const Sketch::Joint& pivot = sketch_.joints[sketch_.drivers.front().joint];
  const int crank = pivot.first.body == 0 ? pivot.second.body : pivot.first.body;
  const Sketch::Point o = at(0).points[pivot.first.body == 0 ? pivot.first.item : pivot.second.item];
  const Vector2d O(o.x, o.y);
  const int wheel = body();
  const Vector2d p = place();
  if (chance(0.5)) {
    joint_at(JointKind::kRevolute, wheel, 0, p);
    gears(crank, wheel, 0, O, p);
  } else {
    joint_at(JointKind::kRevolute, wheel, crank, p);
    gears(0, wheel, crank, O, p);
  }
  know(wheel);
}

// A star-shaped outline about the crank's pivot, possibly a spline if `any`, and a follower on a slide or
// lever that touches it. \pre the crank is driven about a pivot on ground
void Drawing::outlined_cam(bool any) {
  const Sketch::Joint& pivot = sketch_.joints[sketch_.drivers.front().joint];
  const bool ground_first = pivot.first.body == 0;
  const int crank = ground_first ? pivot.second.body : pivot.first.body;
  const Sketch::Point o = at(0).points[(ground_first ? pivot.first : pivot.second).item];
  const Vector2d O(o.x, o.y);
  const double size = between(0.2, 0.8);
  std::array<double, 3> wave{}, phase{};
  for (std::size_t k = 0; k < wave.size(); ++k) {
    wave[k] = between(0, 0.3) / static_cast<double>(k + 1);
    phase[k] = angle();
  }
  Sketch::Outline outline;
  outline.spline = any && chance(0.5);
  outline.fillet = size * between(0.02, 0.15);
  const int count = outline.spline ? 8 + pick(17) : 3 + pick(5);
  for (int i = 0; i < count; ++i) {
    const double at_angle = 2 * kPi * i / count;
    double radius = 1;
    for (std::size_t k = 0; k < wave.size(); ++k) {
      radius += wave[k] * std::cos(static_cast<double>(k + 1) * at_angle + phase[k]);
    }
    const Vector2d p = in_body(crank, O + size * radius * unit_vector(at_angle));
    outline.points.push_back({p.x(), p.y()});
  }
  at(crank).outlines.push_back(outline);
  const double out = angle();
  const Vector2d p = O + size * (2.5 * unit_vector(out) + between(-0.3, 0.3) * unit_vector(out + kPi / 2));
  const int follower = body();
  Face made = face();
  while (!is_round(made) && made.shape.kind != CurveKind::kLine && made.shape.kind != CurveKind::kPoint) {
    made = face();
  }
  made.shape.a *= size;
  made.shape.b *= size;
  const Ref curve = curve_at(follower, made, p, out + kPi);
  if (chance(0.5)) {
    joint_at(JointKind::kRevolute, follower, 0, p + size * between(1, 2) * unit_vector(out + kPi / 2));
  } else {
    Sketch::Joint slide;
    slide.kind = JointKind::kPrismatic;
    slide.first = point(0, p);
    slide.second = point(follower, p);
    slide.direction = out + between(-0.3, 0.3);
    sketch_.joints.push_back(slide);
  }
  Sketch::Contact contact;
  contact.first = {crank, 0};
  contact.second = curve;
  contact.outlined = true;
  sketch_.contacts.push_back(contact);
  know(follower);
}

void Drawing::any_group() {
  switch (pick(8)) {
    case 0:
      return triad();
    case 1:
      return coupled(1);
    case 2:
      return coupled(2);
    case 3:
    case 4:
      return follower();
    default:
      return dyad();
  }
}

void Drawing::groups(SketchKind kind) {
  const int count = 1 + pick(4);
  for (int i = 0; i < count; ++i) {
    switch (kind) {
      case SketchKind::kDyad:
      case SketchKind::kGeared:
      case SketchKind::kCam:
      case SketchKind::kOffset:
        dyad();
        break;
      case SketchKind::kTriad:
        i < 2 ? triad() : dyad();
        break;
      case SketchKind::kChain:
      case SketchKind::kRing:
        chance(0.8) ? follower() : dyad();
        break;
      case SketchKind::kCoupled:
        if (i < 2) {
          coupled(1);
        }
        break;
      case SketchKind::kClosed:
        if (i < 2) {
          coupled(2 + pick(2));
        }
        break;
      case SketchKind::kTwo:
      case SketchKind::kStep:
      case SketchKind::kTimes:
        any_group();
        break;
      case SketchKind::kEnds:
        chance(0.7) ? dyad() : follower();
        break;
      case SketchKind::kLaw:  // made by other functions
      case SketchKind::kTeeth:
      case SketchKind::kFace:
        break;
    }
  }
}

Sketch Drawing::draw(SketchKind kind) {
  drawn_in_place_ = chance(0.25);
  rings_ = kind == SketchKind::kRing;
  know(0);
  drive(0);
  ends_ = kind == SketchKind::kEnds;
  const bool cam = kind == SketchKind::kCam || kind == SketchKind::kOffset;
  const bool turning = kind == SketchKind::kGeared || cam;
  while (turning && sketch_.joints.front().kind != JointKind::kRevolute) {
    sketch_ = {};
    known_ = {0};
    drive(0);
  }
  if (kind == SketchKind::kTwo || kind == SketchKind::kTimes) {
    drive(chance(0.5) ? 0 : known_.back());
  }
  if (kind == SketchKind::kGeared) {
    wheels();
  }
  if (cam) {
    outlined_cam(kind == SketchKind::kCam);
  }
  groups(kind);
  if (kind == SketchKind::kStep) {
    sketch_.duration = between(0.5, 2);
    Sketch::Driver& driver = sketch_.drivers.front();
    driver.velocity = (driver.end - driver.start) / sketch_.duration;
    driver.acceleration = -driver.velocity / (sketch_.duration * between(0.2, 1.5));
  }
  if (kind == SketchKind::kTimes) {
    sketch_.duration = between(0.5, 2);
    for (Sketch::Driver& driver : sketch_.drivers) {
      driver.velocity = (driver.end - driver.start) / sketch_.duration * between(0, 2);
      driver.acceleration = driver.velocity / sketch_.duration * between(-3, 3);
    }
  }
  return sketch_;
}

struct KindName {
  SketchKind kind;
  std::string_view name;
};

constexpr std::array kKindNames{
    KindName{SketchKind::kDyad, "dyad"},       KindName{SketchKind::kTriad, "triad"},
    KindName{SketchKind::kChain, "chain"},     KindName{SketchKind::kRing, "ring"},
    KindName{SketchKind::kCoupled, "coupled"}, KindName{SketchKind::kClosed, "closed"},
    KindName{SketchKind::kGeared, "geared"},   KindName{SketchKind::kTwo, "two"},
    KindName{SketchKind::kCam, "cam"},         KindName{SketchKind::kStep, "step"},
    KindName{SketchKind::kLaw, "law"},         KindName{SketchKind::kTeeth, "teeth"},
    KindName{SketchKind::kFace, "face"},       KindName{SketchKind::kOffset, "offset"},
    KindName{SketchKind::kEnds, "ends"},       KindName{SketchKind::kTimes, "times"}};

}  // namespace

std::vector<SketchKind> all_kinds() {
  std::vector<SketchKind> kinds;
  for (const KindName& one : kKindNames) {
    kinds.push_back(one.kind);
  }
  return kinds;
}

std::string_view name_of(SketchKind kind) {
  return kKindNames[static_cast<std::size_t>(kind)].name;
}

std::optional<SketchKind> kind_named(std::string_view name) {
  const auto* const found = std::find_if(kKindNames.begin(), kKindNames.end(),
                                         [&](const KindName& one) { return one.name == name; });
  return found == kKindNames.end() ? std::nullopt : std::optional(found->kind);
}

Sketch random_sketch(SketchKind kind, std::uint64_t seed, std::uint64_t number) {
  const std::uint64_t own = mixed(mixed(mixed(seed) + static_cast<std::uint64_t>(kind)) + number);
  switch (kind) {
    case SketchKind::kLaw:
      return random_law_cam(own);
    case SketchKind::kTeeth:
      return random_flank_pair(own);
    case SketchKind::kFace:
      return random_open_face(own);
    case SketchKind::kOffset:
      return with_offset(Drawing(own).draw(kind), own);
    default:
      return Drawing(own).draw(kind);
  }
}

}  // namespace higherpair::fire
