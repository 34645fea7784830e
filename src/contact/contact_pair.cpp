#include "higherpair/contact/contact_pair.hpp"

#include "contact_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr int kMaxPasses = 12;
constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr double kLastTurn = 1e-8;  // [rad] a last step may be: what it leaves out is of third order in it
constexpr double kLeftOut = kEps / 10;  // angle that the last step may leave out [rad]

double manhattan(const Vector2d& v) {
  return std::abs(v.x()) + std::abs(v.y());
}

// The lengths that have gone into the two points: their rounding is that of these.
double extent(const ContactPair& pair, const PlacedPair& placed, const PassGeometry<double>& pass) {
  const Vector2d& p = pass.p1;
  return manhattan(p) + manhattan(p - pair.motion1.p_WO) + manhattan(p - pair.motion2.p_WO) +
         manhattan(p - placed.first.vertex_W) + manhattan(p - placed.second.vertex_W);
}

// Near its asymptote the place on a hyperbola (to the rounding of `extent`) can say more about its curvature
// than the normal does: ρ = ℓ (1 + (1 - q) y²/ℓ²)^{3/2}.
double radius_at(const PlacedCurve<double>& curve, double rho, double w2, const Vector2d& p_W,
                 double extent) {
  if (curve.q >= 0) {
    return rho;
  }
  const double y = cross(curve.axis_W, Vector2d(p_W - curve.vertex_W));
  if (std::abs(y) * std::sqrt(-curve.q) <= extent * w2) {
    return rho;
  }
  const double slope = y / curve.semi_latus;
  const double ratio2 = 1 + (1 - curve.q) * slope * slope;
  return curve.side * curve.semi_latus * ratio2 * std::sqrt(ratio2);
}

void turn_about(PlacedCurve<double>& curve, const Vector2d& pivot_W, const Rotation<double>& turn) {
  curve.vertex_W = pivot_W + turn * Vector2d(curve.vertex_W - pivot_W);
  curve.axis_W = turn * curve.axis_W;
}

// 2 atan(x); the series is exact to rounding for small x.
double twice_arc_tangent(double x) {
  const double x2 = x * x;
  return x2 < 1e-5 ? 2 * x * (1 - x2 * (1 / 3.0 - x2 * (1 / 5.0 - x2 / 7.0))) : 2 * std::atan(x);
}

// The last step, to second order in g = g_φ = 0, each quantity without terms that cancel for huge radii: the
// follower by δ, the normal by φ in ground and by ψ in body 2. With a = t·v2, P = a + ρ2, M = a - ρ1 (for a
// sliding follower P = M = a)
//     φ = w (s + δ P),   ψ = w (s + δ M),
//     0 = (g + w s²/2) + (g_q + s [w (P + M) + 1]/2) δ + w P M δ²/2      (sliding: 0 in place of 1).
struct LastStep {
  double delta = 0;
  double phi = 0;
  double psi = 0;
  double slope1 = 0;  // dρ/dφ
  double slope2 = 0;
  bool sound = false;  // it is small enough for second order
  bool exact = false;  // and what it leaves out is rounding
};

LastStep last_step(const ContactPair& pair, const PlacedPair& placed, const ContactPoints& points,
                   double extent) {
  const PassGeometry<double>& pass = points.pass;
  const double w = pass.weights.w;
  const double turns2 = pair.motion2.turns ? 1 : 0;
  const bool face1 = is_line(pair.curve1);
  const bool face2 = is_line(pair.curve2);
  const Vector2d v2 = velocity_per_q(pair.motion2, pass.p2);
  const double g_q = v2.dot(pass.n);
  const double along = v2.dot(pass.t);
  const double P = along + turns2 * points.second.rho;
  const double M = along - turns2 * points.first.rho;
  const double g_qq = face2 ? turns2 * (M + pass.g) : face1 ? -turns2 * P : w * P * M;  // φ eliminated
  LastStep step;
  const double slope = g_q + (w * (P + M) + turns2) * pass.s / 2;
  const double per_slope = 1 / slope;
  double delta = -(pass.g + w * pass.s * pass.s / 2) * per_slope;
  delta -= g_qq * delta * delta * per_slope / 2;
  step.delta = delta;
  step.phi = face2 ? turns2 * delta : w * (pass.s + delta * P);
  step.psi = face1 ? -turns2 * delta : w * (pass.s + delta * M);
  if (!face1) step.slope1 = radius_slope(placed.first, points.first.rho, pass.n);
  if (!face2) step.slope2 = radius_slope(placed.second, points.second.rho, pass.n);
  const double turn = std::max(std::abs(step.phi), std::abs(step.psi));
  const double slopes = std::abs(step.slope1) + std::abs(step.slope2);
  const double arm = w == 0 ? extent : std::min(extent, 1 / std::abs(w));
  step.sound = turn <= kLastTurn && std::abs(g_qq * delta) <= kLastTurn * std::abs(slope);
  step.exact = step.sound && slopes * turn * turn <= kLeftOut * arm;
  return step;
}

// Moves normal, points and radii by the last step. Points are moved along the osculating circles:
// c1 stays, c2 moves with body 2.
void apply(const ContactPair& pair, const PlacedPair& placed, const LastStep& step, double extent,
           ContactPoints& points) {
  PassGeometry<double>& pass = points.pass;
  const double turns2 = pair.motion2.turns ? 1 : 0;
  const auto [delta, phi, psi, slope1, slope2, sound, exact] = step;
  const Vector2d n = pass.n;
  const Vector2d t = pass.t;
  const double rho2 = points.second.rho;
  pass.n = n + phi * t - phi * phi / 2 * n;
  pass.t = perp(pass.n);
  pass.p1 += points.first.rho * (phi * t - phi * phi / 2 * n);
  const Vector2d along2 = rho2 * psi * ((phi + turns2 * delta) / 2 * n - t);
  const Vector2d on_body2 = pass.p2 + along2;
  pass.p2 += delta * velocity_per_q(pair.motion2, pass.p2) +
             delta * delta / 2 * acceleration_per_q(pair.motion2, pass.p2) + along2;
  if (is_line(pair.curve2)) {
    pass.p2 = foot_on(pass.p2, pass.n, pass.p1);
  }
  if (is_line(pair.curve1)) {
    pass.p1 = foot_on(pass.p1, pass.n, pass.p2);
  }
  points.first.rho += slope1 * phi;
  points.second.rho += slope2 * psi;
  if (pass.weights.w != 0) {
    points.first.rho = radius_at(placed.first, points.first.rho, points.first.w2, pass.p1, extent);
    points.second.rho = radius_at(placed.second, points.second.rho, points.second.w2, on_body2, extent);
    pass.weights = weights_of_curved(points.first.rho, points.second.rho);
  } else {
    pass.weights.z = points.first.rho + points.second.rho;
  }
}

// Velocities and accelerations for du/dt = 1: the equivalent link written without radii, so that flat faces
// and points need no cases. With ω_r = ω2 - ω1 and the speeds u1, u2 of the contact along each curve,
//     n·(v2 - v1) = 0,   n·(a2 - a1) = ω2 u2 - ω1 u1 - v_s φ̇,   φ̇ = ω1 + w1 ω_r + w v_s.
void add_rates(const ContactPair& pair, const ContactPoints& points, ContactPosition& at) {
  const PassGeometry<double>& pass = points.pass;
  const auto& [w1, w2, w, z] = pass.weights;
  const Vector2d p = (pass.p1 + pass.p2) / 2;
  const Vector2d v1 = velocity_per_q(pair.motion1, p);
  const Vector2d per_q = velocity_per_q(pair.motion2, p);
  at.gap_q = per_q.dot(pass.n);
  if (at.gap_q == 0) {
    return;
  }
  const double per_gap_q = 1 / at.gap_q;
  at.dq = v1.dot(pass.n) * per_gap_q;
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
  at.d2q = (normal + (a1 - a2_centripetal).dot(pass.n)) * per_gap_q;
}

ContactPosition position_of(const ContactPair& pair, const ContactPoints& points, double u, double q) {
  ContactPosition at;
  at.u = u;
  at.q = q;
  at.n_W = points.pass.n;
  at.p1_W = points.pass.p1;
  at.p2_W = points.pass.p2;
  at.rho1 = points.first.rho;
  at.rho2 = points.second.rho;
  add_rates(pair, points, at);
  return at;
}

}  // namespace

ContactResult solve_contact(const ContactPair& pair, double u, double q, const Vector2d& n_W, int branch) {
  ContactResult result;
  PlacedPair placed = place_pair(pair, u, q);
  ContactPoints points = points_at(pair, placed, n_W);
  const Vector2d n_guess = points.pass.n;
  for (int pass = 0; pass <= kMaxPasses; ++pass) {
    if (!points.exist) {
      result.status = ContactStatus::kNoContact;
      return result;
    }
    const double size = extent(pair, placed, points.pass);
    const LastStep last = last_step(pair, placed, points, size);
    const double radii = std::abs(points.first.rho) + std::abs(points.second.rho);
    const bool closed =
        std::abs(points.pass.g) <= 2 * kEps * size && std::abs(points.pass.s) <= 2 * kEps * (size + radii);
    if (last.exact || closed) {
      const LastStep applied = last.sound ? last : LastStep{};
      apply(pair, placed, applied, size, points);
      q += applied.delta;
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
      q += twice_arc_tangent(step.tan_half);
    } else {
      q += step.slide;
      placed.second = place_on(pair.curve2, pair.motion2, q);
    }
    points = points_at(pair, placed, step.n.normalized());
  }
  result.status = ContactStatus::kNotConverged;
  return result;
}

}  // namespace higherpair
