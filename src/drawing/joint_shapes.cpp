#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "outline.hpp"
#include "sketch.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// Sizes in units.
constexpr double kHatch = 1.1;  // distance between hatch lines
constexpr double kBlock = 5.5;  // length of a sliding block
constexpr double kBlockWidth = 3.6;
constexpr double kGuide = 3;           // half the length of the guide around a rod
constexpr double kGuideBeyond = 9;     // least distance from the joint's point to the middle of the guide
constexpr double kRod = 1.1;           // half the width of a rod
constexpr double kWall = 2.4;          // half the length of what a spring pushes against
constexpr double kBesideSlot = 4.5;    // of a spring along a slot from its middle
constexpr double kShortestSpring = 6;  // length of a spring along a slide where it is shortest

void append_line(std::vector<double>& path, const Vector2d& a, const Vector2d& b) {
  if (!path.empty()) {
    append_break(path);
  }
  path.insert(path.end(), {a.x(), a.y(), b.x(), b.y()});
}

// A line hatched on its right side, as the boundary of a fixed part.
std::vector<double> hatched(const Vector2d& a, const Vector2d& b, double unit) {
  std::vector<double> path;
  append_line(path, a, b);
  const Vector2d along = (b - a).normalized();
  const Vector2d slant = kHatch * unit * (-perp(along) - along);
  const int count = std::max(1, static_cast<int>((b - a).norm() / (kHatch * unit)));
  for (int i = 1; i <= count; ++i) {
    const Vector2d foot = a + (b - a) * i / count;
    append_line(path, foot, foot + slant);
  }
  return path;
}

void add_pivot(Sketch& sketch, const std::string& name, const Vector2d& p) {
  const double u = sketch.unit;
  const Vector2d left = p + u * Vector2d(-2, -3.2), right = p + u * Vector2d(2, -3.2);
  sketch.add(Role::kFixed, name, 0, {left.x(), left.y(), p.x(), p.y(), right.x(), right.y()}, true);
  sketch.add(Role::kFixed, name, 0, hatched(p + u * Vector2d(-3, -3.2), p + u * Vector2d(3, -3.2), u));
}

void add_pin(Sketch& sketch, const Joint& joint) {
  for (const PointRef& ref : {joint.first, joint.second}) {
    if (ref.body == 0) {
      add_pivot(sketch, joint.name, point_of(sketch.mechanism, ref));
    }
  }
  const PointRef& on = joint.second.body == 0 ? joint.first : joint.second;
  sketch.add_circle(Role::kJoint, joint.name, on.body, point_of(sketch.mechanism, on),
                    kPinRadius * sketch.unit);
}

// Whether the symbol of a pivot on ground is at this point.
bool has_pivot(const Sketch& sketch, const Vector2d& p) {
  const auto is_here = [&](const PointRef& ref) {
    return ref.body == 0 && (point_of(sketch.mechanism, ref) - p).norm() < kPinRadius * sketch.unit;
  };
  const auto& joints = sketch.mechanism.joints;
  return std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) {
    return joint.type == JointType::kRevolute && (is_here(joint.first) || is_here(joint.second));
  });
}

// 1 or -1: the sense along the slide's direction in which the rod extends, away from the contact point.
double away_from_contact(const Sketch& sketch, const Joint& joint) {
  const MotionRow& row = *sketch.rows.front();
  for (std::size_t i = 0; i < sketch.mechanism.contacts.size(); ++i) {
    const Contact& contact = sketch.mechanism.contacts[i];
    if (!row.contacts[i].touches ||
        (contact.first.body != joint.second.body && contact.second.body != joint.second.body)) {
      continue;
    }
    const bool second = contact.second.body == joint.second.body;
    const Vector2d into = second ? row.contacts[i].at.n_W : Vector2d(-row.contacts[i].at.n_W);
    const Vector2d d = row.bodies[joint.first.body].X_WB.R_WB * joint.direction_A;
    return into.dot(d) >= 0 ? 1 : -1;
  }
  return 1;
}

// Room for a spring on this joint, when it is shortest [m].
double spring_room(const Sketch& sketch, const Joint& joint) {
  const auto& springs = sketch.mechanism.springs;
  const bool has = std::any_of(springs.begin(), springs.end(), [&](const Spring& spring) {
    return spring.joint && &sketch.mechanism.joints[*spring.joint] == &joint;
  });
  return has ? kShortestSpring * sketch.unit : 0;
}

// How far the curves of a body extend from a point of it in a direction [m].
double reach_along(const Sketch& sketch, int body, const Vector2d& p_B, const Vector2d& d_B) {
  double reach = 0;
  for (const NamedCurve& named : sketch.mechanism.bodies[body].curves) {
    const auto middle = middle_of(named.curve);
    const auto radius = middle ? reach_from(named.curve, *middle) : std::nullopt;
    if (radius) reach = std::max(reach, (*middle - p_B).dot(d_B) + *radius);
  }
  return reach;
}

// How a rod lies in its guide, along the slide in the sense in which the rod extends.
struct RodLayout {
  double sense = 1;
  double nearest = 0;  // smallest coordinate in that sense
  double guide = 0;    // middle of the guide
  double end = 0;      // of the rod, beyond the joint's point
};

RodLayout rod_layout(const Sketch& sketch, const Joint& joint) {
  const auto [low, high] = travelled_range(sketch, joint);
  const double sense = away_from_contact(sketch, joint);
  const double nearest = sense > 0 ? low : -high;
  const Vector2d d_B =
      Rotation<double>::from_angle(-joint.relative_angle) * Vector2d(sense * joint.direction_A);
  const double reach = reach_along(sketch, joint.second.body, point_of(sketch.mechanism, joint.second), d_B);
  const double beyond = std::max(kGuideBeyond * sketch.unit, reach + (kGuide + 1) * sketch.unit);
  const double guide = (sense > 0 ? high : -low) + beyond;
  const double room = std::max(2 * sketch.unit, spring_room(sketch, joint));
  return {sense, nearest, guide, guide - nearest + kGuide * sketch.unit + room};
}

void add_rod(Sketch& sketch, const Joint& joint) {
  const double u = sketch.unit;
  const auto [sense, nearest, at, end] = rod_layout(sketch, joint);
  const Vector2d d_A = sense * joint.direction_A;
  const Rotation<double> R_BA = Rotation<double>::from_angle(-joint.relative_angle);
  const Vector2d d_B = R_BA * d_A;
  const Vector2d p_A = point_of(sketch.mechanism, joint.first),
                 p_B = point_of(sketch.mechanism, joint.second);
  sketch.shapes.insert(
      sketch.shapes.begin(),
      Shape{Role::kLink, Shape::Kind::kPath, sketch.mechanism.bodies[joint.second.body].name,
            joint.second.body, true, "", rounded_hull({p_B + kRod * u * d_B, p_B + end * d_B}, kRod * u),
            sketch.look(joint.second.body).colour, sketch.look(joint.second.body).outline});
  const Role role = joint.first.body == 0 ? Role::kFixed : Role::kJoint;
  for (const double side : {1.0, -1.0}) {
    const Vector2d middle = p_A + at * d_A + side * kRod * u * perp(d_A);
    const Vector2d a = middle - side * kGuide * u * d_A, b = middle + side * kGuide * u * d_A;
    sketch.add(role, joint.name, joint.first.body, hatched(b, a, u));
  }
}

void add_block(Sketch& sketch, const Joint& joint) {
  const double u = sketch.unit;
  const auto [from, to] = rail_ends(sketch, joint);
  const Vector2d p_A = point_of(sketch.mechanism, joint.first),
                 p_B = point_of(sketch.mechanism, joint.second);
  const Rotation<double> R_BA = Rotation<double>::from_angle(-joint.relative_angle);
  const Vector2d& d = joint.direction_A;
  const Vector2d below = -kBlockWidth / 2 * u * perp(d);
  const Vector2d a = p_A + from * d, b = p_A + to * d;
  if (joint.first.body == 0) {
    sketch.add(Role::kFixed, joint.name, 0, hatched(a + below, b + below, u));
  } else {
    sketch.add(Role::kLink, joint.name, joint.first.body, rounded_hull({a, b}, 0.7 * u), true);
  }
  sketch.add(Role::kJoint, joint.name, joint.second.body,
             rectangle(p_B, R_BA * d, kBlock * u, kBlockWidth * u), true);
}

void add_slot(Sketch& sketch, const Joint& joint) {
  const double u = sketch.unit;
  const auto [from, to] = rail_ends(sketch, joint);
  const Vector2d p_A = point_of(sketch.mechanism, joint.first);
  const Vector2d a = p_A + from * joint.direction_A, b = p_A + to * joint.direction_A;
  sketch.add(Role::kLink, joint.name, joint.first.body, rounded_hull({a, b}, (kSlotHalf + 0.9) * u), true);
  sketch.add(Role::kJoint, joint.name, joint.first.body, rounded_hull({a, b}, kSlotHalf * u), true);
  sketch.add_circle(Role::kJoint, joint.name, joint.second.body, point_of(sketch.mechanism, joint.second),
                    kPinRadius * u);
}

// Both wheels, each with a radius drawn that shows its rotation.
void add_wheels(Sketch& sketch, const Joint& joint) {
  const MotionRow& row = *sketch.rows.front();
  const auto center_W = [&](const PointRef& ref) {
    return Vector2d(row.bodies[ref.body].X_WB * point_of(sketch.mechanism, ref));
  };
  const auto radii = wheel_radii(joint, (center_W(joint.first) - center_W(joint.second)).norm());
  const std::array<PointRef, 2> wheels{joint.first, joint.second};
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector2d p = point_of(sketch.mechanism, wheels[i]);
    sketch.add_circle(Role::kGear, joint.name, wheels[i].body, p, radii[i]);
    const Vector2d rim = p + Vector2d(radii[i], 0);
    sketch.add(Role::kGear, joint.name, wheels[i].body, {p.x(), p.y(), rim.x(), rim.y()});
  }
}

}  // namespace

std::array<double, 2> travelled_range(const Sketch& sketch, const Joint& joint) {
  double low = kInf, high = -kInf;
  for (const MotionRow* row : sketch.rows) {
    const Pose<double>& X_WA = row->bodies[joint.first.body].X_WB;
    const Vector2d b = row->bodies[joint.second.body].X_WB * point_of(sketch.mechanism, joint.second);
    const double t = (X_WA.inverse_times(b) - point_of(sketch.mechanism, joint.first)).dot(joint.direction_A);
    low = std::min(low, t);
    high = std::max(high, t);
  }
  return {low, high};
}

std::array<double, 2> rail_ends(const Sketch& sketch, const Joint& joint) {
  const double u = sketch.unit;
  const auto [low, high] = travelled_range(sketch, joint);
  if (joint.type == JointType::kSlot) {
    return {low - u, high + u};
  }
  const double room = (kBlock / 2 + 2) * u;
  return {low - std::max(room, kBlock / 2 * u + spring_room(sketch, joint)), high + room};
}

bool is_rod(const Sketch& sketch, const Joint& joint) {
  const auto is_of = [&](const CurveRef& ref) { return ref.body == joint.second.body; };
  return joint.type == JointType::kPrismatic &&
         std::any_of(sketch.mechanism.contacts.begin(), sketch.mechanism.contacts.end(),
                     [&](const Contact& contact) { return is_of(contact.first) || is_of(contact.second); });
}

StraightSpring spring_along(const Sketch& sketch, const Joint& joint) {
  const double u = sketch.unit;
  const double low = travelled_range(sketch, joint)[0];
  const Vector2d p_A = point_of(sketch.mechanism, joint.first),
                 p_B = point_of(sketch.mechanism, joint.second);
  StraightSpring spring = {joint.first.body, joint.second.body, p_A, p_B};
  const Rotation<double> R_BA = Rotation<double>::from_angle(-joint.relative_angle);
  if (joint.type == JointType::kSlot) {
    spring.first += (low - kShortestSpring * u) * joint.direction_A;
    spring.shift = kBesideSlot * u * perp(joint.direction_A);
  } else if (is_rod(sketch, joint)) {
    const RodLayout rod = rod_layout(sketch, joint);
    const Vector2d d_A = rod.sense * joint.direction_A;
    spring.first += (rod.guide + kGuide * u) * d_A;
    spring.second += R_BA * (rod.end * d_A);
  } else {
    spring.first += (low - (kBlock / 2 + kShortestSpring) * u) * joint.direction_A;
    spring.second -= R_BA * (kBlock / 2 * u * joint.direction_A);
  }
  return spring;
}

void add_spring_walls(Sketch& sketch, const std::vector<std::optional<StraightSpring>>& springs) {
  const MotionRow& row = *sketch.rows.front();
  for (std::size_t i = 0; i < springs.size(); ++i) {
    if (!springs[i]) continue;
    const StraightSpring& spring = *springs[i];
    const Vector2d shift = row.bodies[spring.first_body].X_WB.R_WB * spring.shift;
    const Vector2d first = row.bodies[spring.first_body].X_WB * spring.first + shift;
    const Vector2d second = row.bodies[spring.second_body].X_WB * spring.second + shift;
    const Vector2d outwards = kWall * sketch.unit * (first - second).normalized();
    const std::string& name = sketch.mechanism.springs[i].name;
    const auto add_wall = [&](const Vector2d& p, const Vector2d& away) {
      if (has_pivot(sketch, p)) return;
      sketch.add(Role::kFixed, name, 0, hatched(p - perp(away), p + perp(away), sketch.unit));
    };
    if (spring.first_body == 0) add_wall(first, outwards);
    if (spring.second_body == 0) add_wall(second, -outwards);
  }
}

std::array<double, 2> wheel_radii(const Joint& joint, double distance) {
  const double k = joint.turning_ratio;
  const double first = std::abs(k);  // of the second wheel
  if (joint.type == JointType::kBelt) {
    const double largest = 0.4 * distance / std::max(first, 1.0);
    return {largest * first, largest};
  }
  const double second = k == 1 ? distance / 2 : distance / std::abs(k - 1);
  return {first * second, second};
}

void add_joints(Sketch& sketch) {
  for (const Joint& joint : sketch.mechanism.joints) {
    switch (joint.type) {
      case JointType::kRevolute:
        add_pin(sketch, joint);
        break;
      case JointType::kPrismatic:
        if (is_rod(sketch, joint)) {
          add_rod(sketch, joint);
        } else {
          add_block(sketch, joint);
        }
        break;
      case JointType::kSlot:
        add_slot(sketch, joint);
        break;
      case JointType::kGears:
      case JointType::kBelt:
        add_wheels(sketch, joint);
        break;
    }
  }
}

}  // namespace higherpair
