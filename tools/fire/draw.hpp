#pragma once

#include "higherpair/geometry/pose.hpp"
#include "sketch.hpp"

#include <cstdint>
#include <random>

namespace higherpair::fire {

/// Random numbers; a seed gives the same ones on every machine.
class Draw {
public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  int pick(int count) { return static_cast<int>(between(0, count)); }
  bool chance(double p) { return between(0, 1) < p; }
  double angle() { return between(-kPi, kPi); }

private:
  std::mt19937_64 engine_;
};

inline Sketch::Point as_point(const Vector2d& p) {
  return {p.x(), p.y()};
}

/// A body that turns about O on ground, driven from `angle` over `range`.
inline Sketch driven_at(const Vector2d& O, double angle, double range) {
  Sketch sketch;
  sketch.bodies.front().points = {as_point(O)};
  sketch.bodies.push_back({O.x(), O.y(), angle, {{}}, {}, {}});
  sketch.joints.push_back({Sketch::JointKind::kRevolute, {0, 0}, {1, 0}});
  sketch.drivers.push_back({0, angle, angle + range});
  return sketch;
}

/// Adds a body that turns about its origin on ground or slides along a direction.
inline void mount(Sketch& sketch, const Vector2d& at, double angle, bool turns, double direction) {
  sketch.bodies.front().points.push_back(as_point(at));
  sketch.bodies.push_back({at.x(), at.y(), angle, {{}}, {}, {}});
  sketch.joints.push_back(
      {turns ? Sketch::JointKind::kRevolute : Sketch::JointKind::kPrismatic, {0, 1}, {2, 0}, direction});
}

}  // namespace higherpair::fire
