#pragma once

#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/curve.hpp"
#include "higherpair/geometry/pose.hpp"

#include <array>
#include <optional>

namespace higherpair {

/// Where two curves face each other: their points with a common normal, in ground W; t = n turned +90°. Where
/// p2 = p1 this is their contact point, whatever search found it.
struct CommonNormal {
  Vector2d n_W = Vector2d::UnitX();  ///< unit outward normal of curve 1 at p1; curve 2 has -n at p2
  Vector2d p1_W = Vector2d::Zero();
  Vector2d p2_W = Vector2d::Zero();
  double rho1 = 0;  ///< signed radii of curvature [m]: > 0 convex; 0 for a point; meaningless for a line
  double rho2 = 0;

  /// (p2 - p1)·n [m]: > 0 apart, 0 touching, < 0 overlapping
  [[nodiscard]] double gap() const { return (p2_W - p1_W).dot(n_W); }
  /// The point of contact [m]. Where a curve is nearly flat, as far out on a hyperbola, its point has few
  /// digits: an error δ of the normal moves p1 by ρ1 δ along the tangent and p2 by -ρ2 δ. In the mean with
  /// the weights ρ2 and ρ1 that cancels. Midway where the weights are large, or not defined.
  [[nodiscard]] Vector2d p_W() const {
    const double share2 = rho1 / (rho1 + rho2);
    return std::abs(share2 - 0.5) <= 1.5 ? Vector2d(p1_W + share2 * (p2_W - p1_W)) : (p1_W + p2_W) / 2;
  }
  /// The same with the two curves exchanged.
  [[nodiscard]] CommonNormal exchanged() const { return {-n_W, p2_W, p1_W, rho2, rho1}; }
};

/// A position of a pair in which its two curves are tangent; vectors in ground W.
struct TangentPosition {
  double u = 0;                     ///< driver's coordinate [rad or m]
  double q = 0;                     ///< follower's coordinate [rad or m]
  Vector2d p_W = Vector2d::Zero();  ///< the common point [m]
  /// Unit outward normal of body 1; if its curve is a point, opposite to body 2's.
  Vector2d n_W = Vector2d::UnitX();
};

/// The common normal near a guess: the root of (p2 - p1)·t = 0, t = n turned +90°, by Newton's method with
/// d/dφ [(p2 - p1)·t] = -(ρ1 + ρ2) - gap. A line prescribes n. None where the iteration finds no such normal
/// or leaves the normals that a curve has.
/// \param n_W guess of the outward normal of curve 1
[[nodiscard]] std::optional<CommonNormal> find_common_normal(const Curve& curve1, const Pose<double>& X_W1,
                                                             const Curve& curve2, const Pose<double>& X_W2,
                                                             const Vector2d& n_W);

/// Whether two contacts of the same curves may lie on one smooth branch, by their sums ρ1 + ρ2. Of two
/// contacts with neighbouring normals one is a least and one a greatest gap; the sum changes sign only at a
/// conforming contact, where they merge. Lines have no neighbouring normals.
[[nodiscard]] inline bool same_curvature(const Curve& curve1, const Curve& curve2, double sum_a,
                                         double sum_b) {
  return is_line(curve1) || is_line(curve2) || (sum_a > 0) == (sum_b > 0);
}

/// The equivalent link between the centres of curvature, written without radii so that it stays finite for
/// lines and points (docs/method.md derives it): with κ = 1/ρ and K = κ1 + κ2
///     w1 = κ1/K,   w2 = κ2/K,   w = κ1 κ2/K,   z = 1/K.
struct EquivalentLink {
  double w1 = 0, w2 = 0;  ///< [1]
  double w = 0;           ///< [1/m]
  double z = 0;           ///< [m]
};

/// For two curves neither of which is a line.
[[nodiscard]] inline EquivalentLink link_of_curved(double rho1, double rho2) {
  const double w = 1 / (rho1 + rho2);
  return {rho2 * w, rho1 * w, w, rho1 * rho2 * w};
}

/// For any two curves of which at most one is a line, whose κ is 0.
[[nodiscard]] inline EquivalentLink equivalent_link(bool line1, double rho1, bool line2, double rho2) {
  if (line2) {
    return {1, 0, 0, rho1};
  }
  return line1 ? EquivalentLink{0, 1, 0, rho2} : link_of_curved(rho1, rho2);
}

/// Rates of a contact of two moving bodies.
struct ContactRates {
  double sliding = 0;              ///< v_s = t·(v2 - v1) of the material points at the contact [m/s]
  double phi_dot = 0;              ///< rate of the normal's angle [rad/s]
  double along1 = 0, along2 = 0;   ///< speed of the contact point along each curve, u1 and u2, along t [m/s]
  double normal_acceleration = 0;  ///< n·(a2 - a1) of the material points that maintains the contact [m/s²]
};

/// With ω_r = ω2 - ω1:  u1 = z ω_r + w2 v_s,  u2 = z ω_r - w1 v_s,  φ̇ = ω1 + w1 ω_r + w v_s,
///     n·(a2 - a1) = ω2 u2 - ω1 u1 - v_s φ̇.
/// \pre n·(v2 - v1) = 0
[[nodiscard]] inline ContactRates contact_rates(const EquivalentLink& link, double sliding, double omega1,
                                                double omega2) {
  const double omega_r = omega2 - omega1;
  ContactRates rates;
  rates.sliding = sliding;
  rates.along1 = link.z * omega_r + link.w2 * sliding;
  rates.along2 = link.z * omega_r - link.w1 * sliding;
  rates.phi_dot = omega1 + link.w1 * omega_r + link.w * sliding;
  rates.normal_acceleration = omega2 * rates.along2 - omega1 * rates.along1 - sliding * rates.phi_dot;
  return rates;
}

/// The same from the motions of the bodies.
[[nodiscard]] ContactRates contact_rates(const EquivalentLink& link, const CommonNormal& at,
                                         const BodyMotion& body1, const BodyMotion& body2);

/// The state of a contact, seen from its first body: 1 and 2 are the first and second body in the file.
struct ContactMotion {
  CommonNormal at;
  /// False while a contact that may separate is open: the other members are then meaningless.
  bool touches = true;
  double phi = 0;                      ///< angle of at.n_W, continuous [rad]
  std::array<BoundaryPlace, 2> place;  ///< on both boundaries, for a contact by_boundary
  ContactRates rates;                  ///< of the current velocities
  double arc_difference = 0;  ///< rolling: arc of the first less arc of the second curve, constant [m]
};

}  // namespace higherpair
