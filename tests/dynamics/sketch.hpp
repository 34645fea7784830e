#pragma once

#include "higherpair/mechanism/description.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <string>

#include <fmt/core.h>

namespace higherpair::testing {

/// A mechanism drawn in ground coordinates: every body's frame coincides with the ground's at the start, so
/// that the mechanism is assembled with all joint coordinates 0.
class Sketch {
public:
  explicit Sketch(unsigned seed) : random_(seed) { mechanism.bodies.emplace_back().name = "ground"; }

  Mechanism mechanism;

  /// A number between two others.
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  /// A random point at most `reach` from (x, y) along each axis.
  Vector2d near(double x, double y, double reach = 0.02) {
    return {x + number(-reach, reach), y + number(-reach, reach)};
  }

  int body() {
    const std::string name = fmt::format("b{}", mechanism.bodies.size());
    mechanism.bodies.emplace_back().name = name;
    return static_cast<int>(mechanism.bodies.size()) - 1;
  }

  PointRef point(int body, const Vector2d& p) {
    auto& points = mechanism.bodies[body].points;
    points.push_back({fmt::format("p{}", points.size()), p});
    return {body, static_cast<int>(points.size()) - 1};
  }

  int joint(JointType type, int first, int second, const Vector2d& p, double angle = 0) {
    Joint joint;
    joint.name = fmt::format("j{}", mechanism.joints.size());
    joint.type = type;
    joint.first = point(first, p);
    joint.second = point(second, p);
    joint.direction_A = unit_vector(angle);
    mechanism.joints.push_back(joint);
    return static_cast<int>(mechanism.joints.size()) - 1;
  }

  int pin(int first, int second, const Vector2d& p) { return joint(JointType::kRevolute, first, second, p); }

  int slide(int first, int second, const Vector2d& p, double angle) {
    return joint(JointType::kPrismatic, first, second, p, angle);
  }

  CurveRef curve(int body, const CurveResult& curve) {
    auto& curves = mechanism.bodies[body].curves;
    curves.push_back({"c", curve.value()});
    return {body, static_cast<int>(curves.size()) - 1};
  }

  void contact(const CurveRef& first, const CurveRef& second) {
    Contact contact;
    contact.name = fmt::format("k{}", mechanism.contacts.size());
    contact.first = first;
    contact.second = second;
    mechanism.contacts.push_back(contact);
  }

  void drive(int joint) { mechanism.drivers.push_back({fmt::format("d{}", joint), joint}); }

  /// The next body is a roller that spins freely about `pin`: no load may turn it.
  int roller(const Vector2d& pin) {
    const int index = body();
    mechanism.bodies.back().mass = MassProperties{0.3, pin, 0};
    first_roller_ = std::min(first_roller_, index);
    return index;
  }

  /// Masses of some bodies, and loads, springs and dampers everywhere.
  void load_randomly() {
    mechanism.gravity_W = near(0, -9.81, 3);
    const int bodies = std::min(first_roller_, static_cast<int>(mechanism.bodies.size()));
    for (int i = 1; i < bodies; ++i) {
      if (number(0, 1) < 0.8) {
        mechanism.bodies[i].mass = MassProperties{number(0.1, 2), near(0.1, 0, 0.1), number(1e-4, 1e-2)};
      }
      Load load;
      load.body = i;
      load.p_B = near(0.1, 0, 0.1);
      load.force = near(0, 0, 30);
      load.torque = number(-3, 3);
      load.frame = i % 2 == 0 ? LoadFrame::kBody : LoadFrame::kGround;
      mechanism.loads.push_back(load);
      Spring spring;
      spring.first = point(i - 1, near(0.1, 0.1, 0.05));
      spring.second = point(i, near(-0.1, -0.1, 0.05));
      spring.stiffness = number(10, 200);
      spring.free = number(0, 0.2);
      spring.damping = number(0, 5);
      mechanism.springs.push_back(spring);
    }
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
      if (mechanism.joints[i].second.body >= first_roller_) {
        continue;
      }
      Spring spring;
      spring.joint = static_cast<int>(i);
      spring.stiffness = number(0, 5);
      spring.free = number(-0.3, 0.3);
      spring.damping = number(0, 1);
      mechanism.springs.push_back(spring);
    }
  }

private:
  std::mt19937 random_;
  int first_roller_ = std::numeric_limits<int>::max();
};

}  // namespace higherpair::testing
