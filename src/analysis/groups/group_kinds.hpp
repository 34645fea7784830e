#pragma once

#include "group_solver.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <cmath>

// Helpers that the solvers of all kinds of groups share, and the solvers' entry points.

namespace higherpair {

[[nodiscard]] inline Vector2d place_of(const State& state, const BodyPoint& point) {
  return state.bodies[point.body].X_WB * point.p_B;
}

[[nodiscard]] inline PointMotion motion_of(const State& state, const BodyPoint& point) {
  return point_motion(state.bodies[point.body], point.p_B);
}

/// The angle of a body after `h` of the path, extrapolated from its rates.
[[nodiscard]] inline double predicted_angle(const State& from, int body, double h) {
  const BodyMotion& at = from.bodies[body];
  return at.theta + h * (at.omega + h / 2 * at.alpha);
}

/// Places a body at the coordinate q of its joint to ground; its rates are left as they are.
inline void place_at(const OneFreedom& freedom, double q, int index, const State& from, State& to) {
  BodyMotion& body = to.bodies[index];
  if (!freedom.turns) {
    body.X_WB = pose_at(freedom, q);
    body.theta = freedom.theta;
    return;
  }
  const auto i = static_cast<std::size_t>(index);
  to.turns[i] = from.turns[i].renewed_at(q);
  body.X_WB = pose_at(freedom, q, to.turns[i].at(q));
  body.theta = q;
}

/// Sets a body's rates from ω, α and the motion of its point p_B.
inline void move_link(BodyMotion& body, double omega, double alpha, const PointMotion& point,
                      const Vector2d& p_B) {
  const Vector2d r_W = body.X_WB.R_WB * Vector2d(-p_B);
  body.omega = omega;
  body.alpha = alpha;
  body.v_WB = point.v_W + omega * perp(r_W);
  body.a_WB = point.a_W + alpha * perp(r_W) - omega * omega * r_W;
}

/// Places a body at the angle theta about its pin on a known body, at rest.
inline void turn_on_pin(const BodyPoint& pin, int index, const Vector2d& p_B, double theta, State& to) {
  BodyMotion& body = to.bodies[index];
  body = {};
  body.theta = theta;
  body.X_WB.R_WB = Rotation<double>::from_angle(theta);
  body.X_WB.p_WB = place_of(to, pin) - body.X_WB.R_WB * p_B;
}

[[nodiscard]] GroupStatus place_dyad(const RrrDyad& dyad, std::size_t g, const State& from, double h,
                                     State& to);
[[nodiscard]] GroupStatus place_dyad(const RrpDyad& dyad, std::size_t g, const State& from, double h,
                                     State& to);
/// \param size  of the mechanism [m]
[[nodiscard]] GroupStatus place_dyad(const RprDyad& dyad, std::size_t g, const State& from, double h,
                                     double size, State& to);
[[nodiscard]] GroupStatus place_dyad(const SlideDyad& dyad, std::size_t g, const State& from, double h,
                                     State& to);
void move_dyad(const RrrDyad& dyad, std::size_t g, State& state);
void move_dyad(const RrpDyad& dyad, std::size_t g, State& state);
void move_dyad(const RprDyad& dyad, std::size_t g, State& state);
void move_dyad(const SlideDyad& dyad, std::size_t g, State& state);
[[nodiscard]] double reach_of(const RrrDyad& dyad, const GroupState& group, const State& state);
[[nodiscard]] double reach_of(const RrpDyad& dyad, const GroupState& group, const State& state);
[[nodiscard]] double reach_of(const RprDyad& dyad, const GroupState& group, const State& state);
[[nodiscard]] double dyad_sine(const RrrDyad& dyad, const State& state);
[[nodiscard]] double dyad_sine(const RrpDyad& dyad, const State& state);
[[nodiscard]] double dyad_sine(const RprDyad& dyad, const State& state);
[[nodiscard]] double dyad_sine(const SlideDyad& dyad, const State& state);
[[nodiscard]] double tracked_sine(const TrackedPair& tracked, const State& state);
[[nodiscard]] double touching_sine(const Planned& model, const TouchingBody& touching, const State& state);

/// Derivative of the gap at a place of the contact by the follower's coordinate. Of two places with different
/// signs one pushes the follower forward and the other back.
[[nodiscard]] double gap_per_q(const Planned& model, const TouchingBody& touching, const State& state,
                               const CommonNormal& at);

void place_geared(const Planned& model, const GearedBody& geared, State& to);
void move_geared(const Planned& model, const GearedBody& geared, State& state);

[[nodiscard]] GroupStatus place_tracked(const TrackedPair& tracked, std::size_t g, const State& from,
                                        const std::vector<DriverMotion>& drivers, State& to);
/// Places the pair at the contact of the track's branch that is nearest to the last one, however far the
/// drivers have moved.
[[nodiscard]] GroupStatus place_tracked_anew(const TrackedPair& tracked, std::size_t g, const State& from,
                                             const std::vector<DriverMotion>& drivers, State& to);
void move_tracked(const Planned& model, const TrackedPair& tracked, std::size_t g,
                  const std::vector<DriverMotion>& drivers, State& state);
[[nodiscard]] GroupStatus place_touching(const Planned& model, const TouchingBody& touching, std::size_t g,
                                         const State& from, double h, State& to);
/// The same without a prediction from a motion. Where an open boundary has been left: of all contacts of the
/// group's branch whose bodies do not overlap, the one nearest to where it was lost.
[[nodiscard]] GroupStatus place_touching_anew(const Planned& model, const TouchingBody& touching,
                                              std::size_t g, const State& from, State& to);
/// Moves a contact of boundaries to where it has been found, as seen from the contact's first body; its rates
/// are left as they are. \param phi  reference angle of the normal, to select its whole turns
inline void move_contact(const TouchingBody& touching, const BoundaryContact& found, double phi,
                         ContactMotion& motion) {
  const bool second = touching.follower_is_second;
  motion.touches = true;
  motion.at = second ? found.at : found.at.exchanged();
  motion.place = {second ? found.place1 : found.place2, second ? found.place2 : found.place1};
  motion.phi = nearest_turn(angle_of(motion.at.n_W), phi);
}

/// The rate of the follower's joint. \pre its carrier is at rest
[[nodiscard]] inline double follower_rate(const State& state, const CarriedBody& follower) {
  const BodyMotion& body = state.bodies[follower.body];
  return follower.freedom.turns ? body.omega : body.v_WB.dot(follower.freedom.direction_W);
}
[[nodiscard]] inline double follower_acceleration(const State& state, const CarriedBody& follower) {
  const BodyMotion& body = state.bodies[follower.body];
  return follower.freedom.turns ? body.alpha : body.a_WB.dot(follower.freedom.direction_W);
}
void move_touching(const Planned& model, const TouchingBody& touching, std::size_t g, State& state);
}  // namespace higherpair
