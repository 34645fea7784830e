#include "contact/pair_jerk.hpp"

#include "higherpair/contact/jerk.hpp"
#include "higherpair/contact/tolerances.hpp"

#include <cmath>

namespace higherpair {
namespace {

// Both bodies of a pair for du/dt = 1, d²u/dt² = d³u/dt³ = 0, and the follower's d³q/dt³ taken as 0.
struct PairState {
  Vector2d per_q_W;           // velocity of the follower's contact point per dq/dt
  Vector2d known_relative_W;  // j2 - j1 at the contact
  ContactJerk contact;
  double rolling_jerk = 0;  // t·(j2 - j1) that a contact without slip also requires
};

// Jerk of the body's point at the contact for d³q/dt³ = 0: about a pivot -3 q̇ q̈ r - q̇³ ẑ×r; zero on a
// slide.
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
  // Without slip (v_s = 0 at all times, u1 = u2 = u): t·(j2 - j1) = ω_r (ω1 + ω2 + φ̇) u.
  const EquivalentLink link = equivalent_link(is_line(pair.curve1), at.rho1, is_line(pair.curve2), at.rho2);
  const ContactRates rates = contact_rates(link, at, body1, body2);
  const double rolling =
      (body2.omega - body1.omega) * (body1.omega + body2.omega + rates.phi_dot) * rates.along1;
  return {velocity_per_q(pair.motion2, p_W),
          jerk_at_rest(pair.motion2, at.dq, at.d2q, p_W) - jerk_at_rest(pair.motion1, 1, 0, p_W),
          contact_jerk(pair.curve1, pair.curve2, at, body1, body2), rolling};
}

// From the condition along the normal.
std::optional<double> linkage_jerk(const PairState& state, const Vector2d& n_W) {
  const double per_q = state.per_q_W.dot(n_W);
  if (!(std::abs(per_q) > kGapQIsZero * state.per_q_W.norm())) {
    return std::nullopt;
  }
  return (state.contact.linkage_normal_jerk - state.known_relative_W.dot(n_W)) / per_q;
}

}  // namespace

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
  const Vector2d relative_W = state.contact.normal_jerk() * at.n_W + state.rolling_jerk * perp(at.n_W);
  const double d3q = (relative_W - state.known_relative_W).dot(state.per_q_W) / state.per_q_W.squaredNorm();
  return {d3q, linkage_jerk(state, at.n_W)};
}

}  // namespace higherpair
