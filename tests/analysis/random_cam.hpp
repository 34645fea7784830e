#pragma once

#include "analysis/mechanism_builder.hpp"
#include "linkage/linkage_testing.hpp"

namespace higherpair::testing {

enum class CamShape { kDisc, kOval, kEdge };

/// A cam and a follower, both on ground joints, that touch with the given shapes; two links may be attached
/// to the follower. The start is well away from limits, but the motion may meet some.
class RandomCam {
public:
  RandomCam(unsigned seed, double scale) : random_(seed), scale_(scale) {}

  Mechanism build(CamShape first, CamShape second) {
    const int cam = b_.body("cam", place(), random_.angle());
    const int follower = b_.body("follower", place(), random_.angle());
    const bool cam_turns = random_.between(0, 1) < 0.8;
    b_.drive(cam_turns ? b_.revolute(0, cam, place()) : b_.prismatic(0, cam, place(), heading(), 0));
    const Vector2d p = place(), n = heading();
    const CurveRef on_cam = curve(first, cam, p, n);
    const CurveRef on_follower = curve(second, follower, p, -n);
    if (chance()) {
      b_.revolute(0, follower, p + length(0.4, 1.5) * turned(n, sign() * random_.between(0.7, 2.4)));
    } else {
      b_.prismatic(0, follower, p, turned(n, random_.between(-1, 1)), 0.2 * scale_);
    }
    chance() ? b_.contact(on_cam, on_follower) : b_.contact(on_follower, on_cam);
    if (chance()) {
      links_behind(follower);
    }
    return b_.mechanism;
  }

private:
  static Vector2d turned(const Vector2d& v, double angle) { return Rotation<double>::from_angle(angle) * v; }
  Vector2d place() { return {length(-1, 1), length(-1, 1)}; }
  Vector2d heading() { return turned(Vector2d(1, 0), random_.angle()); }
  double length(double low, double high) { return scale_ * random_.between(low, high); }
  double sign() { return chance() ? 1 : -1; }
  bool chance() { return random_.between(0, 1) < 0.5; }

  // A curve of the given shape on the body, through p with the outward normal n.
  CurveRef curve(CamShape shape, int body, const Vector2d& p, const Vector2d& n) {
    if (shape == CamShape::kEdge) {
      return b_.edge(body, p);
    }
    const double radius = length(0.1, 0.8);
    return shape == CamShape::kDisc ? b_.circle(body, p - radius * n, radius)
                                    : b_.ellipse_at(body, p, n, {radius, length(0.2, 0.6)}, random_.angle());
  }

  void links_behind(int follower) {
    const Vector2d C = place(), u = heading();
    const int a = b_.body("a", place(), random_.angle());
    const int b = b_.body("b", place(), random_.angle());
    b_.revolute(follower, a, C + length(0.5, 1) * u);
    b_.revolute(a, b, C);
    b_.revolute(b, 0, C + length(0.5, 1) * turned(u, sign() * random_.between(0.9, 2.2)));
  }

  Random random_;
  double scale_;
  Builder b_;
};

}  // namespace higherpair::testing
