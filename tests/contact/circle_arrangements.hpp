#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "linkage/four_bar_motion.hpp"
#include "linkage/inverted_slider_crank.hpp"
#include "linkage/scotch_yoke.hpp"
#include "linkage/slider_crank.hpp"

#include <cmath>
#include <optional>

namespace higherpair::testing {

/// A body whose curve is a circle (rho > 0 disc, < 0 ring), a point (rho = 0) or a flat face.
struct RoundOrFlat {
  bool flat = false;
  double rho = 0;
  OneFreedom freedom;
  Vector2d a_B = Vector2d::Zero();   ///< centre, or a point of the face, from the body's point at its joint
  Vector2d m_B = Vector2d::UnitX();  ///< outward normal of the face

  /// Centre (or point of the face) at the coordinate q.
  [[nodiscard]] Vector2d place(double q) const {
    return freedom.turns ? Vector2d(freedom.p_WO + Rotation<double>::from_angle(q) * a_B)
                         : Vector2d(freedom.p_WO + q * freedom.direction_W + freedom.R_WB * a_B);
  }
  [[nodiscard]] Vector2d normal(double q) const {
    return (freedom.turns ? Rotation<double>::from_angle(q) : freedom.R_WB) * m_B;
  }
  [[nodiscard]] Curve curve() const {
    const Vector2d at_B = freedom.p_BO + a_B;
    if (flat) {
      return make_line(at_B, m_B).value();
    }
    if (rho == 0) {
      return make_point(at_B).value();
    }
    return make_circle(at_B, std::abs(rho), rho > 0 ? Side::kInside : Side::kOutside).value();
  }
};

struct Exact {
  double q = 0;
  double dq = 0;
  double d2q = 0;
};

using MaybeExact = std::optional<Exact>;

/// Distance of a turning body's slot from its pivot: that of the face, offset by the other body's radius.
inline double slot_offset(const RoundOrFlat& face, double rho) {
  return face.a_B.dot(face.m_B) + rho;
}

// The slot runs along the face's normal turned by -90°, so that its offset is positive along the normal.
inline double slot_angle(const RoundOrFlat& face) {
  return angle_of(face.m_B) - kPi / 2;
}

inline MaybeExact turn_turn(const RoundOrFlat& one, const RoundOrFlat& two, double u, AssemblyMode mode) {
  const Vector2d ground = two.freedom.p_WO - one.freedom.p_WO;
  if (two.flat) {
    const InvertedSliderCrank linkage{ground.norm(), one.a_B.norm(), slot_offset(two, one.rho),
                                      angle_of(ground)};
    const auto motion = inverted_slider_crank_by_crank(linkage, {u + angle_of(one.a_B), 1, 0}, mode);
    if (!motion.rates) return std::nullopt;
    return Exact{motion.theta3 - slot_angle(two), motion.rates->omega3, motion.rates->alpha3};
  }
  if (one.flat) {
    const InvertedSliderCrank linkage{ground.norm(), two.a_B.norm(), slot_offset(one, two.rho),
                                      angle_of(-ground)};
    const auto motion = inverted_slider_crank_by_slot(linkage, {u + slot_angle(one), 1, 0}, mode);
    if (!motion.rates) return std::nullopt;
    return Exact{motion.theta2 - angle_of(two.a_B), motion.rates->omega2, motion.rates->alpha2};
  }
  const FourBar linkage{ground.norm(), one.a_B.norm(), std::abs(one.rho + two.rho), two.a_B.norm(),
                        angle_of(ground)};
  const auto motion = four_bar_by_crank(linkage, {u + angle_of(one.a_B), 1, 0}, mode);
  if (!motion.rates) return std::nullopt;
  return Exact{motion.theta4 - angle_of(two.a_B), motion.rates->omega4, motion.rates->alpha4};
}

// Rapson slide: (c2 - O1)·m(u) = k fixes the sliding body's coordinate.
inline MaybeExact rapson(const RoundOrFlat& one, const RoundOrFlat& two, double u) {
  const Vector2d m = one.normal(u);
  const Vector2d b = two.place(0) - one.freedom.p_WO;
  const Vector2d d = two.freedom.direction_W;
  const double D = d.dot(m);
  const double D1 = d.dot(perp(m));
  const double N1 = -b.dot(perp(m));
  const double q = (slot_offset(one, two.rho) - b.dot(m)) / D;
  const double dq = (N1 - q * D1) / D;
  return Exact{q, dq, (b.dot(m) - 2 * dq * D1 + q * D) / D};
}

inline MaybeExact turn_slide(const RoundOrFlat& one, const RoundOrFlat& two, double u, AssemblyMode mode) {
  if (one.flat) {
    return rapson(one, two, u);
  }
  const Vector2d d = two.freedom.direction_W;
  const Vector2d from_pivot = two.place(0) - one.freedom.p_WO;
  const AngleMotion crank{u + angle_of(one.a_B), 1, 0};
  if (two.flat) {
    const Vector2d m = two.normal(0);
    const Vector2d slot = -perp(m);
    const Vector2d slot_from_pivot = from_pivot + one.rho * m;
    const ScotchYoke linkage{one.a_B.norm(), {d.dot(slot), cross(d, slot)}, angle_of(d)};
    const auto motion = scotch_yoke_by_crank(linkage, crank);
    if (!motion.rates) return std::nullopt;
    return Exact{motion.r1 - cross(slot_from_pivot, slot) / cross(d, slot), motion.rates->r1_dot,
                 motion.rates->r1_ddot};
  }
  const SliderCrank linkage{one.a_B.norm(), std::abs(one.rho + two.rho), perp(d).dot(from_pivot),
                            angle_of(d)};
  const auto motion = slider_crank_by_crank(linkage, crank, mode);
  if (!motion.rates) return std::nullopt;
  return Exact{motion.r1 - d.dot(from_pivot), motion.rates->r1_dot, motion.rates->r1_ddot};
}

// (c1 - O2)·m(q) = k: the Rapson slide driven by its sliding body.
inline MaybeExact inverse_rapson(const RoundOrFlat& one, const RoundOrFlat& two, double u,
                                 AssemblyMode mode) {
  const Vector2d b = one.place(u) - two.freedom.p_WO;
  const double k = slot_offset(two, one.rho);
  if (std::abs(k) >= b.norm()) return std::nullopt;
  const double q = angle_of(b) - angle_of(two.m_B) + sign(mode) * std::acos(k / b.norm());
  const Vector2d m = two.normal(q);
  const Vector2d d = one.freedom.direction_W;
  const double F_q = b.dot(perp(m));
  const double dq = -d.dot(m) / F_q;
  return Exact{q, dq, -(2 * d.dot(perp(m)) * dq - b.dot(m) * dq * dq) / F_q};
}

inline MaybeExact slide_turn(const RoundOrFlat& one, const RoundOrFlat& two, double u, AssemblyMode mode) {
  if (two.flat) {
    return inverse_rapson(one, two, u, mode);
  }
  const Vector2d d = one.freedom.direction_W;
  const Vector2d from_pivot = one.place(0) - two.freedom.p_WO;
  if (one.flat) {
    const Vector2d m = one.normal(0);
    const Vector2d slot = -perp(m);
    const Vector2d slot_from_pivot = from_pivot + two.rho * m;
    const ScotchYoke linkage{two.a_B.norm(), {d.dot(slot), cross(d, slot)}, angle_of(d)};
    const double r1 = u + cross(slot_from_pivot, slot) / cross(d, slot);
    const auto motion = scotch_yoke_by_yoke(linkage, {r1, 1, 0}, mode);
    if (!motion.rates) return std::nullopt;
    return Exact{motion.theta2 - angle_of(two.a_B), motion.rates->omega2, motion.rates->alpha2};
  }
  const SliderCrank linkage{two.a_B.norm(), std::abs(one.rho + two.rho), perp(d).dot(from_pivot),
                            angle_of(d)};
  const auto motion = slider_crank_by_slider(linkage, {u + d.dot(from_pivot), 1, 0}, mode);
  if (!motion.rates) return std::nullopt;
  return Exact{motion.theta2 - angle_of(two.a_B), motion.rates->omega2, motion.rates->alpha2};
}

// Wedge: linear. Double slider: |c2 - c1| = |ρ1 + ρ2| is a quadratic in q.
inline MaybeExact slide_slide(const RoundOrFlat& one, const RoundOrFlat& two, double u, AssemblyMode mode) {
  const Vector2d d1 = one.freedom.direction_W;
  const Vector2d d2 = two.freedom.direction_W;
  const Vector2d e = two.place(0) - one.place(u);
  if (one.flat || two.flat) {
    const Vector2d n = one.flat ? one.normal(0) : Vector2d(-two.normal(0));
    return Exact{(one.rho + two.rho - e.dot(n)) / d2.dot(n), d1.dot(n) / d2.dot(n), 0};
  }
  const double B = d2.dot(e);
  const double D = (one.rho + two.rho) * (one.rho + two.rho) - cross(d2, e) * cross(d2, e);
  if (D <= 0) return std::nullopt;
  const double root = sign(mode) * std::sqrt(D);
  const Vector2d y = (root - B) * d2 + e;
  const double dq = y.dot(d1) / root;
  return Exact{root - B, dq, -(dq * d2 - d1).squaredNorm() / root};
}

/// The follower by the closed form of the equivalent linkage, which is exact for these shapes.
inline MaybeExact closed_form(const RoundOrFlat& one, const RoundOrFlat& two, double u, AssemblyMode mode) {
  if (one.freedom.turns) {
    return two.freedom.turns ? turn_turn(one, two, u, mode) : turn_slide(one, two, u, mode);
  }
  return two.freedom.turns ? slide_turn(one, two, u, mode) : slide_slide(one, two, u, mode);
}

}  // namespace higherpair::testing
