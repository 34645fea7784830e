#include "analysis/tolerances.hpp"
#include "contact_states.hpp"
#include "higherpair/contact/extreme_gap.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/mechanism/joint_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace higherpair {
namespace {

// Solves for the contact from a guess. At a limit itself, where no branch is left to search on, takes the
// position that the two branches share.
ContactResult contact_near(const ContactPair& pair, double u, double q, const Vector2d& n_W, int branch,
                           double size) {
  ContactResult solved = solve_contact(pair, u, q, n_W, branch);
  if (solved.status == ContactStatus::kOk && !gap_q_may_vanish(pair, solved.at)) {
    return solved;
  }
  ContactPosition near;
  near.u = u;
  near.q = q;
  near.n_W = n_W;
  const auto extreme = extreme_gap(pair, near);
  const double unit = pair.motion2.turns ? 1 : size;
  if (!extreme || !(std::abs(extreme->gap) <= kClosedGap * size) ||
      !(std::abs(extreme->at.q - q) <= kNearFollowerLimit * unit)) {
    return solved;
  }
  return {ContactStatus::kOk, extreme->at, 0};
}

// The prediction from which a touching body is placed.
struct Placement {
  const State& from;
  double h;
  const FrozenPair& placed;
  double q;
};

// Sets the body and its contact to a contact that has been found.
void hold_on_boundaries(const Planned& model, const TouchingBody& touching, std::size_t g,
                        const BoundaryPair& pair, const BoundaryContact& found, double phi, State& to) {
  move_contact(touching, found, phi, to.contacts[touching.contact]);
  to.bodies[touching.follower.body] = motion_at(pair.motion2, found.q, 0, 0);
  GroupState& group = to.groups[g];
  group.open = false;
  group.sine = found.gap_q;
  group.lever = velocity_per_q(pair.motion2, found.at.p2_W).norm() +
                (pair.motion2.turns ? kLeastLever * model.plan.size : 0);
  group.noise = kGapQIsZero * group.lever;
}

// \param phi  reference angle of the contact's normal, to select its whole turns
void hold_on_conics(const TouchingBody& touching, std::size_t g, const ContactPair& pair,
                    const ContactPosition& at, double phi, State& to) {
  const double outward = touching.follower_is_second ? phi : phi - kPi;  // of the body that is not placed
  to.contacts[touching.contact] =
      contact_motion(at, nearest_turn(angle_of(at.n_W), outward), touching.follower_is_second);
  to.bodies[touching.follower.body] = motion_at(pair.motion2, at.q, 0, 0);
  set_sine(pair, at, to.groups[g]);
}

GroupStatus place_on_boundaries(const Planned& model, const TouchingBody& touching, std::size_t g,
                                const Placement& guess, State& to) {
  const BoundaryPair pair = frozen_boundaries(model, touching, guess.placed);
  const Contact& contact = model.mechanism.contacts[touching.contact];
  const ContactMotion& before = guess.from.contacts[touching.contact];
  const double h = guess.h;
  const auto turn = [&](const CurveRef& ref) {
    return h * (before.rates.phi_dot - guess.from.bodies[ref.body].omega);
  };
  // Predicted from the speed along each boundary; on a corner, from the normal's turn relative to the body.
  std::array<BoundaryPlace, 2> place = {
      boundary_of(model.mechanism, contact.first)
          .advance(before.place[0], h * before.rates.along1, turn(contact.first))
          .place,
      boundary_of(model.mechanism, contact.second)
          .advance(before.place[1], -h * before.rates.along2, turn(contact.second))
          .place};
  if (!touching.follower_is_second) {
    std::swap(place[0], place[1]);
  }
  const int mode = to.groups[g].mode;
  const BoundaryResult result =
      solve_boundary_contact(pair, guess.placed.u, guess.q, place[0], place[1], mode);
  if (result.status != ContactStatus::kOk) {
    return status_of(result.status);
  }
  hold_on_boundaries(model, touching, g, pair, result.contact, before.phi + h * before.rates.phi_dot, to);
  return GroupStatus::kOk;
}

// Places the body of an open contact, which stays where it is on its joint.
GroupStatus place_open(const TouchingBody& touching, std::size_t g, const State& from, State& to) {
  GroupState& group = to.groups[g];
  group = from.groups[g];
  group.sine = group.lever = 1;
  group.sine_rate = group.noise = 0;
  ContactMotion& motion = to.contacts[touching.contact];
  motion = {};
  motion.touches = false;
  motion.phi = from.contacts[touching.contact].phi;
  const CarriedBody& follower = touching.follower;
  to.bodies[follower.body] = carried_motion(follower, to.bodies[follower.carrier], group.open_at, 0, 0);
  return GroupStatus::kOk;
}

}  // namespace

GroupStatus place_touching(const Planned& model, const TouchingBody& touching, std::size_t g,
                           const State& from, double h, State& to) {
  if (from.groups[g].open) {
    return place_open(touching, g, from, to);
  }
  const FrozenPair placed = frozen_pair(model, touching, to);
  const CarriedBody& follower = touching.follower;
  const ContactMotion& before = from.contacts[touching.contact];
  // Prediction of the follower's coordinate in ground, and of the normal.
  const BodyMotion& body = from.bodies[follower.body];
  double q = predicted_angle(from, follower.body, h);
  if (!follower.freedom.turns) {
    const Vector2d p_W = body.X_WB * follower.freedom.p_BO + h * (body.v_WB + h / 2 * body.a_WB);
    q = (p_W - placed.pair.motion2.p_WO).dot(placed.pair.motion2.direction_W);
  }
  const Vector2d n = (touching.follower_is_second ? 1 : -1) *
                     (Rotation<double>::from_angle(h * before.rates.phi_dot) * before.at.n_W);
  const Contact& contact = model.mechanism.contacts[touching.contact];
  if (contact.by_boundary) {
    return place_on_boundaries(model, touching, g, {from, h, placed, q}, to);
  }
  const ContactResult result = contact_near(placed.pair, placed.u, q, n, to.groups[g].mode, model.plan.size);
  if (result.status != ContactStatus::kOk) {
    return status_of(result.status);
  }
  hold_on_conics(touching, g, placed.pair, result.at, before.phi + h * before.rates.phi_dot, to);
  return GroupStatus::kOk;
}

namespace {

// Of the contacts without overlap, takes the one nearest to the coordinate at which the last was lost. For
// closed curves, a range of positions without overlap is bounded by a contact of each mode: a contact that is
// alone in its mode has no overlap.
GroupStatus place_boundaries_anew(const Planned& model, const TouchingBody& touching, std::size_t g,
                                  const State& from, double lost, State& to) {
  const FrozenPair placed = frozen_pair(model, touching, to);
  const BoundaryPair pair = frozen_boundaries(model, touching, placed);
  std::vector<BoundaryContact> all = find_boundary_contacts(pair, placed.u);
  std::erase_if(all, [&](const BoundaryContact& found) { return to.groups[g].mode * found.gap_q <= 0; });
  const bool alone = all.size() == 1 && pair.boundary1->is_closed() && pair.boundary2->is_closed();
  for (BoundaryContact& found : all) {
    found.q = pair.motion2.turns ? nearest_turn(found.q, lost) : found.q;
  }
  std::sort(all.begin(), all.end(), [&](const BoundaryContact& a, const BoundaryContact& b) {
    return std::abs(a.q - lost) < std::abs(b.q - lost);
  });
  const auto nearest = std::find_if(all.begin(), all.end(), [&](const BoundaryContact& found) {
    return alone || !bodies_overlap(*pair.boundary1, pose_at(pair.motion1, placed.u), *pair.boundary2,
                                    pose_at(pair.motion2, found.q), kOverlapOfBoundaries * model.plan.size);
  });
  if (nearest == all.end()) {
    return place_touching(model, touching, g, from, 0, to);
  }
  hold_on_boundaries(model, touching, g, pair, *nearest, from.contacts[touching.contact].phi, to);
  return GroupStatus::kOk;
}

// The same for conics.
GroupStatus place_conics_anew(const Planned& model, const TouchingBody& touching, std::size_t g,
                              const State& from, double lost, State& to) {
  const FrozenPair placed = frozen_pair(model, touching, to);
  const FindResult found = find_nearest_contact(placed.pair, placed.u, lost, to.groups[g].mode);
  if (found.status != FindStatus::kFound) {
    return place_touching(model, touching, g, from, 0, to);
  }
  hold_on_conics(touching, g, placed.pair, found.at, from.contacts[touching.contact].phi, to);
  return GroupStatus::kOk;
}

}  // namespace

GroupStatus place_touching_anew(const Planned& model, const TouchingBody& touching, std::size_t g,
                                const State& from, State& to) {
  const Contact& contact = model.mechanism.contacts[touching.contact];
  if (contact.both_sides || from.groups[g].open) {
    return place_touching(model, touching, g, from, 0, to);
  }
  const CarriedBody& follower = touching.follower;
  const double lost = carried_coordinate(follower, from.bodies) + carrier_angle(follower, to.bodies);
  return contact.by_boundary ? place_boundaries_anew(model, touching, g, from, lost, to)
                             : place_conics_anew(model, touching, g, from, lost, to);
}

// The rates of the follower's coordinate from n·(v2 - v1) = 0 and the same for accelerations, with its
// carrier moving.
void move_touching(const Planned& model, const TouchingBody& touching, std::size_t g, State& state) {
  const CarriedBody& follower = touching.follower;
  const BodyMotion& carrier = state.bodies[follower.carrier];
  if (const GroupState& group = state.groups[g]; group.open) {
    state.bodies[follower.body] = carried_motion(follower, carrier, group.open_at, 0, 0);
    return;
  }
  const Contact& contact = model.mechanism.contacts[touching.contact];
  const ContactMotion& motion = state.contacts[touching.contact];
  const double sense = touching.follower_is_second ? 1 : -1;
  const Vector2d n = sense * motion.at.n_W;
  const int other = end_off(contact, touching.follower.body).body;
  const Vector2d p = motion.at.p_W();
  const PointMotion known = motion_at_place(state.bodies[other], p);
  BodyMotion& body = state.bodies[follower.body];
  const double q = carried_coordinate(follower, state.bodies);
  const FrozenPair placed = frozen_pair(model, touching, state);
  const double per_q = velocity_per_q(placed.pair.motion2, p).dot(n);
  const double inverse = per_q == 0 ? 0 : 1 / per_q;

  body = carried_motion(follower, carrier, q, 0, 0);
  const double q_dot = (known.v_W - motion_at_place(body, p).v_W).dot(n) * inverse;
  body = carried_motion(follower, carrier, q, q_dot, 0);
  set_contact_rates(model, touching.contact, state);
  const double wanted = motion.rates.normal_acceleration + (known.a_W - motion_at_place(body, p).a_W).dot(n);
  body = carried_motion(follower, carrier, q, q_dot, wanted * inverse);
  // ∂gap/∂q = n·(velocity per q of the contact point), which moves on along the known curve.
  const double along = touching.follower_is_second ? motion.rates.along1 : -motion.rates.along2;
  const Vector2d turned = motion.rates.phi_dot * perp(n);
  if (follower.freedom.turns) {
    const PointMotion pivot = point_motion(carrier, follower.freedom.p_WO);
    const Vector2d arm_rate = known.v_W + along * perp(n) - pivot.v_W;
    state.groups[g].sine_rate = turned.dot(perp(Vector2d(p - pivot.p_W))) + n.dot(perp(arm_rate));
  } else {
    const Vector2d direction = placed.pair.motion2.direction_W;
    state.groups[g].sine_rate = turned.dot(direction) + carrier.omega * n.dot(perp(direction));
  }
}

double touching_sine(const Planned& model, const TouchingBody& touching, const State& state) {
  if (!state.contacts[touching.contact].touches) {
    return 1;
  }
  return gap_per_q(model, touching, state, state.contacts[touching.contact].at);
}

double gap_per_q(const Planned& model, const TouchingBody& touching, const State& state,
                 const CommonNormal& at) {
  const FrozenPair placed = frozen_pair(model, touching, state);
  const Vector2d n = (touching.follower_is_second ? 1 : -1) * at.n_W;
  return n.dot(velocity_per_q(placed.pair.motion2, at.p_W()));
}

}  // namespace higherpair
