#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <cmath>
#include <random>

namespace higherpair::testing {

/// A pair with a driver position and a rough coordinate of the follower.
struct RandomCase {
  ContactPair pair;
  double size = 1;  ///< of the mechanism [m]
  double u = 0;
  double q = 0;
};

/// Pairs over all kinds of curves, sides and joints. They are the same on every machine and in every run:
/// only the standard's generator is used, because its distributions differ between implementations.
class RandomPairs {
public:
  explicit RandomPairs(unsigned seed) : engine_(seed) {}

  RandomCase next() {
    RandomCase one;
    one.size = std::pow(10.0, between(-3, 3));
    const int kind1 = pick(6);
    const bool ring1 = kind1 < 4 && pick(5) == 0;
    int kind2 = pick(6);
    while ((kind1 >= 4 && kind2 == kind1) || (ring1 && kind2 == 4)) kind2 = pick(6);
    const bool ring2 = !ring1 && kind1 != 4 && kind2 < 4 && pick(5) == 0;
    one.pair.curve1 = curve(kind1, ring1, one.size);
    one.pair.curve2 = curve(kind2, ring2, one.size);
    one.pair.motion1 = joint(one.size);
    one.pair.motion2 = joint(one.size);
    one.u = one.pair.motion1.turns ? between(-kPi, kPi) : one.size * between(-1, 1);
    one.q = one.pair.motion2.turns ? between(-kPi, kPi) : one.size * between(-3, 3);
    return one;
  }

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  int pick(int count) { return static_cast<int>(between(0, count)); }
  Vector2d vector(double size) { return {between(-size, size), between(-size, size)}; }

private:
  // Mostly of about the mechanism's size (rings are larger), some very small or very large.
  Curve curve(int kind, bool ring, double size) {
    const Side side = ring ? Side::kOutside : Side::kInside;
    const double decades = pick(4) == 0 ? between(-3, 3) : between(-0.7, 0.3);
    const double a = size * (ring ? 4 : 1) * std::pow(10.0, decades);
    const double b = a * std::pow(10.0, between(-1, 0));
    const double angle = between(-kPi, kPi);
    const Vector2d at_B = vector(size);
    switch (kind) {
      case 0:
        return make_circle(at_B, a, side).value();
      case 1:
        return make_ellipse(at_B, {a, b}, angle, side).value();
      case 2:
        return make_parabola(at_B, a, angle, side).value();
      case 3:
        return make_hyperbola(at_B, {a, b}, angle, side).value();
      case 4:
        return make_line(at_B, unit_vector(angle)).value();
      default:
        return make_point(at_B).value();
    }
  }

  OneFreedom joint(double size) {
    OneFreedom freedom;
    freedom.turns = pick(2) == 0;
    freedom.p_WO = vector(2 * size);
    freedom.p_BO = vector(size);
    freedom.direction_W = unit_vector(between(-kPi, kPi));
    freedom.theta = between(-kPi, kPi);
    freedom.R_WB = Rotation<double>::from_angle(freedom.theta);
    return freedom;
  }

  std::mt19937_64 engine_;
};

}  // namespace higherpair::testing
