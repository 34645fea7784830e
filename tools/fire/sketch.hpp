#pragma once

#include "case.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace higherpair::fire {

/// A whole mechanism, by the numbers of its profile; lengths [m], angles [rad].
struct Sketch {
  struct Point {
    double x = 0, y = 0;  ///< in the body's frame
  };
  /// A closed spline through points, a polygon with rounded corners, or any curve written as in a profile.
  struct Outline {
    std::vector<Point> points;
    bool spline = false;
    double fillet = 0;   ///< of a polygon's corners
    std::string text{};  ///< if not empty: the curve's text in the profile
  };
  struct Body {
    double x = 0, y = 0, angle = 0;  ///< the pose
    std::vector<Point> points;       ///< named P0, P1, …
    std::vector<Shape> curves;       ///< named C0, C1, …
    std::vector<Outline> outlines;   ///< named K0, K1, …
  };
  struct Ref {
    int body = 0;
    int item = 0;  ///< index of a point or curve
  };
  enum class JointKind { kRevolute, kPrismatic, kSlot, kGears, kBelt };
  struct Joint {
    JointKind kind = JointKind::kRevolute;
    Ref first, second;
    double direction = 0;                    ///< of a slide or slot, in the first body's frame
    double ratio = 1;                        ///< of gears and belts
    bool same_sense = true;                  ///< internal gears, an open belt
    int carrier = 0;                         ///< body that carries the wheels of gears and belts
    double from = -HUGE_VAL, to = HUGE_VAL;  ///< ends of a slide's or slot's line
  };
  struct Contact {
    Ref first, second;
    bool rolling = false;
    bool outlined = false;  ///< `first` refers to an outline
    bool both_outlined = false;
  };
  struct Driver {
    int joint = 0;
    double start = 0, end = 0;  ///< `end` is for analyze
    double velocity = 1, acceleration = 0;
    std::string law{};  ///< if not empty: a law of time, instead of these numbers
  };

  std::vector<Body> bodies{1};  ///< bodies[0] is ground
  std::vector<Joint> joints;
  std::vector<Contact> contacts;
  std::vector<Driver> drivers;
  double duration = 0;  ///< of `step` [s]; 0: the case is for `analyze`
  std::string tables;   ///< text of the laws

  /// At most one: a mechanism with the same motion, made by other means than the boundary under test.
  std::vector<Sketch> twin;
};

/// The numbers in its profile, to be rounded one by one.
[[nodiscard]] std::vector<double*> numbers(Sketch& sketch);

/// Its profile, with all digits.
[[nodiscard]] std::string profile_of(const Sketch& sketch, const std::string& title);

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
