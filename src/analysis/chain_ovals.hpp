#pragma once

#include "chain_kernel.hpp"
#include "higherpair/contact/step_agreement.hpp"
#include "numeric/pack.hpp"
#include "tolerances.hpp"

#include <array>
#include <cmath>
#include <cstddef>

// The contact of two ovals in many rows at once.
//
// All rows of a block start from the row before it, by its rates, and are then led to their contacts together
// by Newton's method on gap and slip, the follower to second order (see last_step in contact/), until the
// last one has arrived. Then each is held against the row before by the tests that a Run makes of its steps,
// so that what has come to another contact, or over a limit, is seen.

namespace higherpair {

/// The row before the rows of a block; rates for a unit velocity of the driver.
struct OvalRow {
  double position = 0;               ///< of the driver
  Rotation<double> turn;             ///< of a turning body
  double slide = 0;                  ///< of a sliding one: its coordinate [m]
  Vector2d n_W = Vector2d::UnitX();  ///< normal out of the known body
  double rate = 0;                   ///< of the body's coordinate
  double second_rate = 0;
  double phi_dot = 0;   ///< of the normal
  double phi_ddot = 0;  ///< roughly
  double gap_q = 0;     ///< ∂gap/∂q
  double gap_q_rate = 0;
};

namespace chain_ovals {

inline constexpr int kMostPasses = 10;
// Of the size: a gap from which the next pass leads to rounding, with the curvature known as well as that.
inline constexpr double kArrived = 1e-12;
inline constexpr double kFarthestGuess = 0.4;  // [rad] a pass may turn body or normal
// |∂gap/∂q| of the arm of the contact, below which it is near a limit.
inline constexpr double kLeastSine = 0.02;

template <class T>
[[nodiscard]] inline T dot(const Vector2<T>& a, const Vector2<T>& b) {
  return a.x() * b.x() + a.y() * b.y();
}
template <class T>
[[nodiscard]] inline Vector2<T> left_of(const Vector2<T>& v) {
  return Vector2<T>(-v.y(), v.x());
}
template <class T>
[[nodiscard]] inline Vector2<T> sum(const Vector2<T>& a, const Vector2<T>& b) {
  return Vector2<T>(a.x() + b.x(), a.y() + b.y());
}
template <class T>
[[nodiscard]] inline Vector2<T> less(const Vector2<T>& a, const Vector2<T>& b) {
  return Vector2<T>(a.x() - b.x(), a.y() - b.y());
}
template <class T>
[[nodiscard]] inline Vector2<T> times(const T& factor, const Vector2<T>& v) {
  return Vector2<T>(factor * v.x(), factor * v.y());
}

// The rotation by a small angle, which passes on the way may be wrong about, but not its being one.
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

// The arcsine, to 2e-5 of it for angles below 30°.
template <class T>
[[nodiscard]] inline T small_angle(const T& sine) {
  const T x = sine * sine;
  return sine * (T(1) + x * (T(1 / 6.0) + x * (T(3 / 40.0) + x * (T(15 / 336.0) + x * T(105 / 3456.0)))));
}

template <class T>
struct Boundary {
  Vector2<T> from_center;
  T rho;
};

// The point with the outward normal n, (a² N_x, b² N_y)/h with h = √(a² N_x² + b² N_y²), ρ = a² b²/h³ for N
// in the axes. A point has no size.
template <class T>
[[nodiscard]] inline Boundary<T> boundary_at(const Oval& oval, const Rotation<T>& axis, const Vector2<T>& n) {
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

/// The known oval, which stays in all passes.
template <class T>
struct Frame {
  Vector2<T> center;  ///< from the joint
  Rotation<T> axis;
};

/// Where a pass looks.
template <class T>
struct Guess {
  Rotation<T> turn;  ///< of the body, if it turns
  T slide{0};        ///< of its coordinate, if it slides
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
  const Boundary<T> first = boundary_at(contact.on_known, frame.axis, n);
  const Boundary<T> second =
      boundary_at(contact.on_body, R * all_lanes<T>(contact.on_body.axis_B), Vector2<T>(-n.x(), -n.y()));
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

// n·v2, v2 the velocity of the body's point for a unit rate of its coordinate; and t·v2.
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

// What a pass may turn.
template <class T>
[[nodiscard]] inline T limited(const T& angle) {
  return select(abs(angle) <= T(kFarthestGuess), angle, copysign(T(kFarthestGuess), angle));
}

/// The step of last_step (contact/last_step.hpp): δ of the body, φ of the normal.
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
  // The centre of curvature as a point of the known body, from its origin.
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

/// The numbers of the rows of a block, and before them those of the row before.
template <std::size_t kRows>
struct Numbers {
  using Column = std::array<double, kRows + 1>;
  Column position, turn_cos, turn_sin, slide, n_x, n_y, rate, second_rate, phi_dot, gap_q, gap_q_rate;

  void begin(const OvalRow& row) {
    position[0] = row.position;
    turn_cos[0] = row.turn.cos;
    turn_sin[0] = row.turn.sin;
    slide[0] = row.slide;
    n_x[0] = row.n_W.x();
    n_y[0] = row.n_W.y();
    rate[0] = row.rate;
    second_rate[0] = row.second_rate;
    phi_dot[0] = row.phi_dot;
    gap_q[0] = row.gap_q;
    gap_q_rate[0] = row.gap_q_rate;
  }

  [[nodiscard]] OvalRow last() const {
    constexpr std::size_t k = kRows;
    const double way = position[k] - position[k - 1];
    const double phi_ddot = way != 0 ? (phi_dot[k] - phi_dot[k - 1]) / way : 0;
    return {position[k], {turn_cos[k], turn_sin[k]},
            slide[k],    Vector2d(n_x[k], n_y[k]),
            rate[k],     second_rate[k],
            phi_dot[k],  phi_ddot,
            gap_q[k],    gap_q_rate[k]};
  }
};

/// Whether rows continue those before them; `at` the first one's place in the columns.
template <class T, std::size_t kRows>
[[nodiscard]] inline auto goes_on(const Numbers<kRows>& of, std::size_t at, bool turns, double size) {
  const auto now = [&](const auto& column) { return T::load(&column[at]); };
  const auto before = [&](const auto& column) { return T::load(&column[at - 1]); };
  const auto turned = [&](const auto& cosine, const auto& sine) {
    return Rotation<T>{now(cosine), now(sine)} * Rotation<T>{before(cosine), before(sine)}.inverse();
  };
  const T h = now(of.position) - before(of.position);
  const T step = abs(h);
  const T half = T(0.5) * h;
  const Rotation<T> normal = turned(of.n_x, of.n_y);
  const Rotation<T> body = turns ? turned(of.turn_cos, of.turn_sin) : Rotation<T>{T(1), T(0)};
  const T scale = T(turns ? 1 : 1 / size);
  const T rise = turns ? small_angle(body.sin) : scale * (now(of.slide) - before(of.slide));
  const T v0 = scale * before(of.rate), v1 = scale * now(of.rate);
  const T a0 = scale * before(of.second_rate), a1 = scale * now(of.second_rate);
  const T bend = v1 - v0;
  const T phi = small_angle(normal.sin);
  const T mismatch = abs(rise - half * (v0 + v1) + h * h * T(1 / 12.0) * (a1 - a0)) +
                     step * abs(bend - half * (a0 + a1)) +
                     abs(phi - half * (before(of.phi_dot) + now(of.phi_dot)));
  const T change = abs(rise) + abs(phi) + T(0.125) * step * abs(bend);
  // ∂gap/∂q, which is 0 at a limit, keeps away from it between the two rows as well.
  const T g0 = before(of.gap_q), g1 = now(of.gap_q);
  const T least = -max(-abs(g0), -abs(g1));
  const T fastest = max(abs(before(of.gap_q_rate)), abs(now(of.gap_q_rate)));
  return (mismatch <= T(kSmoothStep) * change + T(kNoMismatch)) & (normal.cos >= T(kCosFarthestTurn)) &
         (body.cos >= T(kCosFarthestTurn)) & (g0 * g1 > T(0)) & (T(2) * step * fastest <= least);
}

}  // namespace chain_ovals

/// The contact in kPacks packs of consecutive rows.
/// \param before  the row before them; the result: their last one
/// \param bodies  of the first pack; those of the next ones `stride` further each
template <int W, std::size_t kPacks>
inline void solve_ovals(const OvalContact& contact, const std::array<ChainDriver<Pack<W>>, kPacks>& driver,
                        double size, OvalRow& before, ChainBody<Pack<W>>* bodies, std::size_t stride,
                        ChainWatch<Pack<W>>& watch) {
  using namespace chain_ovals;
  using T = Pack<W>;
  constexpr ChainRates kAll = ChainRates::kAccelerations;
  const OneFreedom& freedom = contact.touch.freedom;
  std::array<ChainPoint<T>, kPacks> joint;
  std::array<Frame<T>, kPacks> frame;
  std::array<Guess<T>, kPacks> guess;
  std::array<Touch<T>, kPacks> touch;
  for (std::size_t i = 0; i < kPacks; ++i) {
    const ChainBody<T>* pack = bodies + i * stride;
    const ChainBody<T>& known = pack[contact.known];
    joint[i] = chain_point<kAll>(pack[contact.touch.carrier], freedom.p_WO);
    const ChainPoint<T> center = chain_point<ChainRates::kNone>(known, contact.on_known.center_B);
    frame[i] = {less(center.p_W, joint[i].p_W), known.R_WB * all_lanes<T>(contact.on_known.axis_B)};
    const T h = driver[i].position - T(before.position);
    const T way = h * (T(before.rate) + T(0.5) * h * T(before.second_rate));
    const T turn = h * (T(before.phi_dot) + T(0.5) * h * T(before.phi_ddot));
    guess[i].turn = renewed(renewed(all_lanes<T>(before.turn) * small_turn(way)));
    guess[i].slide = T(before.slide) + way;
    guess[i].n = renewed(renewed(Rotation<T>{T(before.n_W.x()), T(before.n_W.y())} * small_turn(turn)));
  }
  // Rows that have arrived go on without harm: their passes do nothing.
  bool arrived = false;
  for (int pass = 0; pass < kMostPasses && !arrived; ++pass) {
    arrived = true;
    for (std::size_t i = 0; i < kPacks; ++i) {
      touch[i] = touch_at(contact, frame[i], guess[i]);
      arrived = arrived && holds_everywhere(abs(touch[i].g) + abs(touch[i].s) <= T(kArrived * size));
      take_pass(contact, touch[i], guess[i]);
    }
  }
  Numbers<kPacks * W> numbers;
  numbers.begin(before);
  for (std::size_t i = 0; i < kPacks; ++i) {
    ChainBody<T>* pack = bodies + i * stride;
    const Rates<T> rates = rates_at(contact, touch[i], guess[i].normal(), joint[i], pack[contact.known]);
    ChainBody<T>& body = pack[contact.touch.body];
    if (freedom.turns) {
      body.R_WB = guess[i].turn;
      body.omega = rates.rate;
      body.alpha = rates.second_rate;
      hang<kAll>(body, joint[i], freedom.p_BO);
    } else {
      const Vector2<T> along = all_lanes<T>(freedom.direction_W);
      body.R_WB = all_lanes<T>(freedom.R_WB);
      body.omega = body.alpha = T(0);
      hang<kAll>(body,
                 {sum(joint[i].p_W, times(guess[i].slide, along)), times(rates.rate, along),
                  times(rates.second_rate, along)},
                 freedom.p_BO);
    }
    ChainBody<T>& link = pack[contact.touch.link];
    link.R_WB = guess[i].n;
    link.p_WB = sum(joint[i].p_W, touch[i].p1);
    const std::size_t at = 1 + i * W;
    driver[i].position.store(&numbers.position[at]);
    guess[i].turn.cos.store(&numbers.turn_cos[at]);
    guess[i].turn.sin.store(&numbers.turn_sin[at]);
    guess[i].slide.store(&numbers.slide[at]);
    guess[i].n.cos.store(&numbers.n_x[at]);
    guess[i].n.sin.store(&numbers.n_y[at]);
    rates.rate.store(&numbers.rate[at]);
    rates.second_rate.store(&numbers.second_rate[at]);
    rates.phi_dot.store(&numbers.phi_dot[at]);
    rates.gap_q.store(&numbers.gap_q[at]);
    rates.gap_q_rate.store(&numbers.gap_q_rate[at]);
    const T least = abs(rates.gap_q);
    watch.far2 = max(watch.far2, rates.arm2);
    const auto sound = (least * least >= T(kLeastSine * kLeastSine) * rates.arm2) &
                       (goes_on<T>(numbers, at, freedom.turns, size));
    watch.note(arrived ? select(sound, -least, T(INFINITY)) : T(INFINITY));
  }
  before = numbers.last();
}

}  // namespace higherpair
