#pragma once

#include "contact_points.hpp"
#include "higherpair/contact/tolerances.hpp"

#include <algorithm>
#include <cmath>

// The end of the osculating iteration: one second-order step that is exact to within rounding, so that no
// further pass is needed to confirm it.

namespace higherpair {

[[nodiscard]] inline double manhattan(const Vector2d& v) {
  return std::abs(v.x()) + std::abs(v.y());
}

// Sum of the lengths from which the two points are computed: their rounding is proportional to it.
[[nodiscard]] inline double extent(const ContactPair& pair, const PlacedPair& placed,
                                   const ContactPoints& points) {
  const Vector2d& p = points.p1_W;
  return manhattan(p) + manhattan(p - pair.motion1.p_WO) + manhattan(p - pair.motion2.p_WO) +
         manhattan(p - placed.first.vertex_W) + manhattan(p - placed.second.vertex_W);
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
  bool sound = false;  // small enough for second order
  bool exact = false;  // and what it leaves out is below rounding
};

[[nodiscard]] inline LastStep last_step(const ContactPair& pair, const PlacedPair& placed,
                                        const ContactPoints& points, double extent) {
  const double w = points.link.w;
  const double turns2 = pair.motion2.turns ? 1 : 0;
  const bool face1 = is_line(pair.curve1);
  const bool face2 = is_line(pair.curve2);
  const Vector2d v2 = velocity_per_q(pair.motion2, points.p2_W);
  const double g_q = v2.dot(points.n_W);
  const double along = v2.dot(points.t_W);
  const double P = along + turns2 * points.rho2;
  const double M = along - turns2 * points.rho1;
  const double g_qq = face2 ? turns2 * (M + points.g) : face1 ? -turns2 * P : w * P * M;  // φ eliminated
  LastStep step;
  const double slope = g_q + (w * (P + M) + turns2) * points.s / 2;
  const double per_slope = 1 / slope;
  const double first = -(points.g + w * points.s * points.s / 2) * per_slope;
  const double delta = first - (g_qq * per_slope / 2) * (first * first);
  step.delta = delta;
  step.phi = face2 ? turns2 * delta : w * (points.s + delta * P);
  step.psi = face1 ? -turns2 * delta : w * (points.s + delta * M);
  if (!face1) step.slope1 = radius_slope(placed.first, points.rho1, points.n_W);
  if (!face2) step.slope2 = radius_slope(placed.second, points.rho2, -points.n_W);
  const double turn = std::max(std::abs(step.phi), std::abs(step.psi));
  const double slopes = std::abs(step.slope1) + std::abs(step.slope2);
  // Tested with the first-order step: in delta, the second-order term may cancel a large one.
  step.sound = turn <= kLastTurn && std::abs(g_qq * first) <= kLastTurn * std::abs(slope);
  // A long step of the follower would carry over the rounding error of its distant start.
  const bool short_way = 8 * std::abs(delta) * manhattan(v2) <= extent;
  const double left_out = slopes * turn * turn;  // compared with the shorter of the arm 1/w and the extent
  step.exact = step.sound && short_way && left_out <= kLeftOut * extent && left_out * std::abs(w) <= kLeftOut;
  return step;
}

// The same with the follower held fixed: the two points come together along their curves, φ = ψ = w s. For
// contacts that are already closed but where δ would be noise: far out on two open curves the normal
// determines the points only to within its rounding times their radii, which may be much more than the
// rounding of the gap.
[[nodiscard]] inline LastStep closing_step(const ContactPoints& points, const LastStep& last) {
  const double turn = points.link.w * points.s;
  if (!(std::abs(turn) <= kLastTurn)) {
    return {};
  }
  LastStep step = last;
  step.delta = 0;
  step.phi = turn;
  step.psi = turn;
  return step;
}

// Moves normal, points and radii by the last step. Points move along the osculating circles: the centre c1 is
// fixed, c2 moves with body 2.
[[nodiscard, gnu::always_inline]] inline ContactPoints moved(const ContactPair& pair,
                                                             const PlacedPair& placed, const LastStep& step,
                                                             double extent, ContactPoints points) {
  const double turns2 = pair.motion2.turns ? 1 : 0;
  const auto [delta, phi, psi, slope1, slope2, sound, exact] = step;
  const Vector2d n = points.n_W;
  const Vector2d t = points.t_W;
  points.n_W = n + phi * t - phi * phi / 2 * n;
  points.n_W *= 1.5 - points.n_W.squaredNorm() / 2;  // stays a unit vector even after a million steps
  points.t_W = perp(points.n_W);
  points.p1_W += points.rho1 * (phi * t - phi * phi / 2 * n);
  const Vector2d along2 = points.rho2 * psi * ((phi + turns2 * delta) / 2 * n - t);
  const Vector2d on_body2 = points.p2_W + along2;
  points.p2_W += delta * velocity_per_q(pair.motion2, points.p2_W) +
                 delta * delta / 2 * acceleration_per_q(pair.motion2, points.p2_W) + along2;
  if (is_line(pair.curve2)) {
    points.p2_W = foot_on(points.p2_W, points.n_W, points.p1_W);
  }
  if (is_line(pair.curve1)) {
    points.p1_W = foot_on(points.p1_W, points.n_W, points.p2_W);
  }
  points.rho1 += slope1 * phi;
  points.rho2 += slope2 * psi;
  if (points.link.w != 0) {
    points.rho1 = radius_at(placed.first, points.rho1, points.w2_1, points.p1_W, extent);
    points.rho2 = radius_at(placed.second, points.rho2, points.w2_2, on_body2, extent);
  }
  points.link = equivalent_link(is_line(pair.curve1), points.rho1, is_line(pair.curve2), points.rho2);
  return points;
}

}  // namespace higherpair
