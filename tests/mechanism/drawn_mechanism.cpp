#include "drawn_mechanism.hpp"

#include <cmath>

#include <fmt/core.h>

namespace higherpair {

DrawnMechanism::DrawnMechanism() {
  body("ground");
}

int DrawnMechanism::body(const std::string& name) {
  mechanism.bodies.emplace_back();
  mechanism.bodies.back().name = name;
  return static_cast<int>(mechanism.bodies.size()) - 1;
}

PointRef DrawnMechanism::point(int body, const Vector2d& p_W) {
  auto& points = mechanism.bodies[body].points;
  points.push_back({fmt::format("P{}", points.size()), p_W});
  return {body, static_cast<int>(points.size()) - 1};
}

int DrawnMechanism::add(const Joint& joint) {
  mechanism.joints.push_back(joint);
  return static_cast<int>(mechanism.joints.size()) - 1;
}

int DrawnMechanism::pin(int first, int second, const Vector2d& p_W) {
  Joint joint;
  joint.name = fmt::format("pin{}", mechanism.joints.size());
  joint.first = point(first, p_W);
  joint.second = point(second, p_W);
  return add(joint);
}

int DrawnMechanism::slide(int first, int second, const Vector2d& p_W, const Vector2d& direction_W) {
  const int index = pin(first, second, p_W);
  Joint& joint = mechanism.joints.back();
  joint.name = fmt::format("slide{}", index);
  joint.type = JointType::kPrismatic;
  joint.direction_A = direction_W.normalized();
  return index;
}

int DrawnMechanism::slot(int first, int second, const Vector2d& p_W, const Vector2d& direction_W) {
  const int index = slide(first, second, p_W, direction_W);
  mechanism.joints.back().name = fmt::format("slot{}", index);
  mechanism.joints.back().type = JointType::kSlot;
  return index;
}

int DrawnMechanism::touch(int first, const Curve& curve1, int second, const Curve& curve2, bool rolling) {
  const auto add_curve = [&](int body, const Curve& curve) {
    auto& curves = mechanism.bodies[body].curves;
    curves.push_back({fmt::format("c{}", curves.size()), curve});
    return CurveRef{body, static_cast<int>(curves.size()) - 1};
  };
  Contact contact;
  contact.name = fmt::format("touch{}", mechanism.contacts.size());
  contact.first = add_curve(first, curve1);
  contact.second = add_curve(second, curve2);
  contact.rolling = rolling;
  mechanism.contacts.push_back(contact);
  return static_cast<int>(mechanism.contacts.size()) - 1;
}

void DrawnMechanism::drive(int joint, const std::string& name) {
  mechanism.drivers.push_back({name, joint});
}

int DrawnMechanism::crank(const std::string& name, const Vector2d& O) {
  const int crank = body(name);
  pin(0, crank, O);
  return crank;
}

int DrawnMechanism::dyad(const std::string& name, int a, const Vector2d& A, int b, const Vector2d& B,
                         const Vector2d& C) {
  const int link_a = body(name + "_a");
  const int link_b = body(name + "_b");
  pin(a, link_a, A);
  pin(b, link_b, B);
  pin(link_a, link_b, C);
  return link_a;
}

DrawnMechanism drawn_four_bar(double ground, double crank, double coupler, double rocker) {
  DrawnMechanism drawn;
  const Vector2d O4(ground, 0);
  const Vector2d A = crank * unit_vector(1.1);
  const Vector2d AO4 = O4 - A;
  const double d = AO4.norm();
  const double along = (coupler * coupler + d * d - rocker * rocker) / (2 * d);
  const double height = std::sqrt(coupler * coupler - along * along);
  const Vector2d B = A + along / d * AO4 + height / d * perp(AO4);
  const int link = drawn.crank("crank", Vector2d::Zero());
  drawn.drive(0);
  drawn.dyad("dyad", link, A, 0, O4, B);
  return drawn;
}

}  // namespace higherpair
