#include "higherpair/contact/contact_pair.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "last_step.hpp"
#include "osculating_pass.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

// 2 atan(x); the series is exact to within rounding for small x.
double twice_arc_tangent(double x) {
  const double x2 = x * x;
  return x2 < kArcTangentSeries ? 2 * x * (1 - x2 * (1 / 3.0 - x2 * (1 / 5.0 - x2 / 7.0))) : 2 * std::atan(x);
}

// Velocities and accelerations for du/dt = 1, by the equivalent link written without radii, so that flat
// faces and points are no special cases. With ω_r = ω2 - ω1 and the speeds u1, u2 of the contact along each
// curve,
//     n·(v2 - v1) = 0,   n·(a2 - a1) = ω2 u2 - ω1 u1 - v_s φ̇,   φ̇ = ω1 + w1 ω_r + w v_s.
void add_rates(const ContactPair& pair, const ContactPoints& points, ContactPosition& at) {
  const Vector2d p = points.p_W();
  const Vector2d v1 = velocity_per_q(pair.motion1, p);
  const Vector2d per_q = velocity_per_q(pair.motion2, p);
  at.gap_q = per_q.dot(points.n_W);
  if (at.gap_q == 0) {
    return;
  }
  const double per_gap_q = 1 / at.gap_q;
  at.dq = v1.dot(points.n_W) * per_gap_q;
  const double per_q_t = per_q.dot(points.t_W);
  const double v1_t = v1.dot(points.t_W);
  at.sliding = at.dq * per_q_t - v1_t;
  const ContactRates rates =
      contact_rates(points.link, at.sliding, pair.motion1.turns ? 1 : 0, pair.motion2.turns ? at.dq : 0);
  at.dphi = rates.phi_dot;
  // Rate of n·(velocity per q), as n turns at φ̇ and the contact point moves at v1 + u1 t.
  at.dgap_q = at.dphi * per_q_t - (pair.motion2.turns ? v1_t + rates.along1 : 0);
  const Vector2d a1 = acceleration_per_q(pair.motion1, p);
  const double a2_n = at.dq * at.dq * acceleration_per_q(pair.motion2, p).dot(points.n_W);  // centripetal
  at.d2q = (rates.normal_acceleration + (a1.dot(points.n_W) - a2_n)) * per_gap_q;
}

void set_position(const ContactPair& pair, const ContactPoints& points, double u, double q,
                  ContactPosition& at) {
  static_cast<CommonNormal&>(at) = points;
  at.u = u;
  at.q = q;
  add_rates(pair, points, at);
}

// One osculating pass: the follower's coordinate, its curve and the normal afterwards; not possible where the
// circles cannot touch.
struct Moved {
  PlacedCurve<double> second;
  double q = 0;
  Vector2d n_W;
  bool possible = false;
};

Moved osculating_pass(const ContactPair& pair, const ContactPoints& at, PlacedCurve<double> second, double q,
                      int branch) {
  const OneFreedom& motion = pair.motion2;
  PassStep step;
  if (motion.turns) {
    step = turning_pass(at, motion.p_WO, branch);
    second = turned(second, motion.p_WO, step.turn);
    q += twice_arc_tangent(step.tan_half);
  } else {
    step = sliding_pass(at, motion.direction_W, branch);
    q += step.slide;
    second = place_on(pair.curve2, motion, q);
  }
  const bool possible = step.discriminant >= 0 && step.n_W.allFinite() && step.n_W.squaredNorm() > 0;
  return {second, q, step.n_W.normalized(), possible};
}

// Whether the two points coincide to within their rounding. Along nearly straight curves that may be more
// than the rounding of all lengths; there they have to be close enough for the closing step.
bool is_closed(const ContactPoints& points, double extent) {
  const double s = std::abs(points.s);
  if (!(std::abs(points.g) <= 2 * kEps * extent)) {
    return false;
  }
  if (s <= 2 * kEps * extent) {
    return true;
  }
  const double radii = std::abs(points.rho1) + std::abs(points.rho2);
  return s <= 2 * kEps * (extent + radii) && s <= kLargestSlip * extent &&
         s * std::abs(points.link.w) <= kLastTurn;
}

}  // namespace

double size_of_pair(const ContactPair& pair) {
  return (anchor(pair.curve1) - pair.motion1.p_BO).norm() + (anchor(pair.curve2) - pair.motion2.p_BO).norm() +
         (pair.motion1.p_WO - pair.motion2.p_WO).norm() +
         std::min(size_of(pair.curve1), size_of(pair.curve2)) + std::numeric_limits<double>::min();
}

ContactResult solve_contact(const ContactPair& pair, double u, double q, const Vector2d& n_W, int branch) {
  return solve_contact(pair, place_pair(pair, u, q), u, q, n_W, branch);
}

ContactResult solve_contact(const ContactPair& pair, const PlacedPair& guess, double u, double q,
                            const Vector2d& n_W, int branch) {
  ContactResult result;
  PlacedPair placed = guess;
  Vector2d n = n_W;
  Vector2d n_guess = n;
  for (int pass = 0; pass <= kMaxPasses; ++pass) {
    const ContactPoints points = points_at(pair, placed, n);
    if (!points.exist || !std::isfinite(points.link.w)) {
      result.status = ContactStatus::kNoContact;
      return result;
    }
    if (pass == 0) {
      n_guess = points.n_W;
    }
    const double size = extent(pair, placed, points);
    const LastStep last = last_step(pair, placed, points, size);
    if (last.exact || is_closed(points, size)) {
      const LastStep step = last.sound ? last : closing_step(points, last);
      const ContactPoints end = moved(pair, placed, step, size, points);
      set_position(pair, end, u, q + step.delta, result.at);
      result.step_n = (end.n_W - n_guess).norm();
      const bool wanted = branch * result.at.gap_q >= 0;
      result.status = wanted ? ContactStatus::kOk : ContactStatus::kOtherBranch;
      return result;
    }
    const Moved next = osculating_pass(pair, points, placed.second, q, branch);
    if (!next.possible) {
      result.status = ContactStatus::kNoContact;
      return result;
    }
    placed.second = next.second;
    q = next.q;
    n = next.n_W;
  }
  result.status = ContactStatus::kNotConverged;
  return result;
}

}  // namespace higherpair
