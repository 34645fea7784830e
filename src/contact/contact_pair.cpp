#include "higherpair/contact/contact_pair.hpp"

#include "osculating_pass.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr int kMaxPasses = 8;
constexpr double kEps = std::numeric_limits<double>::epsilon();

bool is_line(const Curve& curve) {
  return curve.kind == CurveKind::kLine;
}

// Both bodies as they stand in a pass.
struct Placed {
  PlacedCurve<double> first;
  PlacedCurve<double> second;
};

// The foot of p on a line.
Vector2d foot_on(const PlacedCurve<double>& line, const Vector2d& p) {
  return p - (p - line.vertex_W).dot(line.axis_W) * line.axis_W;
}

struct Points {
  PassGeometry<double> pass;
  double rho1 = 0;
  double rho2 = 0;
  bool exist = false;
};

Points points_at(const ContactPair& pair, const Placed& placed, const Vector2d& n) {
  Points points;
  PassGeometry<double>& pass = points.pass;
  pass.n = n;
  if (is_line(pair.curve2)) {
    pass.n = placed.second.axis_W;
    const SupportPoint<double> s1 = support_point(placed.first, pass.n);
    points.exist = has_point(placed.first, pass.n);
    pass.p1 = s1.p_W;
    pass.p2 = foot_on(placed.second, s1.p_W);
    points.rho1 = s1.rho;
    pass.weights = {1, 0, 0, s1.rho};
  } else if (is_line(pair.curve1)) {
    pass.n = -placed.first.axis_W;
    const Vector2d inward = -pass.n;
    const SupportPoint<double> s2 = support_point(placed.second, inward);
    points.exist = has_point(placed.second, inward);
    pass.p2 = s2.p_W;
    pass.p1 = foot_on(placed.first, s2.p_W);
    points.rho2 = s2.rho;
    pass.weights = {0, 1, 0, s2.rho};
  } else {
    const Vector2d inward = -n;
    const SupportPoint<double> s1 = support_point(placed.first, n);
    const SupportPoint<double> s2 = support_point(placed.second, inward);
    points.exist = has_point(placed.first, n) && has_point(placed.second, inward) && s1.rho + s2.rho != 0;
    pass.p1 = s1.p_W;
    pass.p2 = s2.p_W;
    points.rho1 = s1.rho;
    points.rho2 = s2.rho;
    pass.weights = weights_of_curved(s1.rho, s2.rho);
  }
  pass.t = perp(pass.n);
  pass.g = (pass.p2 - pass.p1).dot(pass.n);
  pass.s = (pass.p2 - pass.p1).dot(pass.t);
  return points;
}

// What rounding leaves of p2 - p1.
double closure_noise(const ContactPair& pair, const Points& points) {
  const Vector2d& p = points.pass.p1;
  return 4 * kEps *
         (p.norm() + (p - pair.motion2.p_WO).norm() + (p - pair.motion1.p_WO).norm() + std::abs(points.rho1) +
          std::abs(points.rho2));
}

void turn_about(PlacedCurve<double>& curve, const Vector2d& pivot_W, const Rotation<double>& turn) {
  curve.vertex_W = pivot_W + turn * Vector2d(curve.vertex_W - pivot_W);
  curve.axis_W = turn * curve.axis_W;
}

// Velocities and accelerations for du/dt = 1: the equivalent link written without radii, so that flat faces
// and points need no cases. With ω_r = ω2 - ω1 and the speeds u1, u2 of the contact along each curve,
//     n·(v2 - v1) = 0,   n·(a2 - a1) = ω2 u2 - ω1 u1 - v_s φ̇,   φ̇ = ω1 + w1 ω_r + w v_s.
void add_rates(const ContactPair& pair, const Points& points, ContactPosition& at) {
  const PassGeometry<double>& pass = points.pass;
  const auto& [w1, w2, w, z] = pass.weights;
  const Vector2d p = (pass.p1 + pass.p2) / 2;
  const Vector2d v1 = velocity_per_q(pair.motion1, p);
  const Vector2d per_q = velocity_per_q(pair.motion2, p);
  at.gap_q = per_q.dot(pass.n);
  if (at.gap_q == 0) {
    return;
  }
  at.dq = v1.dot(pass.n) / at.gap_q;
  const double omega1 = pair.motion1.turns ? 1 : 0;
  const double omega2 = pair.motion2.turns ? at.dq : 0;
  const double omega_r = omega2 - omega1;
  at.sliding = (at.dq * per_q - v1).dot(pass.t);
  const double u1 = z * omega_r + w2 * at.sliding;
  const double u2 = z * omega_r - w1 * at.sliding;
  at.dphi = omega1 + w1 * omega_r + w * at.sliding;
  const Vector2d a1 = acceleration_per_q(pair.motion1, p);
  const Vector2d a2_centripetal = at.dq * at.dq * acceleration_per_q(pair.motion2, p);
  const double normal = omega2 * u2 - omega1 * u1 - at.sliding * at.dphi;
  at.d2q = (normal + (a1 - a2_centripetal).dot(pass.n)) / at.gap_q;
}

ContactPosition position_of(const ContactPair& pair, const Points& points, double u, double q) {
  ContactPosition at;
  at.u = u;
  at.q = q;
  at.n_W = points.pass.n;
  at.p1_W = points.pass.p1;
  at.p2_W = points.pass.p2;
  at.rho1 = points.rho1;
  at.rho2 = points.rho2;
  add_rates(pair, points, at);
  return at;
}

}  // namespace

ContactResult solve_contact(const ContactPair& pair, double u, double q, const Vector2d& n_W, int branch) {
  ContactResult result;
  Placed placed = {place(pair.curve1, pose_at(pair.motion1, u)),
                   place(pair.curve2, pose_at(pair.motion2, q))};
  Points points = points_at(pair, placed, n_W);
  const Vector2d n_guess = points.pass.n;
  for (int pass = 0; pass <= kMaxPasses; ++pass) {
    if (!points.exist) {
      result.status = ContactStatus::kNoContact;
      return result;
    }
    const double distance = std::max(std::abs(points.pass.g), std::abs(points.pass.s));
    if (distance <= closure_noise(pair, points)) {
      result.at = position_of(pair, points, u, q);
      result.step_n = (points.pass.n - n_guess).norm();
      const bool wanted = branch * result.at.gap_q >= 0;
      result.status = wanted ? ContactStatus::kOk : ContactStatus::kOtherBranch;
      return result;
    }
    const PassStep<double> step = pair.motion2.turns
                                      ? turning_pass(points.pass, pair.motion2.p_WO, branch)
                                      : sliding_pass(points.pass, pair.motion2.direction_W, branch);
    if (!(step.discriminant >= 0) || !step.n.allFinite() || !(step.n.squaredNorm() > 0)) {
      result.status = ContactStatus::kNoContact;
      return result;
    }
    if (pair.motion2.turns) {
      turn_about(placed.second, pair.motion2.p_WO, step.turn);
      q += 2 * std::atan(step.tan_half);
    } else {
      placed.second.vertex_W += step.slide * pair.motion2.direction_W;
      q += step.slide;
    }
    points = points_at(pair, placed, step.n.normalized());
  }
  result.status = ContactStatus::kNotConverged;
  return result;
}

}  // namespace higherpair
