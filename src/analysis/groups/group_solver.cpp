#include "group_solver.hpp"

#include "analysis/follow/joint_ends.hpp"
#include "coupled_bodies.hpp"
#include "group_kinds.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/numeric/overload.hpp"
#include "higherpair/numeric/special_values.hpp"

namespace higherpair {
namespace {

void place_driven(const DrivenBody& driven, const std::vector<DriverMotion>& drivers, const State& from,
                  State& to) {
  const CarriedBody& carried = driven.carried;
  const double q = carried.sign * drivers[driven.driver].position;
  if (carried.carrier == 0) {
    place_at(carried.freedom, q, carried.body, from, to);
    return;
  }
  to.bodies[carried.body] = carried_motion(carried, to.bodies[carried.carrier], q, 0, 0);
}

void move_driven(const DrivenBody& driven, const std::vector<DriverMotion>& drivers, State& state) {
  const CarriedBody& carried = driven.carried;
  const DriverMotion& driver = drivers[driven.driver];
  if (carried.carrier == 0) {
    set_rates_at(carried.freedom, carried.sign * driver.velocity, carried.sign * driver.acceleration,
                 state.bodies[carried.body]);
    return;
  }
  state.bodies[carried.body] =
      carried_motion(carried, state.bodies[carried.carrier], carried.sign * driver.position,
                     carried.sign * driver.velocity, carried.sign * driver.acceleration);
}

}  // namespace

void set_contact_rates(const Planned& model, int index, State& state) {
  const Contact& contact = model.mechanism.contacts[index];
  ContactMotion& motion = state.contacts[index];
  const EquivalentLink link = link_of(model.mechanism, contact, motion.at);
  motion.rates =
      contact_rates(link, motion.at, state.bodies[contact.first.body], state.bodies[contact.second.body]);
}

BodyMotion carried_motion(const CarriedBody& carried, const BodyMotion& carrier, double q, double q_dot,
                          double q_ddot) {
  const BodyMotion relative = motion_at(carried.freedom, q, q_dot, q_ddot);
  return carried.carrier == 0 ? relative : compose(carrier, relative);
}

double carried_coordinate(const CarriedBody& carried, const std::vector<BodyMotion>& bodies) {
  const BodyMotion& carrier = bodies[carried.carrier];
  const BodyMotion& body = bodies[carried.body];
  if (carried.freedom.turns) {
    return body.theta - carrier.theta;
  }
  const Vector2d p_C = carrier.X_WB.inverse_times(body.X_WB * carried.freedom.p_BO);
  return (p_C - carried.freedom.p_WO).dot(carried.freedom.direction_W);
}

double carrier_angle(const CarriedBody& carried, const std::vector<BodyMotion>& bodies) {
  return carried.freedom.turns ? bodies[carried.carrier].theta : 0;
}

FrozenPair frozen_pair(const Planned& model, const TouchingBody& touching, const State& state) {
  const Contact& contact = model.mechanism.contacts[touching.contact];
  const CurveRef& known = end_off(contact, touching.follower.body);
  const CurveRef& own = end_on(contact, touching.follower.body);
  const BodyMotion& body1 = state.bodies[known.body];
  const BodyMotion& carrier = state.bodies[touching.follower.carrier];
  FrozenPair placed;
  placed.u = body1.theta;
  placed.pair.curve1 = curve_of(model.mechanism, known);
  placed.pair.motion1.p_WO = body1.X_WB.p_WB;
  placed.pair.curve2 = curve_of(model.mechanism, own);
  OneFreedom& freedom = placed.pair.motion2;
  freedom = touching.follower.freedom;
  freedom.p_WO = carrier.X_WB * freedom.p_WO;
  freedom.direction_W = carrier.X_WB.R_WB * freedom.direction_W;
  freedom.theta += carrier.theta;
  freedom.R_WB = carrier.X_WB.R_WB * freedom.R_WB;
  return placed;
}

BoundaryPair frozen_boundaries(const Planned& model, const TouchingBody& touching, const FrozenPair& frozen) {
  const Contact& contact = model.mechanism.contacts[touching.contact];
  const int own = touching.follower.body;
  return {&boundary_of(model.mechanism, end_off(contact, own)), frozen.pair.motion1,
          &boundary_of(model.mechanism, end_on(contact, own)), frozen.pair.motion2};
}

namespace {

GroupStatus place_anywhere(const Planned& model, std::size_t g, const State& from, double h,
                           const std::vector<DriverMotion>& drivers, State& to) {
  const Group& group = model.plan.groups[g];
  return std::visit(
      Overload{[&](const DrivenBody& driven) {
                 place_driven(driven, drivers, from, to);
                 return GroupStatus::kOk;
               },
               [&](const RprDyad& dyad) { return place_dyad(dyad, g, from, h, model.plan.size, to); },
               [&](const auto& dyad) { return place_dyad(dyad, g, from, h, to); },
               [&](const TrackedPair& tracked) { return place_tracked(tracked, g, from, drivers, to); },
               [&](const TouchingBody& touching) { return place_touching(model, touching, g, from, h, to); },
               [&](const IdleBody& idle) {
                 turn_on_pin(idle.pin, idle.body, idle.p_B, from.bodies[idle.body].theta, to);
                 return GroupStatus::kOk;
               },
               [&](const GearedBody& geared) {
                 place_geared(model, geared, to);
                 return GroupStatus::kOk;
               },
               [&](const CoupledBodies&) { return place_coupled(model, g, from, h, drivers, to); }},
      group.kind);
}

GroupStatus within_ends(const Planned& model, std::size_t g, const State& placed, GroupStatus status) {
  return status == GroupStatus::kOk && joint_beyond_end(model, g, placed) ? GroupStatus::kOutOfReach : status;
}

}  // namespace

GroupStatus place_group(const Planned& model, std::size_t g, const State& from, double h,
                        const std::vector<DriverMotion>& drivers, State& to) {
  return within_ends(model, g, to, place_anywhere(model, g, from, h, drivers, to));
}

void set_group_rates(const Planned& model, std::size_t g, const std::vector<DriverMotion>& drivers,
                     State& state) {
  const Group& group = model.plan.groups[g];
  std::visit(Overload{[&](const DrivenBody& driven) { move_driven(driven, drivers, state); },
                      [&](const auto& dyad) { move_dyad(dyad, g, state); },
                      [&](const TrackedPair& tracked) { move_tracked(model, tracked, g, drivers, state); },
                      [&](const TouchingBody& touching) { move_touching(model, touching, g, state); },
                      [&](const IdleBody& idle) {
                        move_link(state.bodies[idle.body], 0, 0, motion_of(state, idle.pin), idle.p_B);
                      },
                      [&](const GearedBody& geared) { move_geared(model, geared, state); },
                      [&](const CoupledBodies&) { move_coupled(model, g, drivers, state); }},
             group.kind);
}

GroupStatus place_group_anew(const Planned& model, std::size_t g, const State& from,
                             const std::vector<DriverMotion>& drivers, State& to) {
  const GroupStatus status = std::visit(
      Overload{
          [&](const TrackedPair& tracked) { return place_tracked_anew(tracked, g, from, drivers, to); },
          [&](const TouchingBody& touching) { return place_touching_anew(model, touching, g, from, to); },
          [&](const auto&) { return place_anywhere(model, g, from, 0, drivers, to); }},
      model.plan.groups[g].kind);
  return within_ends(model, g, to, status);
}

double reach_of(const Planned& model, std::size_t g, const State& state) {
  const GroupState& group = state.groups[g];
  return std::visit(
      Overload{[&](const RrrDyad& dyad) { return reach_of(dyad, group, state); },
               [&](const RrpDyad& dyad) { return reach_of(dyad, group, state); },
               [&](const RprDyad& dyad) { return reach_of(dyad, group, state); },
               [&](const TrackedPair&) { return -kInf; }, [&](const TouchingBody&) { return -kInf; },
               [&](const CoupledBodies&) { return -kInf; }, [&](const auto&) { return kInf; }},
      model.plan.groups[g].kind);
}

double sine_of(const Planned& model, std::size_t g, const State& state) {
  return std::visit(
      Overload{[&](const RrrDyad& dyad) { return dyad_sine(dyad, state); },
               [&](const RrpDyad& dyad) { return dyad_sine(dyad, state); },
               [&](const RprDyad& dyad) { return dyad_sine(dyad, state); },
               [&](const SlideDyad& dyad) { return dyad_sine(dyad, state); },
               [&](const TrackedPair& tracked) {
                 const bool follows = std::holds_alternative<ContactTrack>(state.tracks[g]);
                 return follows ? tracked_sine(tracked, state) : state.groups[g].sine;
               },
               [&](const TouchingBody& touching) { return touching_sine(model, touching, state); },
               [&](const CoupledBodies&) { return coupled_sine(model, g, state); },
               [&](const auto&) { return state.groups[g].sine; }},
      model.plan.groups[g].kind);
}

}  // namespace higherpair
