#pragma once

#include "higherpair/mechanism/description.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <string>

#include <fmt/core.h>

namespace higherpair::testing {

/// Builds a mechanism from an assembled position: bodies are placed first, and joined where their points
/// coincide.
class Builder {
public:
  Builder() { (void)body("ground", Vector2d::Zero(), 0); }

  int body(const std::string& name, const Vector2d& p_W, double theta) {
    mechanism.bodies.push_back(Body{name, p_W, theta, {}, {}, {}});
    return static_cast<int>(mechanism.bodies.size()) - 1;
  }

  PointRef point(int index, const Vector2d& p_W) {
    Body& body = at(index);
    body.points.push_back({fmt::format("p{}", body.points.size()), in_body(index, p_W)});
    return {index, static_cast<int>(body.points.size()) - 1};
  }

  int revolute(int a, int b, const Vector2d& p_W) {
    return add(
        {name(), JointType::kRevolute, point(a, p_W), point(b, p_W), Vector2d::UnitX(), 0, 0, 1, {}, {}, {}});
  }

  /// The first point lies `back` behind the second along the direction; `back` is the joint's coordinate.
  int prismatic(int a, int b, const Vector2d& p_W, const Vector2d& direction_W, double back) {
    return add({name(),
                JointType::kPrismatic,
                point(a, p_W - back * direction_W),
                point(b, p_W),
                turned_back(a, direction_W),
                at(b).guess_theta - at(a).guess_theta,
                0,
                1,
                {},
                {},
                {}});
  }

  int slot(int a, int b, const Vector2d& p_W, const Vector2d& direction_W, double back) {
    return add({name(),
                JointType::kSlot,
                point(a, p_W - back * direction_W),
                point(b, p_W),
                turned_back(a, direction_W),
                0,
                0,
                1,
                {},
                {},
                {}});
  }

  CurveRef circle(int index, const Vector2d& center_W, double radius) {
    return curve(index, make_circle(in_body(index, center_W), radius).value());
  }

  CurveRef edge(int index, const Vector2d& p_W) {
    return curve(index, make_point(in_body(index, p_W)).value());
  }

  /// The ellipse whose outward normal at p_W is n_W.
  CurveRef ellipse_at(int index, const Vector2d& p_W, const Vector2d& n_W, const Vector2d& semi_axes,
                      double rotation) {
    const Rotation<double> R = Rotation<double>::from_angle(rotation);
    const Vector2d n = R.inverse() * turned_back(index, n_W);
    const Vector2d scaled = semi_axes.cwiseProduct(n);
    const Vector2d p = semi_axes.cwiseProduct(scaled) / scaled.norm();
    return curve(index,
                 make_ellipse(in_body(index, p_W) - R * p, {semi_axes.x(), semi_axes.y()}, rotation).value());
  }

  void contact(const CurveRef& first, const CurveRef& second) {
    Contact contact;
    contact.name = fmt::format("c{}", mechanism.contacts.size());
    contact.first = first;
    contact.second = second;
    mechanism.contacts.push_back(contact);
  }

  void drive(int joint) {
    mechanism.drivers.push_back({fmt::format("d{}", mechanism.drivers.size()), joint});
  }

  [[nodiscard]] double coordinate(int joint) const {
    return joint_motion(mechanism, mechanism.joints[joint], posed_bodies(mechanism)).position;
  }

  Mechanism mechanism;

private:
  Body& at(int index) { return mechanism.bodies[index]; }
  std::string name() { return fmt::format("j{}", mechanism.joints.size()); }

  Vector2d turned_back(int index, const Vector2d& v_W) {
    return Rotation<double>::from_angle(at(index).guess_theta).inverse() * v_W;
  }
  Vector2d in_body(int index, const Vector2d& p_W) { return turned_back(index, p_W - at(index).guess_p_WB); }

  int add(const Joint& joint) {
    mechanism.joints.push_back(joint);
    return static_cast<int>(mechanism.joints.size()) - 1;
  }
  CurveRef curve(int index, const Curve& curve) {
    Body& body = at(index);
    body.curves.push_back({fmt::format("k{}", body.curves.size()), curve});
    return {index, static_cast<int>(body.curves.size()) - 1};
  }
};

}  // namespace higherpair::testing
