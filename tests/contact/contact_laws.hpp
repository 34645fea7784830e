#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// The laws of a contact, written independently in extended precision from the curves' equation y² = 2 ℓ x - q
// x² and from rigid motion alone: no code that finds or follows contacts is used.

namespace higherpair::testing {

using Real = long double;
using Vec = Vector2<Real>;

inline Vec wide(const Vector2d& v) {
  return {v.x(), v.y()};
}

struct Standing {
  Curve curve;
  OneFreedom freedom;
  Rotation<Real> R;
  Vec origin;

  Standing(const Curve& c, const OneFreedom& f, double q) : curve(c), freedom(f) {
    R = Rotation<Real>::from_angle(f.turns ? Real(q) : Real(f.theta));
    const Vec joint = wide(f.p_WO) + (f.turns ? Vec(0, 0) : Vec(Real(q) * wide(f.direction_W)));
    origin = joint - R * wide(f.p_BO);
  }

  [[nodiscard]] Vec vertex() const { return R * wide(curve.vertex_B) + origin; }
  [[nodiscard]] Vec axis() const { return R * wide(curve.axis_B); }
  [[nodiscard]] double side() const { return curve.side == Side::kInside ? 1 : -1; }

  // x, y in the curve's own frame.
  [[nodiscard]] Vec local(const Vec& p) const {
    const Vec d = p - vertex();
    return {d.dot(axis()), cross(axis(), d)};
  }

  struct Shape {
    Real distance = 0;  // to first order; > 0 out of the body
    Vec n{0, 0};        // outward; zero for a point
    Real kappa = 0;
    bool on_branch = true;
    Real arm = 1;  // lever of rounding: an error of p divided by this length is that of n and κ
  };

  [[nodiscard]] Shape shape_at(const Vec& p) const {
    const Vec l = local(p);
    if (curve.kind == CurveKind::kPoint) return {l.norm(), {0, 0}, 0, true, 1};
    if (curve.kind == CurveKind::kLine) return {-l.x(), -axis(), 0, true, 1};
    const Real q = curve.q;
    const Vec grad(q * l.x() - curve.semi_latus, l.y());
    const Real length = grad.norm();
    const Real f = (l.y() * l.y() + q * l.x() * l.x()) / 2 - curve.semi_latus * l.x();
    const Vec n = (grad.x() * axis() + grad.y() * perp(axis())) / length;
    // (f_xx f_y² + f_yy f_x²)/|∇f|³. Its numerator equals q f + ℓ²; f = 0 is left out, because it would
    // cancel badly far out on a hyperbola.
    const Real kappa = Real(curve.semi_latus) * Real(curve.semi_latus) / (length * length * length);
    return {side() * f / length, side() * n, side() * kappa, q >= 0 || q * l.x() < curve.semi_latus, length};
  }

  [[nodiscard]] Vec velocity(const Vec& p) const {
    return freedom.turns ? perp(Vec(p - wide(freedom.p_WO))) : wide(freedom.direction_W);
  }
  [[nodiscard]] Vec acceleration(const Vec& p) const {
    return freedom.turns ? Vec(wide(freedom.p_WO) - p) : Vec(0, 0);
  }
  [[nodiscard]] Real omega() const { return freedom.turns ? 1 : 0; }
};

/// The sum of all lengths that enter the numbers of a contact: its rounding is relative to this.
inline double length_scale(const ContactPair& pair, const ContactPosition& at) {
  const Vector2d p = (at.p1_W + at.p2_W) / 2;
  return (p - pair.motion1.p_WO).norm() + (p - pair.motion2.p_WO).norm() + pair.motion1.p_BO.norm() +
         pair.motion2.p_BO.norm() + pair.curve1.vertex_B.norm() + pair.curve2.vertex_B.norm() + p.norm() +
         (pair.motion1.turns ? 0 : std::abs(at.u)) + (pair.motion2.turns ? 0 : std::abs(at.q));
}

/// The laws of the equivalent link, checked in position, velocity and acceleration; `broken` lists each law
/// that is violated by more than rounding.
class ContactLaws {
public:
  ContactLaws(const ContactPair& pair, const ContactPosition& at)
      : at_(at),
        one_(pair.curve1, pair.motion1, at.u),
        two_(pair.curve2, pair.motion2, at.q),
        n_(wide(at.n_W)),
        p_((wide(at.p1_W) + wide(at.p2_W)) / 2),
        length_(length_scale(pair, at)) {
    position();
    if (flat1() || flat2()) {
      slot();
    } else {
      link();
    }
  }

  std::vector<std::string> broken;

private:
  [[nodiscard]] bool flat1() const { return one_.curve.kind == CurveKind::kLine; }
  [[nodiscard]] bool flat2() const { return two_.curve.kind == CurveKind::kLine; }

  void expect_small(Real value, Real tolerance, const char* law) {
    if (!(std::abs(value) <= tolerance)) {
      broken.push_back(std::string(law) + ": " + std::to_string(double(value / tolerance)) + " tolerances");
    }
  }

  static Real radius(const Standing& body, const Standing::Shape& shape) {
    return body.curve.kind == CurveKind::kPoint ? 0 : 1 / shape.kappa;
  }

  [[nodiscard]] static bool is_curved(const Standing& body) {
    return body.curve.kind != CurveKind::kPoint && body.curve.kind != CurveKind::kLine;
  }

  // Where a curve is no larger than the rounding of its position, the contact point does not determine the
  // curvature, but the given radius does: κ = ℓ²/arm³.
  static Real sharpest(const Standing& body, const Standing::Shape& shape, Real rho) {
    return is_curved(body) ? std::max(std::abs(shape.kappa), 1 / std::abs(rho)) : std::abs(shape.kappa);
  }
  static Real shortest_arm(const Standing& body, const Standing::Shape& shape, Real rho) {
    const Real l = body.curve.semi_latus;
    return is_curved(body) ? std::min(shape.arm, std::cbrt(l * l * std::abs(rho))) : shape.arm;
  }

  void position() {
    // On a nearly flat curve a rounding error of the normal moves the point along the curve, not away from
    // it.
    const double tiny = 1e-13 * length_;
    const auto s1 = one_.shape_at(wide(at_.p1_W));
    const auto s2 = two_.shape_at(wide(at_.p2_W));
    expect_small((at_.p2_W - at_.p1_W).norm(), 1e-12 * length_, "closure");
    expect_small(s1.distance, tiny, "point 1 on curve 1");
    expect_small(s2.distance, tiny, "point 2 on curve 2");
    if (!s1.on_branch || !s2.on_branch) broken.emplace_back("branch of a hyperbola");
    const Real per_arm1 = 1e-14L * length_ / shortest_arm(one_, s1, at_.rho1);
    const Real per_arm2 = 1e-14L * length_ / shortest_arm(two_, s2, at_.rho2);
    const Real slack1 = 1e-12L + 1e-13L * length_ * sharpest(one_, s1, at_.rho1) + per_arm1;
    const Real slack2 = 1e-12L + 1e-13L * length_ * sharpest(two_, s2, at_.rho2) + per_arm2;
    if (one_.curve.kind != CurveKind::kPoint) expect_small((s1.n - n_).norm(), slack1, "normal of 1");
    if (two_.curve.kind != CurveKind::kPoint) expect_small((s2.n + n_).norm(), slack2, "normal of 2");
    expect_small(n_.norm() - 1, 1e-14L, "unit normal");
    rho1_ = flat1() ? 0 : radius(one_, s1);
    rho2_ = flat2() ? 0 : radius(two_, s2);
    doubt1_ = per_arm1 * std::abs(rho1_);
    doubt2_ = per_arm2 * std::abs(rho2_);
    if (!flat1()) expect_small(rho1_ - at_.rho1, 1e-10L * std::abs(rho1_) + doubt1_, "radius 1");
    if (!flat2()) expect_small(rho2_ - at_.rho2, 1e-10L * std::abs(rho2_) + doubt2_, "radius 2");
    const bool curved = one_.curve.kind != CurveKind::kPoint && two_.curve.kind != CurveKind::kPoint;
    conforming_ = curved ? (s1.kappa + s2.kappa) / (std::abs(s1.kappa) + std::abs(s2.kappa)) : 1;
  }

  // Residual of an equation, and the size of its terms.
  struct Balance {
    Real rest = 0;
    Real terms = 0;
  };

  // Error of an equation that comes from the uncertainty of the radii: they are evaluated at a point that is
  // known to a rounding of length_.
  template <class Equation>
  [[nodiscard]] Real owed_to_radii(const Equation& equation) const {
    const Real rest = equation(rho1_, rho2_).rest;
    return std::abs(equation(rho1_ + doubt1_, rho2_).rest - rest) +
           std::abs(equation(rho1_, rho2_ + doubt2_).rest - rest);
  }

  // Size of the terms that make up the speeds of the centres. Next to a pivot the speed of a point is
  // smaller, but its distance from the pivot still carries the rounding of both positions.
  [[nodiscard]] Real carried() const {
    const Real speed1 = one_.velocity(p_).norm() + one_.omega() * (std::abs(rho1_) + Real(length_));
    const Real speed2 = two_.velocity(p_).norm() + two_.omega() * (std::abs(rho2_) + Real(length_));
    return speed1 + std::abs(at_.dq) * speed2;
  }

  // Tolerance relative to the terms of an equation. Exactly at a change point the rates are interpolated from
  // positions beside it, where they are uncertain by 1e-16 over the distance.
  [[nodiscard]] Real share() const { return at_.gap_q == 0 ? 1e-9L : 1e-11L; }

  // The same for the terms of accelerations, from the rounding of positions alone.
  [[nodiscard]] Real carried_acceleration() const {
    const Real turning2 = (at_.dq * at_.dq + std::abs(at_.d2q)) * two_.omega();
    return (one_.omega() + turning2) * Real(length_);
  }

  // n·(v2(c2) - v1(c1)) = 0 and n·(a2(c2) - a1(c1)) + |v2(c2) - v1(c1)|²/(ρ1 + ρ2) = 0.
  void link() {
    const Vec c1 = p_ - rho1_ * n_;
    const Vec c2 = p_ + rho2_ * n_;
    const Vec v1 = one_.velocity(c1);
    const Vec v2 = Real(at_.dq) * two_.velocity(c2);
    const Real speed = one_.velocity(p_).norm() + std::abs(at_.dq) * two_.velocity(p_).norm();
    expect_small(n_.dot(v2 - v1), 1e-12L * speed + 1e-15L * carried(), "velocity of the link");
    const auto balance = [&](Real rho1, Real rho2) { return acceleration_of_link(rho1, rho2); };
    const Balance whole = balance(rho1_, rho2_);
    // Where n·v2 nearly vanishes, its rounding is magnified; a centre is only as accurate as the normal times
    // its radius.
    const Real lever = std::abs(at_.d2q) * (two_.velocity(p_).norm() + two_.velocity(c2).norm()) +
                       one_.acceleration(c1).norm() + at_.dq * at_.dq * two_.acceleration(c2).norm() +
                       (std::abs(rho1_) + std::abs(rho2_)) * (one_.omega() + at_.dq * at_.dq * two_.omega());
    // Where both bodies move nearly alike, v2 - v1 is mere rounding of the two; where the curves nearly
    // conform, the division by ρ1 + ρ2 magnifies it.
    const Real squared = 4e-16L * carried() * carried() / std::abs(rho1_ + rho2_);
    expect_small(whole.rest,
                 share() * whole.terms + 3e-14L * lever + 1e-15L * carried_acceleration() + squared +
                     owed_to_radii(balance),
                 "acceleration of the link");
  }

  [[nodiscard]] Balance acceleration_of_link(Real rho1, Real rho2) const {
    const Vec c1 = p_ - rho1 * n_;
    const Vec c2 = p_ + rho2 * n_;
    const Vec v1 = one_.velocity(c1);
    const Vec v2 = Real(at_.dq) * two_.velocity(c2);
    const Real relative = (v2 - v1).squaredNorm() / (rho1 + rho2);
    const Vec a1 = one_.acceleration(c1);
    const Vec a2 = Real(at_.d2q) * two_.velocity(c2) + Real(at_.dq * at_.dq) * two_.acceleration(c2);
    return {n_.dot(a2 - a1) + relative, std::abs(relative) + std::abs(n_.dot(a1)) + std::abs(n_.dot(a2))};
  }

  // The centre of the curved body moves along the face like a pin in a slot.
  void slot() {
    const auto balance = [&](Real rho1, Real rho2) { return acceleration_in_slot(flat2() ? rho1 : -rho2); };
    const Vec c = p_ - (flat2() ? rho1_ : -rho2_) * n_;
    const SlotRates r = slot_rates(c);
    expect_small(n_.dot(r.v_pin - r.v_face), 1e-12L * (r.v_pin.norm() + r.v_face.norm()) + 1e-15L * carried(),
                 "velocity in the slot");
    const Balance whole = balance(rho1_, rho2_);
    expect_small(whole.rest,
                 share() * whole.terms + 1e-12L * (r.a_pin.norm() + r.a_face.norm()) +
                     1e-15L * carried_acceleration() + owed_to_radii(balance),
                 "acceleration in the slot");
  }

  struct SlotRates {
    Vec v_pin, v_face, a_pin, a_face;
    Real omega = 0;  // of the face
  };

  [[nodiscard]] SlotRates slot_rates(const Vec& c) const {
    const bool second = flat2();
    const Standing& face = second ? two_ : one_;
    const Standing& pin = second ? one_ : two_;
    const Real face_rate = second ? at_.dq : 1;
    const Real pin_rate = second ? 1 : at_.dq;
    const Real face_second = second ? at_.d2q : 0;
    const Real pin_second = second ? 0 : at_.d2q;
    return {pin_rate * pin.velocity(c), face_rate * face.velocity(c),
            pin_second * pin.velocity(c) + pin_rate * pin_rate * pin.acceleration(c),
            face_second * face.velocity(c) + face_rate * face_rate * face.acceleration(c),
            face.omega() * face_rate};
  }

  // \param radius  distance from the centre to the contact point, along n
  [[nodiscard]] Balance acceleration_in_slot(Real radius) const {
    const SlotRates r = slot_rates(Vec(p_ - radius * n_));
    const Real coriolis = 2 * r.omega * n_.dot(perp(Vec(r.v_pin - r.v_face)));
    return {n_.dot(r.a_pin - r.a_face) - coriolis,
            std::abs(n_.dot(r.a_pin)) + std::abs(n_.dot(r.a_face)) + std::abs(coriolis)};
  }

  ContactPosition at_;
  Standing one_;
  Standing two_;
  Vec n_;
  Vec p_;
  double length_;
  Real rho1_ = 0;
  Real rho2_ = 0;
  Real doubt1_ = 0;
  Real doubt2_ = 0;

public:
  Real conforming_ = 1;  ///< (κ1 + κ2)/(|κ1| + |κ2|): > 0 where the bodies do not cut each other at p
};

/// Largest depth [m] by which a sampled boundary point of either body lies within the other; <= 0 for
/// disjoint bodies.
inline double deepest_overlap(const ContactPair& pair, const ContactPosition& at, double size) {
  const Standing one(pair.curve1, pair.motion1, at.u);
  const Standing two(pair.curve2, pair.motion2, at.q);
  Real depth = -1;
  const auto sample = [&](const Standing& a, const Standing& b) {
    constexpr int kSamples = 600;
    for (int i = 1; i < kSamples; ++i) {
      const Real slope = std::tan(Real(kPi) * (Real(i) / kSamples - Real(0.5)));
      Vec l(0, 0);
      if (a.curve.kind == CurveKind::kLine) {
        l = Vec(0, slope * Real(size));
      } else if (a.curve.kind != CurveKind::kPoint) {
        // The second intersection of the curve with a line of this slope through the vertex.
        const Real x = 2 * Real(a.curve.semi_latus) / (slope * slope + Real(a.curve.q));
        if (!(x > 0)) continue;
        l = Vec(x, slope * x);
      }
      const Vec p = a.vertex() + l.x() * a.axis() + l.y() * perp(a.axis());
      const auto shape = b.shape_at(p);
      if (b.curve.kind == CurveKind::kPoint) continue;
      const bool convex_side = (shape.distance * Real(b.side()) < 0) && shape.on_branch;
      const bool inside = b.curve.side == Side::kInside ? convex_side : !convex_side;
      if (inside) depth = std::max(depth, shape.on_branch ? -shape.distance : Real(0));
    }
  };
  sample(one, two);
  sample(two, one);
  return double(depth);
}

}  // namespace higherpair::testing
