#pragma once

#include "analysis/tolerances.hpp"
#include "chain_kernel.hpp"
#include "chain_vectors.hpp"

// Two ovals that touch, or nearly so, at several positions at once (T = Pack): one pass of Newton's method
// towards their contact, and the rates there.

namespace higherpair::chain_ovals {

// The rotation by a small angle. The angle may be inexact, as passes iterate, but the result must be a
// rotation.
template <class T>
[[nodiscard]] inline Rotation<T> small_turn(const T& angle) {
  const T x = angle * angle;
  const T c = T(1) - x * (T(0.5) - x * T(1 / 24.0));
  const T s = angle * (T(1) - x * (T(1 / 6.0) - x * T(1 / 120.0)));
  const T scale = T(1.5) - T(0.5) * (c * c + s * s);
  return {c * scale, s * scale};
}

template <class T>
[[nodiscard]] inline Rotation<T> renewed(const Rotation<T>& R) {
  const T scale = T(1.5) - T(0.5) * (R.cos * R.cos + R.sin * R.sin);
  return {R.cos * scale, R.sin * scale};
}

template <class T>
struct OvalPoint {
  Vector2<T> from_center;
  T rho;
};

// The point of an oval with the outward normal n, from its centre: (a² N_x, b² N_y)/h with h = √(a² N_x² + b²
// N_y²), where N is n in the oval's axes; its radius of curvature is ρ = a² b²/h³. A point has size 0.
template <class T>
[[nodiscard]] inline OvalPoint<T> oval_point(const Oval& oval, const Rotation<T>& axis, const Vector2<T>& n) {
  if (oval.along == 0) {
    return {Vector2<T>(T(0), T(0)), T(0)};
  }
  const double aa = oval.along * oval.along;
  const double bb = oval.across * oval.across;
  const Vector2<T> N = axis.inverse() * n;
  const T x = T(aa) * N.x();
  const T y = T(bb) * N.y();
  const T per_h = T(1) / sqrt(x * N.x() + y * N.y());
  return {axis * Vector2<T>(x * per_h, y * per_h), T(aa * bb) * (per_h * per_h * per_h)};
}

/// The known oval, which is the same in all passes.
template <class T>
struct Frame {
  Vector2<T> center;  ///< from the joint
  Rotation<T> axis;
};

/// The position that a pass starts from.
template <class T>
struct Guess {
  Rotation<T> turn;  ///< rotation of the body, if it turns
  T slide{0};        ///< its coordinate, if it slides
  Rotation<T> n;     ///< the normal as (n_x, n_y)

  [[nodiscard]] Vector2<T> normal() const { return Vector2<T>(n.cos, n.sin); }
};

template <class T>
struct Touch {
  Vector2<T> p1, p2;  ///< from the joint
  T rho1, rho2;
  T g, s;
};

template <class T>
[[nodiscard]] inline Touch<T> touch_at(const OvalContact& contact, const Frame<T>& frame,
                                       const Guess<T>& guess) {
  const OneFreedom& freedom = contact.touch.freedom;
  const Vector2<T> n = guess.normal();
  const Rotation<T> R = freedom.turns ? guess.turn : all_lanes<T>(freedom.R_WB);
  const OvalPoint<T> first = oval_point(contact.on_known, frame.axis, n);
  const OvalPoint<T> second =
      oval_point(contact.on_body, R * all_lanes<T>(contact.on_body.axis_B), Vector2<T>(-n.x(), -n.y()));
  Touch<T> touch;
  touch.p1 = sum(frame.center, first.from_center);
  touch.p2 = sum(R * all_lanes<T>(Vector2d(contact.on_body.center_B - freedom.p_BO)), second.from_center);
  if (!freedom.turns) {
    touch.p2 = sum(touch.p2, times(guess.slide, all_lanes<T>(freedom.direction_W)));
  }
  touch.rho1 = first.rho;
  touch.rho2 = second.rho;
  const Vector2<T> apart = less(touch.p2, touch.p1);
  touch.g = dot(apart, n);
  touch.s = cross(n, apart);
  return touch;
}

// Components n·v2 and t·v2 of the velocity v2 of the body's point for a unit rate of its coordinate.
template <class T>
struct Lever {
  T gap_q, along;
};
template <class T>
[[nodiscard]] inline Lever<T> lever_of(const OneFreedom& freedom, const Vector2<T>& point,
                                       const Vector2<T>& n) {
  const Vector2<T> v = freedom.turns ? left_of(point) : all_lanes<T>(freedom.direction_W);
  return {dot(v, n), cross(n, v)};
}

// Limits the turn of one pass.
template <class T>
[[nodiscard]] inline T limited(const T& angle) {
  return select(abs(angle) <= T(kFarthestOvalGuess), angle, copysign(T(kFarthestOvalGuess), angle));
}

/// The step of last_step (contact/last_step.hpp): δ of the body's coordinate, φ of the normal.
template <class T>
inline void take_pass(const OvalContact& contact, const Touch<T>& touch, Guess<T>& guess) {
  const bool turns = contact.touch.freedom.turns;
  const Vector2<T> n = guess.normal();
  const Lever<T> lever = lever_of(contact.touch.freedom, touch.p2, n);
  const T w = T(1) / (touch.rho1 + touch.rho2);
  const T P = turns ? lever.along + touch.rho2 : lever.along;
  const T M = turns ? lever.along - touch.rho1 : lever.along;
  const T slope = lever.gap_q + (w * (P + M) + T(turns ? 1 : 0)) * touch.s * T(0.5);
  const T per_slope = T(1) / slope;
  const T first = -(touch.g + T(0.5) * w * touch.s * touch.s) * per_slope;
  const T delta = first - T(0.5) * w * P * M * per_slope * first * first;
  const T phi = w * (touch.s + delta * P);
  if (turns) {
    guess.turn = renewed(guess.turn * small_turn(limited(delta)));
  } else {
    guess.slide = guess.slide + delta;
  }
  guess.n = renewed(guess.n * small_turn(limited(phi)));
}

/// Rates for a unit velocity of the driver, by the equivalent linkage.
template <class T>
struct Rates {
  T rate, second_rate, phi_dot, gap_q, gap_q_rate, arm2;
};

template <class T>
[[nodiscard]] inline Rates<T> rates_at(const OvalContact& contact, const Touch<T>& touch, const Vector2<T>& n,
                                       const ChainPoint<T>& joint, const ChainBody<T>& known) {
  // The known body's centre of curvature, relative to the body's origin.
  const Vector2<T> r1 = less(sum(joint.p_W, less(touch.p1, times(touch.rho1, n))), known.p_WB);
  const Vector2<T> r2 = sum(touch.p2, times(touch.rho2, n));
  const T square = known.omega * known.omega;
  const Vector2<T> v = less(sum(known.v_WB, times(known.omega, left_of(r1))), joint.v_W);
  const Vector2<T> a =
      less(sum(known.a_WB, less(times(known.alpha, left_of(r1)), times(square, r1))), joint.a_W);
  const T length = touch.rho1 + touch.rho2;
  const Lever<T> lever = lever_of(contact.touch.freedom, r2, n);
  Rates<T> rates;
  rates.gap_q = lever.gap_q;
  const T per_gap_q = T(1) / lever.gap_q;
  rates.rate = dot(n, v) * per_gap_q;
  rates.phi_dot = (rates.rate * lever.along - cross(n, v)) / length;
  const T pull = length * rates.phi_dot * rates.phi_dot;
  if (contact.touch.freedom.turns) {
    const T out = dot(n, r2);
    rates.second_rate = (dot(n, a) + rates.rate * rates.rate * out - pull) * per_gap_q;
    rates.gap_q_rate = (rates.phi_dot - rates.rate) * out;
    rates.arm2 = dot(r2, r2);
  } else {
    rates.second_rate = (dot(n, a) - pull) * per_gap_q;
    rates.gap_q_rate = rates.phi_dot * lever.along;
    rates.arm2 = T(1);
  }
  return rates;
}

/// Places the body at the guess and the contact's link at the contact.
template <class T>
inline void place_bodies(const OvalContact& contact, const Guess<T>& guess, const Touch<T>& touch,
                         const Rates<T>& rates, const ChainPoint<T>& joint, ChainBody<T>* bodies) {
  constexpr ChainRates kAll = ChainRates::kAccelerations;
  const OneFreedom& freedom = contact.touch.freedom;
  ChainBody<T>& body = bodies[contact.touch.body];
  if (freedom.turns) {
    body.R_WB = guess.turn;
    body.omega = rates.rate;
    body.alpha = rates.second_rate;
    attach<kAll>(body, joint, freedom.p_BO);
  } else {
    const Vector2<T> along = all_lanes<T>(freedom.direction_W);
    body.R_WB = all_lanes<T>(freedom.R_WB);
    body.omega = body.alpha = T(0);
    attach<kAll>(body,
                 {sum(joint.p_W, times(guess.slide, along)), times(rates.rate, along),
                  times(rates.second_rate, along)},
                 freedom.p_BO);
  }
  ChainBody<T>& link = bodies[contact.touch.link];
  link.R_WB = guess.n;
  link.p_WB = sum(joint.p_W, touch.p1);
}

}  // namespace higherpair::chain_ovals
