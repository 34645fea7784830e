#pragma once

#include "chain_wrenches.hpp"
#include "higherpair/linkage/dyad_statics.hpp"
#include "higherpair/numeric/overload.hpp"

// Inverse dynamics of a chain at one position (T = double) or at several at once (T = Pack). The loads on
// every body, including the inertia of its motion, are carried group by group from the end of the chain to
// its driver, in closed form. The equations are those of dynamics/statics.hpp, which factorises matrices
// instead.

namespace higherpair {

/// The driver's effort, as in DriverEffort.
template <class T>
struct ChainEffort {
  T effort;
  T by_power;
};

/// Records what a joint exerts on the body that it holds, and applies the opposite to its other body.
/// \param known   the other body; loads on ground are not recorded
/// \param p_W     where the force acts
template <class T>
inline void carry(const ChainSupport& support, int known, const Vector2<T>& p_W, const Vector2<T>& force,
                  const T& moment, const ChainBalance<T>& in) {
  const T sign(support.sign);
  in.reactions[support.joint] = {times(sign, force), sign * moment};
  if (known != kGround) {
    ChainWrench<T>& wrench = in.wrenches[known];
    wrench.push(times(T(-1), force), less(p_W, in.bodies[known].p_WB));
    wrench.moment = wrench.moment - moment;
  }
}

/// A pin that balances the resultant force on a body.
template <class T>
inline void carry_by_pin(const ChainSupport& support, int known, const Vector2<T>& p_W,
                         const Vector2<T>& force, const ChainBalance<T>& in) {
  carry(support, known, p_W, Vector2<T>(-force.x(), -force.y()), T(0), in);
}

/// A slide along the unit direction u that holds a body: transmits the force across u, and the moment about
/// the joint's second point.
template <class T>
inline void carry_by_slide(const ChainSupport& support, int held, int known, const Vector2<T>& u,
                           const ChainBalance<T>& in) {
  const Vector2<T> p_W =
      chain_point<ChainRates::kNone>(in.bodies[support.second.body], support.second.p_B).p_W;
  const ChainWrench<T>& wrench = in.wrenches[held];
  const Vector2<T> across = left_of(u);
  carry(support, known, p_W, times(-dot(across, wrench.force), across),
        -wrench.about(less(p_W, in.bodies[held].p_WB)), in);
}

/// The driven group: records the joint's reaction and returns the driver's effort.
template <class T>
[[nodiscard]] inline T balance_group(const DrivenBody& driven, const ChainSupports& supports,
                                     const ChainBalance<T>& in) {
  const CarriedBody& carried = driven.carried;
  const OneFreedom& freedom = carried.freedom;
  const ChainWrench<T>& wrench = in.wrenches[carried.body];
  const T sign(carried.sign);
  if (freedom.turns) {
    carry_by_pin(supports.outer[0], kGround, all_lanes<T>(freedom.p_WO), wrench.force, in);
    return -(sign * wrench.about(arm_of(in.bodies[carried.body], freedom.p_BO)));
  }
  const Vector2<T> along = all_lanes<T>(freedom.direction_W);
  carry_by_slide(supports.outer[0], carried.body, kGround, along, in);
  return -(sign * dot(wrench.force, along));
}

template <class T>
inline void balance_group(const RrrDyad& dyad, const ChainSupports& supports, const ChainBalance<T>& in) {
  const ChainBody<T>& a = in.bodies[dyad.link_a];
  const ChainBody<T>& b = in.bodies[dyad.link_b];
  const ChainWrench<T>& on_a = in.wrenches[dyad.link_a];
  const ChainWrench<T>& on_b = in.wrenches[dyad.link_b];
  const Vector2<T> A = arm_of(a, dyad.a_pA);
  const Vector2<T> B = arm_of(b, dyad.b_pB);
  const Vector2<T> C =
      rrr_inner_force(arm_of(a, Vector2d(dyad.a_pC - dyad.a_pA)), arm_of(b, Vector2d(dyad.b_pC - dyad.b_pB)),
                      on_a.about(A), on_b.about(B));
  carry(supports.inner, kGround, C, C, T(0), in);
  carry_by_pin(supports.outer[0], dyad.A.body, sum(a.p_WB, A), sum(on_a.force, C), in);
  carry_by_pin(supports.outer[1], dyad.B.body, sum(b.p_WB, B), less(on_b.force, C), in);
}

template <class T>
inline void balance_group(const RrpDyad& dyad, const ChainSupports& supports, const ChainBalance<T>& in) {
  const ChainBody<T>& link = in.bodies[dyad.link];
  const ChainWrench<T>& on_link = in.wrenches[dyad.link];
  const Rotation<T> line = in.bodies[dyad.line.body].R_WB * all_lanes<T>(dyad.line.u_B);
  const Vector2<T> u(line.cos, line.sin);
  const Vector2<T> A = arm_of(link, dyad.pA);
  const Vector2<T> arm = arm_of(link, Vector2d(dyad.pC - dyad.pA));
  const T along = dyad.slider ? dot(in.wrenches[dyad.slider->body].force, u) : T(0);
  const Vector2<T> C = rrp_inner_force(arm, u, on_link.about(A), along);
  const Vector2<T> A_W = sum(link.p_WB, A);
  carry_by_pin(supports.outer[0], dyad.A.body, A_W, sum(on_link.force, C), in);
  if (dyad.slider) {
    const int slider = dyad.slider->body;
    carry(supports.inner, slider, sum(A_W, arm), C, T(0), in);
    carry_by_slide(supports.outer[1], slider, dyad.line.body, u, in);
  } else {
    carry(supports.outer[1], dyad.line.body, sum(A_W, arm), C, T(0), in);
  }
}

template <class T>
inline void balance_group(const RprDyad& dyad, const ChainSupports& supports, const ChainBalance<T>& in) {
  const ChainBody<T>& link = in.bodies[dyad.link];
  const ChainWrench<T>& on_link = in.wrenches[dyad.link];
  const Rotation<T> line = link.R_WB * all_lanes<T>(dyad.line.u_B);
  const Vector2<T> u(line.cos, line.sin);
  const Vector2<T> A = arm_of(link, dyad.pA);
  const Vector2<T> A_W = sum(link.p_WB, A);
  const Vector2<T> B_W = chain_point<ChainRates::kNone>(in.bodies[dyad.B.body], dyad.B.p_B).p_W;
  const T moment = on_link.about(A);
  T on_slider(0);
  Vector2<T> p_W = B_W;  // where the guide's force is assumed to act
  if (dyad.slider) {
    const ChainBody<T>& slider = in.bodies[dyad.slider->body];
    on_slider = in.wrenches[dyad.slider->body].about(less(B_W, slider.p_WB));
    p_W =
        chain_point<ChainRates::kNone>(in.bodies[supports.inner.second.body], supports.inner.second.p_B).p_W;
  }
  const T across = rpr_inner_force(dot(less(B_W, A_W), u), moment, on_slider);
  const Vector2<T> N = times(across, left_of(u));
  carry_by_pin(supports.outer[0], dyad.A.body, A_W, sum(on_link.force, N), in);
  if (dyad.slider) {
    const int slider = dyad.slider->body;
    const T turning = -(moment + dot(less(p_W, A_W), u) * across);
    carry(supports.inner, slider, p_W, N, turning, in);
    carry_by_pin(supports.outer[1], dyad.B.body, B_W, in.wrenches[slider].force, in);
  } else {
    carry(supports.inner, dyad.B.body, p_W, N, T(0), in);
  }
}

/// A contact that places a body on its joint. Its force acts along the normal alone; it follows from the
/// moments about the joint's pin, or from the forces along its slide.
template <class T>
inline void balance_touch(const ChainTouch& touch, const ChainSupports& supports, const ChainBalance<T>& in) {
  const ChainBody<T>& link = in.bodies[touch.link];
  const ChainBody<T>& body = in.bodies[touch.body];
  const OneFreedom& freedom = touch.freedom;
  ChainWrench<T>& wrench = in.wrenches[touch.body];
  const Vector2<T> n(link.R_WB.cos, link.R_WB.sin);
  const Vector2<T> p_W = chain_point<ChainRates::kNone>(link, Vector2d(touch.p_x, 0)).p_W;
  const Vector2<T> pin = arm_of(body, freedom.p_BO);
  const Vector2<T> pin_W = sum(body.p_WB, pin);
  const Vector2<T> along = arm_of(in.bodies[touch.carrier], freedom.direction_W);
  const T press = freedom.turns ? -wrench.about(pin) / cross(less(p_W, pin_W), n)
                                : -dot(wrench.force, along) / dot(n, along);
  in.presses[touch.contact] = press;
  const Vector2<T> N = times(press, n);
  wrench.push(N, less(p_W, body.p_WB));
  if (touch.known != kGround) {
    in.wrenches[touch.known].push(times(T(-1), N), less(p_W, in.bodies[touch.known].p_WB));
  }
  if (freedom.turns) {
    carry_by_pin(supports.outer[0], touch.carrier, pin_W, wrench.force, in);
  } else {
    carry_by_slide(supports.outer[0], touch.body, touch.carrier, along, in);
  }
}

/// Computes the reactions of all joints and contacts and the driver's effort.
template <class T>
inline void balance_chain(std::span<const ChainGroup> groups, const ChainStatics& statics, std::size_t bodies,
                          const ChainBalance<T>& in, ChainEffort<T>& effort) {
  for (std::size_t i = 0; i < bodies; ++i) {
    in.wrenches[i] = {Vector2<T>(T(0), T(0)), T(0)};
  }
  add_loads(statics.loads, in);
  effort.by_power = T(0);
  for (std::size_t i = 1; i < bodies; ++i) {
    effort.by_power = effort.by_power - (dot(in.wrenches[i].force, in.bodies[i].v_WB) +
                                         in.wrenches[i].moment * in.bodies[i].omega);
  }
  for (std::size_t g = groups.size(); g-- > 0;) {
    const ChainSupports& supports = statics.supports[g];
    if (const ChainTouch* touch = touch_of(groups[g])) {
      balance_touch(*touch, supports, in);
    } else {
      visit_links(groups[g], Overload{[&](const DrivenBody& driven) {
                                        effort.effort = balance_group(driven, supports, in);
                                      },
                                      [&](const auto& dyad) { balance_group(dyad, supports, in); }});
    }
  }
}

}  // namespace higherpair
