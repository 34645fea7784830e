#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/linkage/reach.hpp"

namespace higherpair {

/// A leg from the end of a turning arm to a straight line, in the line's frame (x along it, origin at the
/// arm's pivot):
///     arm u_arm + leg u_leg = (along, offset).
/// h = offset - arm sin φ is what the leg must bridge across the line: sin = h/leg, cos = σ√(leg² - h²)/leg.
/// Mode σ = +1: the leg's foot is ahead (+x) of the arm's end. The slider-crank is this; the inverted
/// slider-crank driven by its slot is this seen from the slot.
///
/// Its reach: stretch = leg - h, fold = leg + h, linear in sin φ = cos ψ with ψ = φ - 90°.
template <class T>
struct RrpLoop {
  T arm{0};
  T leg{0};
  CosineLine<T> stretch;
  CosineLine<T> fold;
};

template <class T>
struct RrpPosition {
  Rotation<T> u_leg;
  T along{0};  ///< where on the line the leg ends [m]
  Reach<T> reach;
};

template <class T>
struct RrpRates {
  T omega_leg{0};
  T alpha_leg{0};
  T along_dot{0};
  T along_ddot{0};
};

/// \pre arm >= 0, leg > 0; `offset` has a sign: positive on the left of the line's direction.
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
  const T inv_leg = T(1) / loop.leg;
  const Rotation<T> u_leg =
      Rotation<T>{sigma * root_of(reach) * inv_leg, T(0.5) * (reach.fold - reach.stretch) * inv_leg}
          .normalised();
  return {u_leg, loop.arm * u_arm.cos + loop.leg * u_leg.cos, reach};
}

/// With φ the arm's angle and λ the leg's:
///     leg ω_λ cos λ = -arm ω_φ cos φ,   leg α_λ cos λ = arm (ω_φ² sin φ - α_φ cos φ) + leg ω_λ² sin λ,
/// and `along` by differentiating arm cos φ + leg cos λ. Finite but meaningless where cos λ = 0.
template <class T>
[[nodiscard]] RrpRates<T> rrp_rates(const RrpLoop<T>& loop, const RrpPosition<T>& position,
                                    const Rotation<T>& u_arm, T omega_arm, T alpha_arm) {
  const Rotation<T>& u_leg = position.u_leg;
  const T inv = safe_inverse(loop.leg * u_leg.cos);
  RrpRates<T> rates;
  rates.omega_leg = -loop.arm * omega_arm * u_arm.cos * inv;
  const T pull_arm = loop.arm * omega_arm * omega_arm;
  const T pull_leg = loop.leg * rates.omega_leg * rates.omega_leg;
  rates.alpha_leg = (pull_arm * u_arm.sin - loop.arm * alpha_arm * u_arm.cos + pull_leg * u_leg.sin) * inv;
  rates.along_dot = -loop.arm * omega_arm * u_arm.sin - loop.leg * rates.omega_leg * u_leg.sin;
  rates.along_ddot = -loop.arm * alpha_arm * u_arm.sin - pull_arm * u_arm.cos -
                     loop.leg * rates.alpha_leg * u_leg.sin - pull_leg * u_leg.cos;
  return rates;
}

}  // namespace higherpair
