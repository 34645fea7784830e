#pragma once

#include "chain_kernel.hpp"
#include "chain_loads.hpp"
#include "chain_vectors.hpp"
#include "higherpair/linkage/dyad_statics.hpp"
#include "higherpair/mechanism/build.hpp"
#include "numeric/arctangent.hpp"

#include <limits>

// Inverse dynamics of a chain on one position (T = double) or on several at once (T = Pack): what acts on
// every body, with the inertia of its motion, is carried group by group from the end of the chain to its
// driver, in closed form. The equations are those of dynamics/statics.hpp, which factorises matrices instead.

namespace higherpair {

/// The driver's velocity and acceleration: rates are those for a unit velocity times these.
template <class T>
struct DriverRates {
  T velocity, acceleration;

  [[nodiscard]] T first(const T& unit) const { return velocity * unit; }
  [[nodiscard]] T second(const T& unit_first, const T& unit_second) const {
    return velocity * velocity * unit_second + acceleration * unit_first;
  }
};

/// What acts on a body: a force, and its moment about the origin of the body's frame, in ground.
template <class T>
struct ChainWrench {
  Vector2<T> force;
  T moment;

  /// Adds a force that acts at r from the origin.
  void push(const Vector2<T>& more, const Vector2<T>& r) {
    force = sum(force, more);
    moment = moment + cross(r, more);
  }
  /// The moment about the point at r from the origin.
  [[nodiscard]] T about(const Vector2<T>& r) const { return moment - cross(r, force); }
};

/// What a joint does to its second body, as JointReaction has it.
template <class T>
struct ChainReaction {
  Vector2<T> force;
  T moment;
};

/// What drives, as DriverEffort has it.
template <class T>
struct ChainEffort {
  T effort;
  T by_power;
};

/// How far springs go in all rows.
template <class T>
struct ChainReach {
  T shortest{-std::numeric_limits<double>::infinity()};  ///< largest of the negative squared lengths
  T widest{0};                                           ///< largest angle of a pin from that in the poses
};

/// The state of a chain's bodies in one pack of rows, and what its joints and driver do.
template <class T>
struct ChainBalance {
  const ChainBody<T>* bodies;  ///< with accelerations
  ChainDriver<T> driver;
  DriverRates<T> rates;
  ChainWrench<T>* wrenches;     ///< of the bodies; used up
  ChainReaction<T>* reactions;  ///< of the joints: the result
  T* presses;                   ///< of the contacts: how hard each presses; the result
  ChainReach<T>* reach;         ///< of springs so far
};

template <class T>
[[nodiscard]] inline Vector2<T> arm_of(const ChainBody<T>& body, const Vector2d& p_B) {
  return body.R_WB * all_lanes<T>(p_B);
}

template <class T>
[[nodiscard]] inline T tension_of(const ChainLoads::Tension& of, const T& x, const T& rate) {
  return T(of.stiffness) * (x - T(of.free)) + T(of.damping) * rate;
}

// Weight and inertia: m (g - a_G) at the centre of mass, and -I α.
template <class T>
inline void add_mass(const ChainLoads::Mass& mass, const Vector2d& gravity_W, const ChainBalance<T>& in) {
  const ChainBody<T>& body = in.bodies[mass.body];
  const ChainPoint<T> G = chain_point<ChainRates::kAccelerations>(body, mass.of.center_of_mass_B);
  const T m(mass.of.mass);
  const Vector2<T> force(m * (T(gravity_W.x()) - in.rates.second(G.v_W.x(), G.a_W.x())),
                         m * (T(gravity_W.y()) - in.rates.second(G.v_W.y(), G.a_W.y())));
  ChainWrench<T>& wrench = in.wrenches[mass.body];
  wrench.push(force, arm_of(body, mass.of.center_of_mass_B));
  wrench.moment = wrench.moment - T(mass.of.inertia) * in.rates.second(body.omega, body.alpha);
}

template <class T>
inline void add_force(const ChainLoads::Force& load, const ChainBalance<T>& in) {
  const ChainBody<T>& body = in.bodies[load.at.body];
  ChainWrench<T>& wrench = in.wrenches[load.at.body];
  wrench.push(load.turns_along ? arm_of(body, load.force) : all_lanes<T>(load.force),
              arm_of(body, load.at.p_B));
  wrench.moment = wrench.moment + T(load.torque);
}

// Draws both points together.
template <class T>
inline void add_spring(const ChainLoads::PointSpring& spring, const ChainBalance<T>& in) {
  using std::max;
  using std::sqrt;
  const ChainBody<T>& one = in.bodies[spring.first.body];
  const ChainBody<T>& two = in.bodies[spring.second.body];
  const ChainPoint<T> p = chain_point<ChainRates::kVelocities>(one, spring.first.p_B);
  const ChainPoint<T> q = chain_point<ChainRates::kVelocities>(two, spring.second.p_B);
  const Vector2<T> way = less(q.p_W, p.p_W);
  const T square = dot(way, way);
  in.reach->shortest = max(in.reach->shortest, -square);
  const T length = sqrt(square);
  const Vector2<T> u = times(safe_inverse(length), way);
  const Vector2<T> force =
      times(tension_of(spring.tension, length, in.rates.first(dot(less(q.v_W, p.v_W), u))), u);
  in.wrenches[spring.first.body].push(force, arm_of(one, spring.first.p_B));
  in.wrenches[spring.second.body].push(times(T(-1), force), arm_of(two, spring.second.p_B));
}

// Along the line, at the second point, as the coordinate of its joint: see joint_motion().
template <class T>
inline void add_spring(const ChainLoads::LineSpring& spring, const ChainBalance<T>& in) {
  const ChainBody<T>& one = in.bodies[spring.line.body];
  const ChainBody<T>& two = in.bodies[spring.second.body];
  const ChainPoint<T> p = chain_point<ChainRates::kVelocities>(one, spring.line.p_B);
  const ChainPoint<T> q = chain_point<ChainRates::kVelocities>(two, spring.second.p_B);
  const Rotation<T> line = one.R_WB * all_lanes<T>(spring.line.u_B);
  const Vector2<T> u(line.cos, line.sin);
  const Vector2<T> way = less(q.p_W, p.p_W);
  const T rate = dot(less(q.v_W, p.v_W), u) + one.omega * dot(way, left_of(u));
  const Vector2<T> force = times(tension_of(spring.tension, dot(way, u), in.rates.first(rate)), u);
  in.wrenches[spring.line.body].push(force, less(q.p_W, one.p_WB));
  in.wrenches[spring.second.body].push(times(T(-1), force), less(q.p_W, two.p_WB));
}

template <class T>
inline void turn(const ChainLoads::TurnSpring& spring, const T& torque, const ChainBalance<T>& in) {
  in.wrenches[spring.first].moment = in.wrenches[spring.first].moment + torque;
  in.wrenches[spring.second].moment = in.wrenches[spring.second].moment - torque;
}

template <class T>
inline void add_spring(const ChainLoads::TurnSpring& spring, const ChainBalance<T>& in) {
  turn(spring, tension_of(spring.tension, in.driver.position, in.rates.velocity), in);
}

// The angle is as far from that in the poses as the one turns from the other, if that is less than half a
// turn.
template <class T>
inline void add_spring(const ChainLoads::PinSpring& spring, const ChainBalance<T>& in) {
  using std::abs;
  using std::max;
  const ChainBody<T>& one = in.bodies[spring.on.first];
  const ChainBody<T>& two = in.bodies[spring.on.second];
  const Rotation<T> turned = two.R_WB * one.R_WB.inverse() * all_lanes<T>(spring.posed.inverse());
  const T angle = arctangent(turned.sin, turned.cos);
  in.reach->widest = max(in.reach->widest, abs(angle));
  turn(spring.on,
       tension_of(spring.on.tension, T(spring.posed_angle) + angle, in.rates.first(two.omega - one.omega)),
       in);
}

template <class T>
inline void add_loads(const ChainLoads& loads, const ChainBalance<T>& in) {
  for (const ChainLoads::Mass& mass : loads.masses) {
    add_mass(mass, loads.gravity_W, in);
  }
  for (const ChainLoads::Force& force : loads.forces) {
    add_force(force, in);
  }
  for (const ChainLoads::PointSpring& spring : loads.point_springs) {
    add_spring(spring, in);
  }
  for (const ChainLoads::LineSpring& spring : loads.line_springs) {
    add_spring(spring, in);
  }
  for (const ChainLoads::TurnSpring& spring : loads.turn_springs) {
    add_spring(spring, in);
  }
  for (const ChainLoads::PinSpring& spring : loads.pin_springs) {
    add_spring(spring, in);
  }
}

/// Notes what a joint does to the body that it holds, and passes the opposite on to its other body.
/// \param known   the other body; what acts on ground is of no interest
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

/// A pin that holds a body against all that acts on it.
template <class T>
inline void carry_by_pin(const ChainSupport& support, int known, const Vector2<T>& p_W,
                         const Vector2<T>& force, const ChainBalance<T>& in) {
  carry(support, known, p_W, Vector2<T>(-force.x(), -force.y()), T(0), in);
}

/// A slide along the unit direction u that holds a body: what presses across, and the moment about the
/// joint's second point.
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

/// The group that a driver holds: its joint, and the effort on it.
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
  Vector2<T> p_W = B_W;  // where the guide is taken to press
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

/// A contact that places a body on its joint. It presses along the normal alone, by the moment about the
/// joint's pin, or along its slide.
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

/// Works out what all joints, contacts and the driver do.
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
    } else if (const auto* rrr = std::get_if<RrrDyad>(&groups[g].kind)) {
      balance_group(*rrr, supports, in);
    } else if (const auto* rrp = std::get_if<RrpDyad>(&groups[g].kind)) {
      balance_group(*rrp, supports, in);
    } else if (const auto* rpr = std::get_if<RprDyad>(&groups[g].kind)) {
      balance_group(*rpr, supports, in);
    } else if (const auto* driven = std::get_if<DrivenBody>(&groups[g].kind)) {
      effort.effort = balance_group(*driven, supports, in);
    }
  }
}

}  // namespace higherpair
