#include "higherpair/drawing/scene_maker.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "outline.hpp"
#include "sketch.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kNormal = 9;  // half the length of normals and tangents [units]
constexpr double kDot = 0.55;
constexpr double kCenterEdge = 0.5, kCenterArrow = 4;  // to the edge of the frame, and length [units]
// A body farther from its instant centre than this slides [half diagonals of the frame].
constexpr double kFarthestCenter = 1e3;
constexpr int kCoils = 8;
// Springs on pivots: radii [units], and by how much they wind [rad].
constexpr double kOuterSpiral = 3.4, kInnerSpiral = 1.3;
constexpr double kSpiralSweep = 4 * kPi, kLeastSpiralSweep = kPi, kMostSpiralSweep = 10 * kPi;
constexpr int kSpiralPoints = 72;

using Kind = Shape::Kind;

void set_line(Shape& shape, const Vector2d& a, const Vector2d& b) {
  shape.numbers.assign({a.x(), a.y(), b.x(), b.y()});
}

void set_circle(Shape& shape, const Vector2d& center, double radius) {
  shape.numbers.assign({center.x(), center.y(), radius});
}

}  // namespace

// The next moving shape. All rows have the same shapes; only their numbers change. It stays where it is when
// others are added: a caller may fill several at once.
Shape& SceneMaker::next(Role role, const std::string& name, Kind kind, bool closed) {
  if (next_ == scene_.moving.size()) {
    scene_.moving.push_back({role, kind, name, 0, closed, "", {}, "", false});
  }
  Shape& shape = scene_.moving[next_++];
  shape.numbers.clear();
  return shape;
}

const Scene& SceneMaker::at(const MotionRow& row, const Reactions* reactions) {
  scene_.defined = has_place(row);
  for (std::size_t i = 0; scene_.defined && i < row.bodies.size(); ++i) {
    const Vector2d p = kMillimetresPerMetre * row.bodies[i].X_WB.p_WB;
    scene_.places[i] = {p.x(), p.y(), row.bodies[i].theta};
  }
  next_ = 0;
  for (const Joint& joint : mechanism_->joints) {
    if (joint.type == JointType::kBelt) add_belt(row, joint);
  }
  add_springs(row);
  for (std::size_t i = 0; i < mechanism_->contacts.size(); ++i) {
    const std::size_t first = next_;
    add_contact(row, i);
    add_linkage(row, i);
    for (std::size_t k = first; k < next_ && !row.contacts[i].touches; ++k) {
      scene_.moving[k].numbers.clear();
    }
  }
  for (std::size_t i = 1; i < row.bodies.size(); ++i) {
    add_motion(row, static_cast<int>(i));
  }
  for (const Driver& driver : mechanism_->drivers) {
    add_driver(row, driver);
  }
  if (forces_ && reactions != nullptr) {
    add_forces(row, *reactions);
  }
  // Clears shapes that this row does not reach; all of them if its positions are undefined.
  for (std::size_t i = scene_.defined ? next_ : 0; i < scene_.moving.size(); ++i) {
    scene_.moving[i].numbers.clear();
  }
  return scene_;
}

void SceneMaker::add_contact(const MotionRow& row, std::size_t index) {
  const Contact& contact = mechanism_->contacts[index];
  const CommonNormal& at = row.contacts[index].at;
  const Vector2d p = kMillimetresPerMetre * at.p_W();
  const double length = kNormal * scene_.unit;
  const auto add_curvature = [&](const CurveRef& ref, const Vector2d& p_W, const Vector2d& n_W, double rho) {
    const bool round =
        is_curved(curve_of(*mechanism_, ref)) && kMillimetresPerMetre * std::abs(rho) <= largest_;
    const Vector2d center = kMillimetresPerMetre * (p_W - rho * n_W);
    Shape& circle = next(Role::kCurvature, contact.name, Kind::kCircle);
    if (round) set_circle(circle, center, kMillimetresPerMetre * std::abs(rho));
    Shape& middle = next(Role::kCurvature, contact.name, Kind::kCircle, true);
    if (round) set_circle(middle, center, kDot * scene_.unit);
  };
  add_curvature(contact.first, at.p1_W, at.n_W, at.rho1);
  add_curvature(contact.second, at.p2_W, -at.n_W, at.rho2);
  set_line(next(Role::kTangent, contact.name, Kind::kPath), p - length * perp(at.n_W),
           p + length * perp(at.n_W));
  set_line(next(Role::kNormal, contact.name, Kind::kPath), p - length * at.n_W, p + length * at.n_W);
  set_circle(next(Role::kContact, contact.name, Kind::kCircle, true), p, kDot * scene_.unit);
}

void SceneMaker::add_springs(const MotionRow& row) {
  for (std::size_t i = 0; i < mechanism_->springs.size(); ++i) {
    const Spring& spring = mechanism_->springs[i];
    if (springs_[i]) {
      add_straight_spring(row, spring, *springs_[i]);
    } else {
      add_spiral_spring(row, spring);
    }
  }
}

// From the first body, outside, to the second one: it winds and unwinds with the joint.
void SceneMaker::add_spiral_spring(const MotionRow& row, const Spring& spring) {
  const Joint& joint = mechanism_->joints[*spring.joint];
  const BodyMotion& first = row.bodies[joint.first.body];
  const Vector2d center = kMillimetresPerMetre * (first.X_WB * point_of(*mechanism_, joint.first));
  const double turned = row.bodies[joint.second.body].theta - first.theta;
  const double sweep = std::clamp(kSpiralSweep + turned, kLeastSpiralSweep, kMostSpiralSweep);
  Shape& shape = next(Role::kSpring, spring.name, Kind::kPath);
  for (int i = 0; i <= kSpiralPoints; ++i) {
    const double share = static_cast<double>(i) / kSpiralPoints;
    const double radius = scene_.unit * std::lerp(kOuterSpiral, kInnerSpiral, share);
    append(shape.numbers, center + radius * unit_vector(first.theta + share * sweep));
  }
}

void SceneMaker::add_straight_spring(const MotionRow& row, const Spring& spring, const StraightSpring& ends) {
  const Pose<double>& X_WA = row.bodies[ends.first_body].X_WB;
  const Vector2d shift = X_WA.R_WB * ends.shift;
  const Vector2d a = kMillimetresPerMetre * (X_WA * ends.first + shift);
  const Vector2d b = kMillimetresPerMetre * (row.bodies[ends.second_body].X_WB * ends.second + shift);
  Shape& shape = next(Role::kSpring, spring.name, Kind::kPath);
  const double length = (b - a).norm();
  if (!(length > 0)) {
    return;
  }
  const Vector2d across = 1.6 * scene_.unit * perp(Vector2d((b - a) / length));
  append(shape.numbers, a);
  append(shape.numbers, a + 0.15 * (b - a));
  for (int i = 0; i < kCoils; ++i) {
    const double share = 0.15 + 0.7 * (i + 0.5) / kCoils;
    append(shape.numbers, a + share * (b - a) + (i % 2 == 0 ? 1 : -1) * across);
  }
  append(shape.numbers, a + 0.85 * (b - a));
  append(shape.numbers, b);
}

// The two straight sides of an open belt, or of a crossed one.
void SceneMaker::add_belt(const MotionRow& row, const Joint& joint) {
  const Vector2d a = row.bodies[joint.first.body].X_WB * point_of(*mechanism_, joint.first);
  const Vector2d b = row.bodies[joint.second.body].X_WB * point_of(*mechanism_, joint.second);
  const double distance = (b - a).norm();
  Shape& shape = next(Role::kGear, joint.name, Kind::kPath);
  if (!(distance > 0)) {
    return;
  }
  const auto [r1, r2] = wheel_radii(joint, distance);
  const double sense = joint.turning_ratio > 0 ? 1 : -1;
  const double sine = (r1 - sense * r2) / distance;
  const Vector2d along = (b - a) / distance;
  for (const double side : {1.0, -1.0}) {
    const Vector2d n = sine * along + side * std::sqrt(std::max(0.0, 1 - sine * sine)) * perp(along);
    if (side < 0) append_break(shape.numbers);
    append(shape.numbers, kMillimetresPerMetre * (a + r1 * n));
    append(shape.numbers, kMillimetresPerMetre * (b + sense * r2 * n));
  }
}

// The instant centre of a body; of one outside of the frame an arrow at its edge points there.
void SceneMaker::add_center(const MotionRow& row, int index) {
  const BodyMotion& body = row.bodies[index];
  const std::string& name = mechanism_->bodies[index].name;
  const double u = scene_.unit;
  Shape& dot = next(Role::kCenter, name, Kind::kCircle, true);
  dot.text = "instant centre of " + name;
  Shape& arrow = next(Role::kCenter, name, Kind::kArrow);
  arrow.text = dot.text;
  Shape& label = next(Role::kCenter, name + ".center", Kind::kText);
  label.text = "centre of " + name;
  if (!(row.all_rates || row.has_rates[index]) || body.omega == 0) return;
  const Vector2d p = kMillimetresPerMetre * (body.X_WB.p_WB + perp(body.v_WB) / body.omega);
  const Vector2d middle = (scene_.view.low + scene_.view.high) / 2, half = scene_.view.size() / 2;
  const Vector2d out = p - middle;
  if (out.norm() <= largest_) set_circle(dot, p, kDot * u);
  const double share = (out.array().abs() / half.array()).maxCoeff();  // 1 on the edge of the frame
  if (!(share > 1 && out.norm() <= kFarthestCenter * half.norm())) return;
  const Vector2d d = out.normalized();
  const Vector2d tip = middle + out / share - kCenterEdge * u * d, tail = tip - kCenterArrow * u * d;
  set_line(arrow, tail, tip);
  label.numbers = {tail.x(), tail.y(), -d.x(), -d.y()};
}

void SceneMaker::add_motion(const MotionRow& row, int index) {
  const BodyMotion& body = row.bodies[index];
  const Body& of = mechanism_->bodies[index];
  const bool rates = row.all_rates || row.has_rates[index];
  add_center(row, index);
  for (const NamedPoint& point : of.points) {
    const PointMotion motion = point_motion(body, point.p_B);
    const Vector2d p = kMillimetresPerMetre * motion.p_W;
    const auto add_arrow = [&](Role role, const Vector2d& length) {
      Shape& arrow = next(role, of.name + "." + point.name, Kind::kArrow);
      if (rates && length.norm() > 0) set_line(arrow, p, p + kMillimetresPerMetre * length);
    };
    add_arrow(Role::kVelocity, scene_.velocity_scale * motion.v_W);
    add_arrow(Role::kAcceleration, scene_.acceleration_scale * motion.a_W);
  }
}

}  // namespace higherpair
