#include "higherpair/contact/jerk.hpp"

#include "contact_points.hpp"
#include "higherpair/geometry/body_jerk.hpp"
#include "tolerances.hpp"

#include <cmath>

namespace higherpair {
namespace {

// dρ/dφ; 0 for a circle, a line and a point.
double radius_rate(const Curve& curve, const BodyMotion& body, double rho, const Vector2d& n_W) {
  return is_curved(curve) ? radius_slope(place(curve, body.X_WB), rho, n_W) : 0;
}

// Without the jerks of the body's frame.
struct MaterialPoint {
  Vector2d v_W, a_W, jerk_W;
};

MaterialPoint material_at(const BodyMotion& body, const Vector2d& p_W) {
  const Vector2d r_W = p_W - body.X_WB.p_WB;
  return {body.v_WB + body.omega * perp(r_W),
          body.a_WB + body.alpha * perp(r_W) - body.omega * body.omega * r_W, jerk_by_turning(body, r_W)};
}

// Both bodies of a pair for du/dt = 1, d²u/dt² = d³u/dt³ = 0, and the follower's d³q/dt³ taken as 0.
struct PairState {
  Vector2d per_q_W;           // velocity of the follower's point at the contact per dq/dt
  Vector2d known_relative_W;  // j2 - j1 at the contact
  ContactJerk contact;
};

// The body's point at the contact with d³q/dt³ = 0: about a pivot, -3 q̇ q̈ r - q̇³ ẑ×r; none on a slide.
Vector2d jerk_at_rest(const OneFreedom& freedom, double q_dot, double q_ddot, const Vector2d& p_W) {
  if (!freedom.turns) {
    return Vector2d::Zero();
  }
  const Vector2d r_W = p_W - freedom.p_WO;
  return -3 * q_dot * q_ddot * r_W - q_dot * q_dot * q_dot * perp(r_W);
}

PairState pair_state(const ContactPair& pair, const ContactPosition& at) {
  const BodyMotion body1 = motion_at(pair.motion1, at.u, 1, 0);
  const BodyMotion body2 = motion_at(pair.motion2, at.q, at.dq, at.d2q);
  const Vector2d p_W = at.p_W();
  return {velocity_per_q(pair.motion2, p_W),
          jerk_at_rest(pair.motion2, at.dq, at.d2q, p_W) - jerk_at_rest(pair.motion1, 1, 0, p_W),
          contact_jerk(pair.curve1, pair.curve2, at, body1, body2)};
}

// By the normal condition.
std::optional<double> linkage_jerk(const PairState& state, const Vector2d& n_W) {
  const double per_q = state.per_q_W.dot(n_W);
  if (!(std::abs(per_q) > kGapQIsZero * state.per_q_W.norm())) {
    return std::nullopt;
  }
  return (state.contact.linkage_normal_jerk - state.known_relative_W.dot(n_W)) / per_q;
}

}  // namespace

ContactJerk contact_jerk(const Curve& curve1, const Curve& curve2, const CommonNormal& at,
                         const BodyMotion& body1, const BodyMotion& body2) {
  const auto link = equivalent_link(is_line(curve1), at.rho1, is_line(curve2), at.rho2);
  const ContactRates rates = contact_rates(link, at, body1, body2);
  const Vector2d p_W = at.p_W();
  const double a_s = (material_at(body2, p_W).a_W - material_at(body1, p_W).a_W).dot(perp(at.n_W));
  const double omega_r = body2.omega - body1.omega;
  const double alpha_r = body2.alpha - body1.alpha;
  const double nu1 = link.w1 * omega_r + link.w * rates.sliding;
  const double nu2 = link.w2 * omega_r - link.w * rates.sliding;
  const double radius1 = radius_rate(curve1, body1, at.rho1, at.n_W) * nu1 * nu1;
  const double radius2 = radius_rate(curve2, body2, at.rho2, -at.n_W) * nu2 * nu2;

  // Of the frozen linkage; what the rates of the radii add follows.
  const double along1 = link.z * alpha_r + link.w2 * a_s;
  const double along2 = link.z * alpha_r - link.w1 * a_s;
  const double phi_ddot = body1.alpha + link.w1 * alpha_r + link.w * a_s;
  const double further = link.w1 * radius1 - link.w2 * radius2;
  ContactJerk jerk;
  jerk.along1 = along1 + further;
  jerk.along2 = along2 + further;
  jerk.phi_ddot = phi_ddot - link.w * (radius1 + radius2);
  jerk.linkage_normal_jerk = 2 * (body2.alpha * rates.along2 - body1.alpha * rates.along1) +
                             body2.omega * along2 - body1.omega * along1 - 2 * rates.phi_dot * a_s -
                             rates.sliding * phi_ddot;
  jerk.rate_of_curvature = {radius1 * nu1, -radius2 * nu2};
  jerk.rolling_jerk = omega_r * (body1.omega + body2.omega + rates.phi_dot) * rates.along1;
  return jerk;
}

std::optional<PairJerk> slipping_jerk(const ContactPair& pair, const ContactPosition& at) {
  const PairState state = pair_state(pair, at);
  const auto linkage = linkage_jerk(state, at.n_W);
  if (!linkage) {
    return std::nullopt;
  }
  const auto& [first, second] = state.contact.rate_of_curvature;
  return PairJerk{*linkage + (first + second) / state.per_q_W.dot(at.n_W), linkage};
}

PairJerk rolling_jerk(const ContactPair& pair, const ContactPosition& at) {
  const PairState state = pair_state(pair, at);
  const Vector2d relative_W =
      state.contact.normal_jerk() * at.n_W + state.contact.rolling_jerk * perp(at.n_W);
  const double d3q = (relative_W - state.known_relative_W).dot(state.per_q_W) / state.per_q_W.squaredNorm();
  return {d3q, linkage_jerk(state, at.n_W)};
}

}  // namespace higherpair
