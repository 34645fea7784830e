#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/geometry/support.hpp"
#include "osculating_pass.hpp"

#include <cmath>

namespace higherpair {

/// Both curves as they stand, in ground.
struct PlacedPair {
  PlacedCurve<double> first;
  PlacedCurve<double> second;
};

/// \param R_WB  rotation of the body at the coordinate q
[[nodiscard]] inline PlacedCurve<double> place_on(const Curve& curve, const OneFreedom& freedom, double q,
                                                  const Rotation<double>& R_WB) {
  const Vector2d from_joint_W = R_WB * Vector2d(curve.vertex_B - freedom.p_BO);
  const Vector2d p_WJ = freedom.turns ? freedom.p_WO : Vector2d(freedom.p_WO + q * freedom.direction_W);
  return {p_WJ + from_joint_W, R_WB * curve.axis_B, curve.semi_latus, curve.q,
          curve.side == Side::kInside ? 1.0 : -1.0};
}

[[nodiscard]] inline PlacedCurve<double> place_on(const Curve& curve, const OneFreedom& freedom, double q) {
  return place_on(curve, freedom, q, freedom.turns ? Rotation<double>::from_angle(q) : freedom.R_WB);
}

[[nodiscard]] inline PlacedPair place_pair(const ContactPair& pair, double u, double q) {
  return {place_on(pair.curve1, pair.motion1, u), place_on(pair.curve2, pair.motion2, q)};
}

/// solve_contact() from bodies that have been placed at u and at the guess q.
[[nodiscard]] ContactResult solve_contact(const ContactPair& pair, const PlacedPair& guess, double u,
                                          double q, const Vector2d& n_W, int branch);

/// The points of the curves with outward normals n and -n; `exist` is false where a curve has no such point.
/// Where a body is a line, n is that of the face and its point the foot of the other body's point.
struct ContactPoints {
  PassGeometry<double> pass;
  SupportPoint<double> first{};  ///< rho = 0 for a line
  SupportPoint<double> second{};
  bool exist = false;
};

/// Change of a curve's radius of curvature with the angle of its normal, ±n: 3 ρ (1 - q) N_x N_y / w².
[[nodiscard]] inline double radius_slope(const PlacedCurve<double>& curve, double rho, const Vector2d& n) {
  if (curve.q == 1) {
    return 0;
  }
  const double N_x = n.dot(curve.axis_W);
  const double N_y = cross(curve.axis_W, n);
  return 3 * rho * (1 - curve.q) * N_x * N_y / (N_x * N_x + curve.q * N_y * N_y);
}

/// The foot of p on a line through `at` with unit normal n.
[[nodiscard]] inline Vector2d foot_on(const Vector2d& at, const Vector2d& n, const Vector2d& p) {
  return p - (p - at).dot(n) * n;
}

[[nodiscard, gnu::always_inline]] inline ContactPoints points_at(const ContactPair& pair,
                                                                 const PlacedPair& placed,
                                                                 const Vector2d& n) {
  ContactPoints points;
  PassGeometry<double>& pass = points.pass;
  const bool line1 = is_line(pair.curve1);
  const bool line2 = is_line(pair.curve2);
  pass.n = line2 ? placed.second.axis_W : line1 ? Vector2d(-placed.first.axis_W) : n;
  pass.t = perp(pass.n);
  const Vector2d inward = -pass.n;
  points.exist = true;
  if (!line1) {
    points.exist = has_point(placed.first, pass.n);
    points.first = support_point(placed.first, pass.n);
    pass.p1 = points.first.p_W;
  }
  if (!line2) {
    points.exist = points.exist && has_point(placed.second, inward);
    points.second = support_point(placed.second, inward);
    pass.p2 = points.second.p_W;
  }
  if (line1) {
    pass.p1 = foot_on(placed.first.vertex_W, pass.n, pass.p2);
    pass.weights = {0, 1, 0, points.second.rho};
  } else if (line2) {
    pass.p2 = foot_on(placed.second.vertex_W, pass.n, pass.p1);
    pass.weights = {1, 0, 0, points.first.rho};
  } else {
    points.exist = points.exist && points.first.rho + points.second.rho != 0;
    pass.weights = weights_of_curved(points.first.rho, points.second.rho);
  }
  const Vector2d distance = pass.p2 - pass.p1;
  pass.g = distance.dot(pass.n);
  pass.s = distance.dot(pass.t);
  return points;
}

}  // namespace higherpair
