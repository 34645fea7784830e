#pragma once

#include "chain_kernel.hpp"
#include "chain_loads.hpp"
#include "chain_vectors.hpp"
#include "higherpair/mechanism/description.hpp"

// Loads on the bodies of a chain, including the inertia of its motion, at one position (T = double) or at
// several at once (T = Pack).

namespace higherpair {

/// The driver's velocity and acceleration, which scale rates for a unit velocity to actual ones.
template <class T>
struct DriverRates {
  T velocity, acceleration;

  [[nodiscard]] T first(const T& unit) const { return velocity * unit; }
  [[nodiscard]] T second(const T& unit_first, const T& unit_second) const {
    return velocity * velocity * unit_second + acceleration * unit_first;
  }
};

/// The resultant load on a body: a force, and its moment about the origin of the body's frame, in ground.
template <class T>
struct ChainWrench {
  Vector2<T> force;
  T moment;

  /// Adds a force that acts at r, measured from the origin.
  void push(const Vector2<T>& more, const Vector2<T>& r) {
    force = sum(force, more);
    moment = moment + cross(r, more);
  }
  /// The moment about the point at r, measured from the origin.
  [[nodiscard]] T about(const Vector2<T>& r) const { return moment - cross(r, force); }
};

/// What a joint exerts on its second body, as in JointReaction.
template <class T>
struct ChainReaction {
  Vector2<T> force;
  T moment;
};

/// The angle of a body.
/// \param turned  angles of the turnings that springs need
template <class T>
[[nodiscard]] inline T angle_at(const ChainAngle& angle, const ChainDriver<T>& driver, const T* turned) {
  const T along = angle.turning < 0 ? T(angle.factor) * driver.position : turned[angle.turning];
  return along + T(angle.offset);
}

/// The state of a chain's bodies in one pack of rows, and the reactions of its joints and driver.
template <class T>
struct ChainBalance {
  ChainDriver<T> driver;
  DriverRates<T> rates;
  const ChainBody<T>* bodies;   ///< with accelerations
  ChainWrench<T>* wrenches;     ///< of the bodies; overwritten
  ChainReaction<T>* reactions;  ///< of the joints; the result
  T* presses;                   ///< normal forces of the contacts; the result
  const T* angles;              ///< of the turnings that springs need
  T* shortest;                  ///< largest negative squared length of a spring so far
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

// Pulls both points together.
template <class T>
inline void add_spring(const ChainLoads::PointSpring& spring, const ChainBalance<T>& in) {
  using std::max;
  using std::sqrt;
  const ChainBody<T>& one = in.bodies[spring.first.body];
  const ChainBody<T>& two = in.bodies[spring.second.body];
  const ChainPoint<T> p = chain_point<ChainRates::kVelocities>(one, spring.first.p_B);
  const ChainPoint<T> q = chain_point<ChainRates::kVelocities>(two, spring.second.p_B);
  const Vector2<T> apart = less(q.p_W, p.p_W);
  const T square = dot(apart, apart);
  *in.shortest = max(*in.shortest, -square);
  const T length = sqrt(square);
  const Vector2<T> u = times(safe_inverse(length), apart);
  const Vector2<T> force =
      times(tension_of(spring.tension, length, in.rates.first(dot(less(q.v_W, p.v_W), u))), u);
  in.wrenches[spring.first.body].push(force, arm_of(one, spring.first.p_B));
  in.wrenches[spring.second.body].push(times(T(-1), force), arm_of(two, spring.second.p_B));
}

// Pulls along the line, at the second point; the coordinate is that of the joint: see joint_motion().
template <class T>
inline void add_spring(const ChainLoads::LineSpring& spring, const ChainBalance<T>& in) {
  const ChainBody<T>& one = in.bodies[spring.line.body];
  const ChainBody<T>& two = in.bodies[spring.second.body];
  const ChainPoint<T> p = chain_point<ChainRates::kVelocities>(one, spring.line.p_B);
  const ChainPoint<T> q = chain_point<ChainRates::kVelocities>(two, spring.second.p_B);
  const Rotation<T> line = one.R_WB * all_lanes<T>(spring.line.u_B);
  const Vector2<T> u(line.cos, line.sin);
  const Vector2<T> apart = less(q.p_W, p.p_W);
  const T rate = dot(less(q.v_W, p.v_W), u) + one.omega * dot(apart, left_of(u));
  const Vector2<T> force = times(tension_of(spring.tension, dot(apart, u), in.rates.first(rate)), u);
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

template <class T>
inline void add_spring(const ChainLoads::PinSpring& spring, const ChainBalance<T>& in) {
  const T angle =
      angle_at(spring.second, in.driver, in.angles) - angle_at(spring.first, in.driver, in.angles);
  const T rate = in.bodies[spring.on.second].omega - in.bodies[spring.on.first].omega;
  turn(spring.on, tension_of(spring.on.tension, angle, in.rates.first(rate)), in);
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

}  // namespace higherpair
