#pragma once

#include "contact_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// The end of the osculating iteration: one step to second order that is exact to rounding, so that no further
// pass has to confirm it.

namespace higherpair {

inline constexpr double kEps = std::numeric_limits<double>::epsilon();
inline constexpr double kLastTurn =
    1e-8;  // [rad] a last step may be: what it leaves out is of third order in it
inline constexpr double kLeftOut = kEps / 10;  // angle that the last step may leave out [rad]

[[nodiscard]] inline double manhattan(const Vector2d& v) {
  return std::abs(v.x()) + std::abs(v.y());
}

// The lengths that have gone into the two points: their rounding is that of these.
[[nodiscard]] inline double extent(const ContactPair& pair, const PlacedPair& placed,
                                   const PassGeometry<double>& pass) {
  const Vector2d& p = pass.p1;
  return manhattan(p) + manhattan(p - pair.motion1.p_WO) + manhattan(p - pair.motion2.p_WO) +
         manhattan(p - placed.first.vertex_W) + manhattan(p - placed.second.vertex_W);
}

// Near its asymptote the place on a hyperbola (to the rounding of `extent`) can say more about its curvature
// than the normal does: ρ = ℓ (1 + (1 - q) y²/ℓ²)^{3/2}.
[[nodiscard]] inline double radius_at(const PlacedCurve<double>& curve, double rho, double w2,
                                      const Vector2d& p_W, double extent) {
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

[[nodiscard]] inline LastStep last_step(const ContactPair& pair, const PlacedPair& placed,
                                        const ContactPoints& points, double extent) {
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
  const double first = -(pass.g + w * pass.s * pass.s / 2) * per_slope;
  const double delta = first - (g_qq * per_slope / 2) * (first * first);
  step.delta = delta;
  step.phi = face2 ? turns2 * delta : w * (pass.s + delta * P);
  step.psi = face1 ? -turns2 * delta : w * (pass.s + delta * M);
  if (!face1) step.slope1 = radius_slope(placed.first, points.first.rho, pass.n);
  if (!face2) step.slope2 = radius_slope(placed.second, points.second.rho, pass.n);
  const double turn = std::max(std::abs(step.phi), std::abs(step.psi));
  const double slopes = std::abs(step.slope1) + std::abs(step.slope2);
  // Of the first order's step: the second order may undo a large one.
  step.sound = turn <= kLastTurn && std::abs(g_qq * first) <= kLastTurn * std::abs(slope);
  // From far away the follower would bring the rounding of that place along.
  const bool short_way = 8 * std::abs(delta) * manhattan(v2) <= extent;
  const double left_out = slopes * turn * turn;  // against the arm 1/w or the extent, the shorter
  step.exact = step.sound && short_way && left_out <= kLeftOut * extent && left_out * std::abs(w) <= kLeftOut;
  return step;
}

// The same with the follower at rest: the two points come together along their curves, φ = ψ = w s. For
// points that are closed already where δ would be noise: far out on two branches the normal fixes the points
// only to a rounding of it times their radii, which may be much more than the rounding of the gap.
[[nodiscard]] inline LastStep closing_step(const ContactPoints& points, const LastStep& last) {
  const double turn = points.pass.weights.w * points.pass.s;
  if (!(std::abs(turn) <= kLastTurn)) {
    return {};
  }
  LastStep step = last;
  step.delta = 0;
  step.phi = turn;
  step.psi = turn;
  return step;
}

// Moves normal, points and radii by the last step. Points are moved along the osculating circles:
// c1 stays, c2 moves with body 2.
[[nodiscard, gnu::always_inline]] inline ContactPoints moved(const ContactPair& pair,
                                                             const PlacedPair& placed, const LastStep& step,
                                                             double extent, ContactPoints points) {
  PassGeometry<double>& pass = points.pass;
  const double turns2 = pair.motion2.turns ? 1 : 0;
  const auto [delta, phi, psi, slope1, slope2, sound, exact] = step;
  const Vector2d n = pass.n;
  const Vector2d t = pass.t;
  const double rho2 = points.second.rho;
  pass.n = n + phi * t - phi * phi / 2 * n;
  pass.n *= 1.5 - pass.n.squaredNorm() / 2;  // a unit vector also after a million steps
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
  return points;
}

}  // namespace higherpair
