#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>
#include <cmath>

namespace higherpair::bench {

/// A Watt six-bar with forces as it would be written by hand for this one mechanism: crank A-B at unit speed,
/// coupler B-C, triangle C-E-H on ground at E, link H-D, rocker D-F on ground at F. Angles in, angles, rates,
/// pin forces and driving torque out, without any checks. Every body's frame is at its first pin (the
/// triangle's at E), with x towards its second (C for coupler and triangle, D for link and rocker); SI units.
struct SixBarByHand {
  enum Moving { kCrank, kCoupler, kTriangle, kLink, kRocker };
  enum Pins { kA, kB, kC, kE, kH, kD, kF };

  struct Load {
    double mass = 0, inertia = 0;  ///< about the centre of mass
    Vector2d center_B = Vector2d::Zero();
    Vector2d force_W = Vector2d::Zero();  ///< at the centre of mass, without weight
    double torque = 0;
  };

  double crank, coupler, triangle, link, rocker;  ///< lengths
  Vector2d E_W, F_W, H_B;                         ///< H in the triangle's frame
  double sigma1, sigma2;                          ///< ±1: on which sides C and D lie
  double gravity;
  std::array<Load, 5> loads;

  struct Turn {
    double theta, omega, alpha;
  };
  struct Point {
    Vector2d p, v, a;
  };
  struct Dyad {
    Turn first, second;
    Vector2d along1, along2;  ///< from the known pins to the inner one
  };

  [[nodiscard]] static double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  }
  [[nodiscard]] static Vector2d turned(const Vector2d& a) { return {-a.y(), a.x()}; }

  /// The point at r (in ground) from P on a body that turns about P.
  [[nodiscard]] static Point carried(const Point& P, const Turn& body, const Vector2d& r) {
    return {P.p + r, P.v + body.omega * turned(r),
            P.a + body.alpha * turned(r) - body.omega * body.omega * r};
  }

  [[nodiscard]] static Dyad solve(const Point& P, const Point& Q, double r1, double r2, double sigma) {
    const Vector2d d = Q.p - P.p;
    const double d2 = d.squaredNorm();
    const double along = (r1 * r1 - r2 * r2 + d2) / (2 * d2);
    const double across = sigma * std::sqrt(r1 * r1 / d2 - along * along);
    const Vector2d b = along * d + across * turned(d);
    const Vector2d c = b - d;
    const double det = cross(b, c);
    const Vector2d v = Q.v - P.v;
    const double omega1 = v.dot(c) / det;
    const double omega2 = v.dot(b) / det;
    const Vector2d a = Q.a - P.a + omega1 * omega1 * b - omega2 * omega2 * c;
    return {{std::atan2(b.y(), b.x()), omega1, a.dot(c) / det},
            {std::atan2(c.y(), c.x()), omega2, a.dot(b) / det},
            b,
            c};
  }

  /// All that acts on a body except its pins, inertia included: the force, and its moment about P.
  struct Wrench {
    Vector2d force;
    double moment;
  };
  [[nodiscard]] Wrench wrench(const Load& load, const Point& P, const Turn& body,
                              const Vector2d& direction) const {
    const Vector2d r = load.center_B.x() * direction + load.center_B.y() * turned(direction);
    const Point G = carried(P, body, r);
    const Vector2d force = load.force_W - load.mass * (G.a + Vector2d(0, gravity));
    return {force, cross(r, force) + load.torque - load.inertia * body.alpha};
  }

  /// The force of a dyad's second body on the first at their common pin.
  [[nodiscard]] static Vector2d inner_force(const Dyad& dyad, const Wrench& first, const Wrench& second) {
    const double det = cross(dyad.along1, dyad.along2);
    // along1 × F = -first.moment, along2 × F = second.moment
    return (-first.moment * dyad.along2 - second.moment * dyad.along1) / det;
  }

  struct Motion {
    Turn drive;
    Dyad front, rear;
    Point B, H;
    Vector2d EH;
  };
  [[nodiscard]] Motion motion_at(double theta) const {
    const Point A{Vector2d::Zero(), Vector2d::Zero(), Vector2d::Zero()};
    const Point E{E_W, Vector2d::Zero(), Vector2d::Zero()};
    const Point F{F_W, Vector2d::Zero(), Vector2d::Zero()};
    Motion motion;
    motion.drive = {theta, 1, 0};
    motion.B = carried(A, motion.drive, crank * Vector2d(std::cos(theta), std::sin(theta)));
    motion.front = solve(motion.B, E, coupler, triangle, sigma1);
    const Vector2d t = motion.front.along2 / triangle;
    motion.EH = H_B.x() * t + H_B.y() * turned(t);
    motion.H = carried(E, motion.front.second, motion.EH);
    motion.rear = solve(motion.H, F, link, rocker, sigma2);
    return motion;
  }

  struct Forces {
    std::array<Vector2d, 7> pins;  ///< on the pin's second body, the one farther from the crank's pivot
    double torque;
  };
  [[nodiscard]] Forces forces_of(const Motion& motion) const {
    const auto& [drive, front, rear, B, H, EH] = motion;
    const Point A{Vector2d::Zero(), Vector2d::Zero(), Vector2d::Zero()};
    const Point E{E_W, Vector2d::Zero(), Vector2d::Zero()};
    const Point F{F_W, Vector2d::Zero(), Vector2d::Zero()};
    const Wrench on_link = wrench(loads[kLink], H, rear.first, rear.along1 / link);
    const Wrench on_rocker = wrench(loads[kRocker], F, rear.second, rear.along2 / rocker);
    const Vector2d D = inner_force(rear, on_link, on_rocker);
    const Vector2d on_H = -on_link.force - D;  // triangle on link
    const Wrench on_coupler = wrench(loads[kCoupler], B, front.first, front.along1 / coupler);
    Wrench on_triangle = wrench(loads[kTriangle], E, front.second, front.along2 / triangle);
    on_triangle.force -= on_H;
    on_triangle.moment -= cross(EH, on_H);
    const Vector2d C = inner_force(front, on_coupler, on_triangle);
    const Vector2d on_B = -on_coupler.force - C;  // crank on coupler
    const Wrench on_crank = wrench(loads[kCrank], A, drive, B.p / crank);
    return {{on_B - on_crank.force, on_B, -C, C - on_triangle.force, on_H, -D, D - on_rocker.force},
            cross(B.p, on_B) - on_crank.moment};
  }
};

}  // namespace higherpair::bench
