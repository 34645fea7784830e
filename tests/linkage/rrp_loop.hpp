#pragma once

#include "higherpair/linkage/rrp_dyad.hpp"

namespace higherpair {

/// A link from a line to the end A of an arm that turns about a point beside the line.
///     arm u_arm + leg u_leg = (along, offset).
/// This is the slider-crank, and the inverted slider-crank driven by its slot as seen from the slot. The
/// reach is linear in sin φ = cos ψ, where φ is the arm's angle and ψ = φ - 90°.
template <class T>
struct RrpLoop {
  T arm{0};
  T leg{0};
  CosineLine<T> stretch;
  CosineLine<T> fold;
};

/// \pre arm >= 0, leg > 0; `offset` is signed: positive on the left of the line's direction.
template <class T>
[[nodiscard]] RrpLoop<T> make_rrp_loop(T arm, T leg, T offset) {
  const T none(0);
  return {arm,
          leg,
          {balance(leg, -offset, arm, none), balance(leg, -offset, none, none),
           balance(leg, -offset, -arm, none), -arm},
          {balance(leg, offset, -arm, none), balance(leg, offset, none, none),
           balance(leg, offset, arm, none), arm}};
}

template <class T>
[[nodiscard]] RrpPosition<T> rrp_position(const RrpLoop<T>& loop, const Rotation<T>& u_arm, T sigma) {
  const Reach<T> reach = reach_at(loop.stretch, loop.fold, Rotation<T>{u_arm.sin, u_arm.cos});
  return rrp_position(T(loop.arm * u_arm.cos), loop.leg, reach, sigma);
}

template <class T>
[[nodiscard]] RrpRates<T> rrp_rates(const RrpLoop<T>& loop, const RrpPosition<T>& position,
                                    const Rotation<T>& u_arm, T omega_arm, T alpha_arm) {
  const T v = loop.arm * omega_arm;
  const T a_t = loop.arm * alpha_arm;
  const T a_n = v * omega_arm;
  return rrp_rates(position, loop.leg, Vector2<T>(-v * u_arm.sin, v * u_arm.cos),
                   Vector2<T>(-a_t * u_arm.sin - a_n * u_arm.cos, a_t * u_arm.cos - a_n * u_arm.sin));
}

}  // namespace higherpair
