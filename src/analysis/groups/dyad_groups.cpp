#include "group_kinds.hpp"
#include "higherpair/linkage/prp_dyad.hpp"
#include "higherpair/linkage/rpr_dyad.hpp"
#include "higherpair/linkage/rrp_dyad.hpp"
#include "higherpair/linkage/rrr_dyad.hpp"

#include <algorithm>

namespace higherpair {
namespace {

// Sets a body's pose so that its direction `along_B` points along `along_W` and its point p_B is at p_W. `h`
// is the path since `from`, to predict the whole turns of its angle.
void pose_link(int index, const Rotation<double>& along_W, const Rotation<double>& along_B,
               const Vector2d& p_W, const Vector2d& p_B, const State& from, double h, State& to) {
  BodyMotion& body = to.bodies[index];
  body.X_WB.R_WB = along_W * along_B.inverse();
  body.X_WB.p_WB = p_W - body.X_WB.R_WB * p_B;
  const auto i = static_cast<std::size_t>(index);
  body.theta = from.turns[i].angle_of(body.X_WB.R_WB, predicted_angle(from, index, h));
  to.turns[i] = from.turns[i].renewed_at(body.theta);
}

void pose_rider(const Rider& rider, const Vector2d& p_W, State& to) {
  const BodyMotion& carrier = to.bodies[rider.carrier];
  BodyMotion& body = to.bodies[rider.body];
  body.theta = carrier.theta + rider.relative_angle;
  body.X_WB.R_WB = carrier.X_WB.R_WB * rider.relative;
  body.X_WB.p_WB = p_W - body.X_WB.R_WB * rider.p_B;
}

void move_rider(const Rider& rider, const PointMotion& point, State& state) {
  const BodyMotion& carrier = state.bodies[rider.carrier];
  move_link(state.bodies[rider.body], carrier.omega, carrier.alpha, point, rider.p_B);
}

AssemblyMode mode_of(const GroupState& group) {
  return group.mode > 0 ? AssemblyMode::kPlus : AssemblyMode::kMinus;
}

GuideMotion guide_on(const BodyLine& line, const State& state) {
  return guide_motion(state.bodies[line.body], line.p_B, line.u_B);
}

// At a singular position the sine is 0 to within rounding; it counts as 0.
double sine_unless_singular(LinkageStatus status, double sine) {
  return status == LinkageStatus::kSingular ? 0 : sine;
}

struct RrrEnds {
  Vector2d A_W, B_W;
  Reach<double> reach;
};

RrrEnds rrr_ends(const RrrDyad& dyad, const State& state) {
  RrrEnds ends{place_of(state, dyad.A), place_of(state, dyad.B), {}};
  if (dyad.loop) {
    const Rotation<double> arm = state.bodies[dyad.arm.body].X_WB.R_WB * dyad.arm.u_B;
    const Rotation<double> ground = state.bodies[dyad.ground.body].X_WB.R_WB * dyad.ground.u_B;
    ends.reach = reach_at(dyad.loop->stretch, dyad.loop->fold, arm * ground.inverse());
  } else {
    ends.reach = rrr_reach(Vector2d(ends.B_W - ends.A_W), dyad.length_a, dyad.length_b,
                           ends.A_W.cwiseAbs().maxCoeff() + ends.B_W.cwiseAbs().maxCoeff());
  }
  return ends;
}

}  // namespace

// All calls are inlined: a call would pass numbers through memory, and the next computation would wait for
// them.
[[gnu::flatten]] GroupStatus place_dyad(const RrrDyad& dyad, std::size_t g, const State& from, double h,
                                        State& to) {
  const RrrEnds ends = rrr_ends(dyad, to);
  if (status_of(ends.reach) == LinkageStatus::kNotAssemblable) {
    return GroupStatus::kOutOfReach;
  }
  GroupState& group = to.groups[g];
  const RrrPosition<double> position =
      rrr_position(Vector2d(ends.B_W - ends.A_W), dyad.length_a, dyad.length_b, ends.reach,
                   static_cast<double>(group.mode));
  group.sine = sine_unless_singular(status_of(ends.reach), position.sine);
  pose_link(dyad.link_a, position.u_a, dyad.along_a, ends.A_W, dyad.a_pA, from, h, to);
  pose_link(dyad.link_b, position.u_b, dyad.along_b, ends.B_W, dyad.b_pB, from, h, to);
  return GroupStatus::kOk;
}

void move_dyad(const RrrDyad& dyad, std::size_t g, State& state) {
  GroupState& group = state.groups[g];
  const PointMotion A = motion_of(state, dyad.A);
  const PointMotion B = motion_of(state, dyad.B);
  BodyMotion& a = state.bodies[dyad.link_a];
  BodyMotion& b = state.bodies[dyad.link_b];
  const RrrPosition<double> position{a.X_WB.R_WB * dyad.along_a, b.X_WB.R_WB * dyad.along_b, group.sine};
  const RrrRates<double> rates =
      rrr_rates(position, dyad.length_a, dyad.length_b, Vector2d(B.v_W - A.v_W), Vector2d(B.a_W - A.a_W));
  move_link(a, rates.omega_a, rates.alpha_a, A, dyad.a_pA);
  move_link(b, rates.omega_b, rates.alpha_b, B, dyad.b_pB);
  const double cosine = position.u_a.cos * position.u_b.cos + position.u_a.sin * position.u_b.sin;
  group.sine_rate = cosine * (rates.omega_b - rates.omega_a);
}

namespace {

RrpMotion solve(const RrpDyad& dyad, const GroupState& group, const State& state) {
  return rrp_dyad(motion_of(state, dyad.A), guide_on(dyad.line, state), dyad.length, mode_of(group));
}

RprMotion solve(const RprDyad& dyad, const GroupState& group, const State& state) {
  return rpr_dyad(motion_of(state, dyad.A), motion_of(state, dyad.B), slot_offset(dyad), mode_of(group));
}

PrpMotion solve(const SlideDyad& dyad, const State& state) {
  const GuideMotion first = guide_on(dyad.first, state);
  if (dyad.pin) {
    // The second direction, relative to the first line.
    const Rotation<double> turned = dyad.first.u_B.inverse() * dyad.second.u_B;
    return prp_dyad(first, guide_through(motion_of(state, *dyad.pin), first, turned));
  }
  return prp_dyad(first, guide_on(dyad.second, state));
}

}  // namespace

GroupStatus place_dyad(const RrpDyad& dyad, std::size_t g, const State& from, double h, State& to) {
  GroupState& group = to.groups[g];
  const RrpMotion motion = solve(dyad, group, to);
  if (motion.status == LinkageStatus::kNotAssemblable) {
    return GroupStatus::kOutOfReach;
  }
  const Rotation<double> u = to.bodies[dyad.line.body].X_WB.R_WB * dyad.line.u_B;
  group.sine = sine_unless_singular(motion.status, (motion.u_link * u.inverse()).cos);
  pose_link(dyad.link, motion.u_link, dyad.along, place_of(to, dyad.A), dyad.pA, from, h, to);
  if (dyad.slider) {
    pose_rider(*dyad.slider, motion.p_WC, to);
  }
  return GroupStatus::kOk;
}

void move_dyad(const RrpDyad& dyad, std::size_t g, State& state) {
  GroupState& group = state.groups[g];
  const RrpMotion motion = solve(dyad, group, state);
  const RrpMotion::Rates rates = motion.rates.value_or(RrpMotion::Rates{});
  move_link(state.bodies[dyad.link], rates.omega, rates.alpha, motion_of(state, dyad.A), dyad.pA);
  if (dyad.slider) {
    move_rider(*dyad.slider, {motion.p_WC, rates.v_WC, rates.a_WC}, state);
  }
  const BodyMotion& carrier = state.bodies[dyad.line.body];
  const Rotation<double> u = carrier.X_WB.R_WB * dyad.line.u_B;
  group.sine_rate = -(motion.u_link * u.inverse()).sin * (rates.omega - carrier.omega);
}

GroupStatus place_dyad(const RprDyad& dyad, std::size_t g, const State& from, double h, double size,
                       State& to) {
  GroupState& group = to.groups[g];
  const RprMotion motion = solve(dyad, group, to);
  if (motion.status == LinkageStatus::kNotAssemblable) {
    return GroupStatus::kOutOfReach;
  }
  group.sine = sine_unless_singular(motion.status, motion.s);
  group.lever = size;
  pose_link(dyad.link, motion.u, dyad.line.u_B, place_of(to, dyad.A), dyad.pA, from, h, to);
  if (dyad.slider) {
    pose_rider(*dyad.slider, place_of(to, dyad.B), to);
  }
  return GroupStatus::kOk;
}

void move_dyad(const RprDyad& dyad, std::size_t g, State& state) {
  const RprMotion motion = solve(dyad, state.groups[g], state);
  const RprMotion::Rates rates = motion.rates.value_or(RprMotion::Rates{});
  move_link(state.bodies[dyad.link], rates.omega, rates.alpha, motion_of(state, dyad.A), dyad.pA);
  if (dyad.slider) {
    move_rider(*dyad.slider, motion_of(state, dyad.B), state);
  }
  state.groups[g].sine_rate = rates.s_dot;
}

GroupStatus place_dyad(const SlideDyad& dyad, std::size_t g, const State&, double, State& to) {
  const PrpMotion motion = solve(dyad, to);
  if (motion.status == LinkageStatus::kNotAssemblable) {
    return GroupStatus::kOutOfReach;
  }
  to.groups[g].sine = sine_unless_singular(motion.status, motion.sine);
  to.groups[g].mode = to.groups[g].sine < 0 ? -1 : 1;
  for (const Rider& rider : dyad.riders) {
    pose_rider(rider, motion.p_WC, to);
  }
  if (dyad.pinned) {
    pose_rider(*dyad.pinned, place_of(to, *dyad.pin), to);
  }
  return GroupStatus::kOk;
}

void move_dyad(const SlideDyad& dyad, std::size_t g, State& state) {
  const PrpMotion motion = solve(dyad, state);
  const PrpMotion::Rates rates = motion.rates.value_or(PrpMotion::Rates{});
  for (const Rider& rider : dyad.riders) {
    move_rider(rider, {motion.p_WC, rates.v_WC, rates.a_WC}, state);
  }
  if (dyad.pinned) {
    move_rider(*dyad.pinned, motion_of(state, *dyad.pin), state);
  }
  state.groups[g].sine_rate = motion.sine_rate;
}

namespace {

double least_of(const Reach<double>& reach) {
  return std::min(reach.stretch, reach.fold);
}

}  // namespace

double reach_of(const RrrDyad& dyad, const GroupState&, const State& state) {
  return least_of(rrr_ends(dyad, state).reach);
}

double reach_of(const RrpDyad& dyad, const GroupState& group, const State& state) {
  return least_of(solve(dyad, group, state).reach);
}

double reach_of(const RprDyad& dyad, const GroupState& group, const State& state) {
  return least_of(solve(dyad, group, state).reach);
}

double dyad_sine(const RrrDyad& dyad, const State& state) {
  const Rotation<double> u_a = state.bodies[dyad.link_a].X_WB.R_WB * dyad.along_a;
  const Rotation<double> u_b = state.bodies[dyad.link_b].X_WB.R_WB * dyad.along_b;
  return (u_a.inverse() * u_b).sin;
}

double dyad_sine(const RrpDyad& dyad, const State& state) {
  const Rotation<double> u_link = state.bodies[dyad.link].X_WB.R_WB * dyad.along;
  const Rotation<double> u = state.bodies[dyad.line.body].X_WB.R_WB * dyad.line.u_B;
  return (u.inverse() * u_link).cos;
}

double dyad_sine(const RprDyad& dyad, const State& state) {
  const Rotation<double> u = state.bodies[dyad.link].X_WB.R_WB * dyad.line.u_B;
  return (place_of(state, dyad.B) - place_of(state, dyad.A)).dot(Vector2d(u.cos, u.sin));
}

double dyad_sine(const SlideDyad& dyad, const State& state) {
  return solve(dyad, state).sine;
}

}  // namespace higherpair
