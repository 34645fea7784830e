#pragma once

#include "analysis/tolerances.hpp"
#include "chain_oval_contact.hpp"
#include "higherpair/contact/step_agreement.hpp"
#include "numeric/pack.hpp"

#include <array>
#include <cmath>
#include <cstddef>

// Follows a contact of ovals from row to row: predicts each row and checks that the solution there continues
// the same branch.

namespace higherpair {

/// The row that precedes a block of rows; rates are for a unit velocity of the driver.
struct OvalRow {
  double position = 0;               ///< of the driver
  Rotation<double> turn;             ///< rotation of a turning body
  double slide = 0;                  ///< coordinate of a sliding body [m]
  Vector2d n_W = Vector2d::UnitX();  ///< normal out of the known body
  double rate = 0;                   ///< of the body's coordinate
  double second_rate = 0;
  double third_rate = 0;  ///< roughly
  double phi_dot = 0;     ///< turning rate of the normal
  double phi_ddot = 0;    ///< approximate, as the next one
  double phi_third = 0;
  double gap_q = 0;  ///< ∂gap/∂q
  double gap_q_rate = 0;
};

namespace chain_ovals {

// The arcsine, with a relative error of 2e-5 for angles below 30°.
template <class T>
[[nodiscard]] inline T small_angle(const T& sine) {
  const T x = sine * sine;
  return sine * (T(1) + x * (T(1 / 6.0) + x * (T(3 / 40.0) + x * (T(15 / 336.0) + x * T(105 / 3456.0)))));
}

/// The numbers of the rows of a block, preceded by those of the row before it.
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

  template <class T>
  void put(std::size_t at, const T& driver, const Guess<T>& guess, const Rates<T>& rates) {
    driver.store(&position[at]);
    guess.turn.cos.store(&turn_cos[at]);
    guess.turn.sin.store(&turn_sin[at]);
    guess.slide.store(&slide[at]);
    guess.n.cos.store(&n_x[at]);
    guess.n.sin.store(&n_y[at]);
    rates.rate.store(&rate[at]);
    rates.second_rate.store(&second_rate[at]);
    rates.phi_dot.store(&phi_dot[at]);
    rates.gap_q.store(&gap_q[at]);
    rates.gap_q_rate.store(&gap_q_rate[at]);
  }

  [[nodiscard]] OvalRow last() const {
    constexpr std::size_t k = kRows;
    OvalRow row;
    row.position = position[k];
    row.turn = {turn_cos[k], turn_sin[k]};
    row.slide = slide[k];
    row.n_W = Vector2d(n_x[k], n_y[k]);
    row.rate = rate[k];
    row.second_rate = second_rate[k];
    row.phi_dot = phi_dot[k];
    row.gap_q = gap_q[k];
    row.gap_q_rate = gap_q_rate[k];
    const double step = position[k] - position[k - 1];
    const double uneven = step - (position[k - 1] - position[k - 2]);
    if (step != 0) {
      row.phi_ddot = (phi_dot[k] - phi_dot[k - 1]) / step;
    }
    if (step != 0 && std::abs(uneven) <= kUnevenRows * std::abs(step)) {
      row.third_rate = (second_rate[k] - second_rate[k - 1]) / step;
      row.phi_third = (phi_dot[k] - 2 * phi_dot[k - 1] + phi_dot[k - 2]) / (step * step);
      row.phi_ddot += step / 2 * row.phi_third;
    }
    return row;
  }
};

/// Whether rows continue those before them; `at` is the index of the first one in the columns.
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
  // ∂gap/∂q, which is 0 at a limit, must stay away from 0 between the two rows as well.
  const T g0 = before(of.gap_q), g1 = now(of.gap_q);
  const T least = -max(-abs(g0), -abs(g1));
  const T fastest = max(abs(before(of.gap_q_rate)), abs(now(of.gap_q_rate)));
  return (mismatch <= T(kSmoothStep) * change + T(kNoMismatch)) & (normal.cos >= T(kCosFarthestTurn)) &
         (body.cos >= T(kCosFarthestTurn)) & (g0 * g1 > T(0)) & (T(2) * step * fastest <= least);
}

// Extrapolates from the rates of the row before.
template <class T>
[[nodiscard]] inline Guess<T> predicted(const OvalRow& from, const T& position) {
  const T h = position - T(from.position);
  const T travel = h * (T(from.rate) + T(0.5) * h * (T(from.second_rate) + h * T(from.third_rate / 3)));
  const T turn = h * (T(from.phi_dot) + T(0.5) * h * (T(from.phi_ddot) + h * T(from.phi_third / 3)));
  const Rotation<T> n{T(from.n_W.x()), T(from.n_W.y())};
  return {renewed(renewed(all_lanes<T>(from.turn) * small_turn(travel))), T(from.slide) + travel,
          renewed(renewed(n * small_turn(turn)))};
}

}  // namespace chain_ovals
}  // namespace higherpair
