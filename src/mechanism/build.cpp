#include "higherpair/mechanism/description.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace higherpair {
namespace {

Body& body_at(Mechanism& mechanism, int body) {
  if (mechanism.bodies.empty()) {
    mechanism.bodies.push_back({"ground", Vector2d::Zero(), 0, {}, {}, {}});
  }
  return mechanism.bodies.at(static_cast<std::size_t>(body));
}

template <class Items>
int last_of(const Items& items) {
  return static_cast<int>(items.size()) - 1;
}

int add_joint(Mechanism& mechanism, const std::string& name, JointType type, PointRef first, PointRef second,
              const Vector2d& direction_A) {
  Joint joint;
  joint.name = name;
  joint.type = type;
  joint.first = first;
  joint.second = second;
  joint.direction_A = direction_A.normalized();
  mechanism.joints.push_back(joint);
  return last_of(mechanism.joints);
}

}  // namespace

bool has_forces(const Mechanism& mechanism) {
  return !mechanism.loads.empty() || !mechanism.springs.empty() ||
         std::any_of(mechanism.bodies.begin(), mechanism.bodies.end(),
                     [](const Body& body) { return body.mass.has_value(); });
}

int add_body(Mechanism& mechanism, const std::string& name, const Vector2d& p_W, double theta) {
  (void)body_at(mechanism, kGround);
  mechanism.bodies.push_back({name, p_W, theta, {}, {}, {}});
  return last_of(mechanism.bodies);
}

PointRef add_point(Mechanism& mechanism, int body, const std::string& name, const Vector2d& p_B) {
  auto& points = body_at(mechanism, body).points;
  points.push_back({name, p_B});
  return {body, last_of(points)};
}

CurveRef add_curve(Mechanism& mechanism, int body, const std::string& name, const Curve& curve) {
  auto& curves = body_at(mechanism, body).curves;
  curves.push_back({name, curve});
  return {body, last_of(curves)};
}

CurveRef add_curve(Mechanism& mechanism, int body, const std::string& name, Boundary boundary) {
  Curve curve;
  curve.kind = CurveKind::kChain;
  curve.vertex_B = boundary.middle_B();
  curve.q = 0;
  auto& curves = body_at(mechanism, body).curves;
  curves.push_back({name, curve, std::make_shared<const Boundary>(std::move(boundary))});
  return {body, last_of(curves)};
}

int add_revolute(Mechanism& mechanism, const std::string& name, PointRef first, PointRef second) {
  return add_joint(mechanism, name, JointType::kRevolute, first, second, Vector2d::UnitX());
}

int add_prismatic(Mechanism& mechanism, const std::string& name, PointRef first, PointRef second,
                  const Vector2d& direction_A) {
  const int joint = add_joint(mechanism, name, JointType::kPrismatic, first, second, direction_A);
  mechanism.joints.back().relative_angle =
      body_at(mechanism, second.body).guess_theta - body_at(mechanism, first.body).guess_theta;
  return joint;
}

int add_slot(Mechanism& mechanism, const std::string& name, PointRef first, PointRef second,
             const Vector2d& direction_A) {
  return add_joint(mechanism, name, JointType::kSlot, first, second, direction_A);
}

int add_contact(Mechanism& mechanism, const std::string& name, CurveRef first, CurveRef second) {
  Contact contact;
  contact.name = name;
  contact.first = first;
  contact.second = second;
  mechanism.contacts.push_back(contact);
  return last_of(mechanism.contacts);
}

int add_driver(Mechanism& mechanism, int joint, const std::string& name) {
  mechanism.drivers.push_back({name, joint});
  return last_of(mechanism.drivers);
}

}  // namespace higherpair
