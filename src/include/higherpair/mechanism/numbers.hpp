#pragma once

#include "higherpair/mechanism/description.hpp"

#include <type_traits>
#include <vector>

namespace higherpair {

enum class NumberKind {
  kLength,  ///< [m]: coordinates and dimensions
  kPure,    ///< angles, directions, ratios
  kLoad,    ///< masses, forces, stiffnesses
};

/// Calls f(number, kind), or f(number), for the quantities of a mechanism in an order that only depends on
/// which bodies, points, curves, joints, loads and springs there are. Left out are boundaries and laws, which
/// are functions, and the ends of joints and the teeth of gears, which no position or rate depends on.
template <class M, class F>
void for_each_number(M& mechanism, F f) {
  const auto number = [&](auto& value, NumberKind kind) {
    if constexpr (std::is_invocable_v<F&, decltype(value), NumberKind>) {
      f(value, kind);
    } else {
      f(value);
    }
  };
  const auto vector = [&](auto& v, NumberKind kind) {
    number(v.x(), kind);
    number(v.y(), kind);
  };
  vector(mechanism.gravity_W, NumberKind::kLoad);
  for (auto& body : mechanism.bodies) {
    vector(body.guess_p_WB, NumberKind::kLength);
    number(body.guess_theta, NumberKind::kPure);
    for (auto& point : body.points) {
      vector(point.p_B, NumberKind::kLength);
    }
    for (auto& named : body.curves) {
      auto& curve = named.curve;
      vector(curve.vertex_B, NumberKind::kLength);
      vector(curve.axis_B, NumberKind::kPure);
      number(curve.semi_latus, NumberKind::kLength);
      number(curve.q, NumberKind::kPure);
    }
    if (body.mass) {
      number(body.mass->mass, NumberKind::kLoad);
      vector(body.mass->center_of_mass_B, NumberKind::kLength);
      number(body.mass->inertia, NumberKind::kLoad);
    }
  }
  for (auto& joint : mechanism.joints) {
    vector(joint.direction_A, NumberKind::kPure);
    number(joint.relative_angle, NumberKind::kPure);
    number(joint.turning_ratio, NumberKind::kPure);
  }
  for (auto& load : mechanism.loads) {
    vector(load.p_B, NumberKind::kLength);
    vector(load.force, NumberKind::kLoad);
    number(load.torque, NumberKind::kLoad);
  }
  for (auto& spring : mechanism.springs) {
    number(spring.stiffness, NumberKind::kLoad);
    number(spring.free, NumberKind::kLoad);
    number(spring.damping, NumberKind::kLoad);
  }
}

/// All of them, in that order.
[[nodiscard]] inline std::vector<double> numbers_of(const Mechanism& mechanism) {
  std::vector<double> numbers;
  for_each_number(mechanism, [&](double number) { numbers.push_back(number); });
  return numbers;
}

}  // namespace higherpair
