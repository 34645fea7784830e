#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/geometry/support.hpp"

namespace higherpair {

/// Both curves in ground, placed at the positions of their bodies.
struct PlacedPair {
  PlacedCurve<double> first;
  PlacedCurve<double> second;
};

/// \param R_WB  rotation of the body at the coordinate q
[[nodiscard]] inline PlacedCurve<double> place_on(const Curve& curve, const OneFreedom& freedom, double q,
                                                  const Rotation<double>& R_WB) {
  const Vector2d from_joint_W = R_WB * Vector2d(curve.vertex_B - freedom.p_BO);
  const Vector2d p_WJ = freedom.turns ? freedom.p_WO : Vector2d(freedom.p_WO + q * freedom.direction_W);
  return place(curve, Vector2d(p_WJ + from_joint_W), R_WB);
}

[[nodiscard]] inline PlacedCurve<double> place_on(const Curve& curve, const OneFreedom& freedom, double q) {
  return place_on(curve, freedom, q, freedom.turns ? Rotation<double>::from_angle(q) : freedom.R_WB);
}

[[nodiscard]] inline PlacedPair place_pair(const ContactPair& pair, double u, double q) {
  return {place_on(pair.curve1, pair.motion1, u), place_on(pair.curve2, pair.motion2, q)};
}

/// solve_contact() with the bodies already placed at u and at the guess q.
[[nodiscard]] ContactResult solve_contact(const ContactPair& pair, const PlacedPair& guess, double u,
                                          double q, const Vector2d& n_W, int branch);

/// The points with outward normals n and -n, and what the osculating iteration derives from them. Where a
/// body is a line, n is the normal of its face, its point is the foot of the perpendicular from the other
/// body's point, and its radius is 0. The link is not finite where ρ1 + ρ2 = 0.
struct ContactPoints : CommonNormal {
  Vector2d t_W = Vector2d::UnitY();
  EquivalentLink link;
  double g = 0, s = 0;        ///< (p2 - p1)·n and (p2 - p1)·t [m]
  double w2_1 = 0, w2_2 = 0;  ///< SupportPoint::w2
  bool exist = false;         ///< false where a curve has no point with its normal
};

[[nodiscard, gnu::always_inline]] inline ContactPoints points_at(bool line1, bool line2,
                                                                 const PlacedPair& placed,
                                                                 const Vector2d& n_W) {
  ContactPoints at;
  at.n_W = line2 ? placed.second.axis_W : line1 ? face_normal(placed.first) : n_W;
  at.t_W = perp(at.n_W);
  const Vector2d inward = -at.n_W;
  at.exist = true;
  if (!line1) {
    at.exist = has_point(placed.first, at.n_W);
    const SupportPoint<double> point = support_point(placed.first, at.n_W);
    at.p1_W = point.p_W;
    at.rho1 = point.rho;
    at.w2_1 = point.w2;
  }
  if (!line2) {
    at.exist = at.exist && has_point(placed.second, inward);
    const SupportPoint<double> point = support_point(placed.second, inward);
    at.p2_W = point.p_W;
    at.rho2 = point.rho;
    at.w2_2 = point.w2;
  }
  if (line1) {
    at.p1_W = foot_on(placed.first.vertex_W, at.n_W, at.p2_W);
  } else if (line2) {
    at.p2_W = foot_on(placed.second.vertex_W, at.n_W, at.p1_W);
  }
  at.link = equivalent_link(line1, at.rho1, line2, at.rho2);
  const Vector2d distance = at.p2_W - at.p1_W;
  at.g = distance.dot(at.n_W);
  at.s = distance.dot(at.t_W);
  return at;
}

[[nodiscard, gnu::always_inline]] inline ContactPoints points_at(const ContactPair& pair,
                                                                 const PlacedPair& placed,
                                                                 const Vector2d& n_W) {
  return points_at(is_line(pair.curve1), is_line(pair.curve2), placed, n_W);
}

}  // namespace higherpair
