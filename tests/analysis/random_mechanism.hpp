#pragma once

#include "analysis/mechanism_builder.hpp"
#include "linkage/linkage_testing.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace higherpair::testing {

struct RandomMechanism {
  Mechanism mechanism;
  double start = 0;  ///< coordinate of the driven joint in the poses
};

/// Groups of bodies between two known ones. S: the slot variant, in which the line is guided by a pin without
/// a slider body.
enum class RandomGroup { kRrr, kRrp, kRrpS, kRpr, kRprS, kPrp, kRpp, kRppS, kTouching };

inline constexpr std::array kAllRandomGroups{RandomGroup::kRrr, RandomGroup::kRrp,  RandomGroup::kRrpS,
                                             RandomGroup::kRpr, RandomGroup::kRprS, RandomGroup::kPrp,
                                             RandomGroup::kRpp, RandomGroup::kRppS, RandomGroup::kTouching};

/// Mechanisms of random groups, each well away from its dead points and attached to the bodies before it.
class RandomBuilder {
public:
  /// \param groups  the kinds to draw from
  RandomBuilder(unsigned seed, std::size_t most_bodies,
                std::span<const RandomGroup> groups = kAllRandomGroups)
      : random_(seed), most_bodies_(most_bodies), groups_(groups) {}

  RandomMechanism build() {
    const int crank = body();
    const Vector2d p_W = place();
    const bool turns = random_.between(0, 1) < 0.7;
    const int joint =
        turns ? b_.revolute(0, crank, p_W) : b_.prismatic(0, crank, p_W, heading(), random_.between(0.2, 1));
    b_.drive(joint);
    known_ = {0, crank};
    while (b_.mechanism.bodies.size() + 2 <= most_bodies_) {
      add_group();
    }
    return {b_.mechanism, b_.coordinate(joint)};
  }

private:
  int body() { return b_.body(fmt::format("b{}", b_.mechanism.bodies.size()), place(), random_.angle()); }
  Vector2d place() { return {random_.between(-1, 1), random_.between(-1, 1)}; }
  Vector2d heading() {
    const double angle = random_.angle();
    return {std::cos(angle), std::sin(angle)};
  }
  static Vector2d turned(const Vector2d& v, double angle) { return Rotation<double>::from_angle(angle) * v; }
  double sign() { return random_.between(-1, 1) < 0 ? -1 : 1; }
  /// Picks a moving body and any other one, in random order.
  void choose(int& moving, int& other) {
    moving = known_[1 + index(known_.size() - 1)];
    do {
      other = known_[index(known_.size())];
    } while (other == moving);
    if (random_.between(0, 1) < 0.5) std::swap(moving, other);
  }
  std::size_t index(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(random_.between(0, static_cast<double>(count))));
  }
  double back() { return random_.between(-0.5, 0.5); }

  void add_group() {
    int k1 = 0, k2 = 0;
    choose(k1, k2);
    switch (groups_[index(groups_.size())]) {
      case RandomGroup::kRrr:
        return rrr(k1, k2);
      case RandomGroup::kRrp:
        return rrp(k1, k2, false);
      case RandomGroup::kRrpS:
        return rrp(k1, k2, true);
      case RandomGroup::kRpr:
        return rpr(k1, k2, false);
      case RandomGroup::kRprS:
        return rpr(k1, k2, true);
      case RandomGroup::kPrp:
        return prp(k1, k2);
      case RandomGroup::kRpp:
        return rpp(k1, k2, false);
      case RandomGroup::kRppS:
        return rpp(k1, k2, true);
      case RandomGroup::kTouching:
        return touching(k1, k2);
    }
  }
  void know(std::initializer_list<int> bodies) { known_.insert(known_.end(), bodies); }

  void rrr(int k1, int k2) {
    const Vector2d C = place(), u = heading();
    const Vector2d A = C + random_.between(0.3, 0.8) * u;
    const Vector2d B = C + random_.between(0.3, 0.8) * turned(u, sign() * random_.between(0.8, 2.3));
    const int a = body(), b = body();
    b_.revolute(k1, a, A);
    b_.revolute(b, k2, B);
    b_.revolute(a, b, C);
    know({a, b});
  }
  void rrp(int k1, int k2, bool slot) {
    const Vector2d C = place(), u = heading();
    const Vector2d A = C + sign() * random_.between(0.3, 0.8) * turned(u, random_.between(-0.9, 0.9));
    const int a = body();
    b_.revolute(a, k1, A);
    know({a});
    if (slot) {
      b_.slot(k2, a, C, u, back());
      return;
    }
    const int b = body();
    b_.revolute(b, a, C);
    sign() > 0 ? b_.prismatic(k2, b, C, u, back()) : b_.prismatic(b, k2, C + back() * u, u, back());
    know({b});
  }
  void rpr(int k1, int k2, bool slot) {
    const Vector2d A = place(), u = heading();
    const Vector2d B = A + sign() * random_.between(0.35, 0.9) * turned(u, random_.between(-0.9, 0.9));
    const int a = body();
    b_.revolute(k1, a, A);
    know({a});
    if (slot) {
      b_.slot(a, k2, B, u, back());
      return;
    }
    const int b = body();
    b_.revolute(k2, b, B);
    // The slide's points need not be at the pins.
    const Vector2d off = B + random_.between(-0.2, 0.2) * perp(u);
    sign() > 0 ? b_.prismatic(a, b, off, u, back()) : b_.prismatic(b, a, off, u, back());
    know({b});
  }
  void prp(int k1, int k2) {
    const Vector2d C = place(), u = heading();
    const int a = body(), b = body();
    sign() > 0 ? b_.prismatic(k1, a, C, u, back()) : b_.prismatic(a, k1, C, u, back());
    b_.prismatic(k2, b, C + 0.1 * heading(), turned(u, random_.between(0.7, 2.4)), back());
    b_.revolute(a, b, C);
    know({a, b});
  }
  void rpp(int k1, int k2, bool slot) {
    const Vector2d A = place(), u = heading(), w = turned(u, random_.between(0.7, 2.4));
    const int b = body();
    b_.prismatic(k2, b, place(), u, back());
    know({b});
    if (slot) {
      sign() > 0 ? b_.slot(b, k1, A, w, back()) : b_.slot(k1, b, A, w, back());
      return;
    }
    const int a = body();
    b_.revolute(k1, a, A);
    sign() > 0 ? b_.prismatic(b, a, A + 0.1 * heading(), w, back())
               : b_.prismatic(a, b, A + 0.1 * heading(), w, back());
    know({a});
  }
  void touching(int k1, int k2) {
    const Vector2d p = place(), n = heading();
    const int a = body();
    if (sign() > 0) {
      b_.revolute(k1, a, p + random_.between(0.4, 0.8) * turned(n, sign() * random_.between(0.8, 2.3)));
    } else {
      b_.prismatic(k1, a, p, turned(n, random_.between(-0.9, 0.9)), back());
    }
    const CurveRef known =
        b_.ellipse_at(k2, p, n, {random_.between(0.1, 0.3), random_.between(0.1, 0.3)}, random_.angle());
    const double radius = random_.between(0.05, 0.2);
    const CurveRef own = b_.circle(a, p + radius * n, radius);
    sign() > 0 ? b_.contact(known, own) : b_.contact(own, known);
    know({a});
  }

  Random random_;
  std::size_t most_bodies_;
  std::span<const RandomGroup> groups_;
  Builder b_;
  std::vector<int> known_;
};

}  // namespace higherpair::testing
