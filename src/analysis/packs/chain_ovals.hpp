#pragma once

#include "analysis/tolerances.hpp"
#include "chain_oval_rows.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <array>
#include <cmath>
#include <cstddef>

// The contact of two ovals in many rows at once.
//
// All rows of a block are predicted from the rates of the row before it, and are then led to their contacts
// together by Newton's method on gap and slip, the follower to second order (see last_step in contact/),
// until the last one has arrived. Then each is compared with the row before by the tests that a Run applies
// to its steps, which detect that the solution has come to another contact or passed a limit.

namespace higherpair {

namespace chain_ovals {

inline constexpr int kMostPasses = 10;

}  // namespace chain_ovals

/// Solves the contact in kPacks packs of consecutive rows.
/// \param before  the row before them; replaced by their last one
/// \param bodies  of the first pack; those of each following pack are `stride` further on
template <class T, std::size_t kPacks>
inline void solve_ovals(const OvalContact& contact, const std::array<ChainDriver<T>, kPacks>& driver,
                        double size, OvalRow& before, ChainBody<T>* bodies, std::size_t stride,
                        ChainWatch<T>& watch) {
  using namespace chain_ovals;
  std::array<ChainPoint<T>, kPacks> joint;
  std::array<Frame<T>, kPacks> frame;
  std::array<Guess<T>, kPacks> guess;
  std::array<Touch<T>, kPacks> touch;
  for (std::size_t i = 0; i < kPacks; ++i) {
    const ChainBody<T>* pack = bodies + i * stride;
    const ChainBody<T>& known = pack[contact.touch.known];
    joint[i] =
        chain_point<ChainRates::kAccelerations>(pack[contact.touch.carrier], contact.touch.freedom.p_WO);
    const ChainPoint<T> center = chain_point<ChainRates::kNone>(known, contact.on_known.center_B);
    frame[i] = {less(center.p_W, joint[i].p_W), known.R_WB * all_lanes<T>(contact.on_known.axis_B)};
    guess[i] = predicted(before, driver[i].position);
  }
  // Further passes do nothing to rows that have arrived.
  bool arrived = false;
  for (int pass = 0; pass < kMostPasses && !arrived; ++pass) {
    arrived = true;
    for (std::size_t i = 0; i < kPacks; ++i) {
      touch[i] = touch_at(contact, frame[i], guess[i]);
      arrived = arrived && holds_everywhere(abs(touch[i].g) + abs(touch[i].s) <= T(kOvalsArrived * size));
      take_pass(contact, touch[i], guess[i]);
    }
  }
  Numbers<kPacks * T::kLanes> numbers;
  numbers.begin(before);
  for (std::size_t i = 0; i < kPacks; ++i) {
    ChainBody<T>* pack = bodies + i * stride;
    const Rates<T> rates =
        rates_at(contact, touch[i], guess[i].normal(), joint[i], pack[contact.touch.known]);
    place_bodies(contact, guess[i], touch[i], rates, joint[i], pack);
    const std::size_t at = 1 + i * T::kLanes;
    numbers.put(at, driver[i].position, guess[i], rates);
    const T least = abs(rates.gap_q);
    const auto sound = (least * least >= T(kLeastOvalSine * kLeastOvalSine) * rates.arm2) &
                       goes_on<T>(numbers, at, contact.touch.freedom.turns, size);
    watch.note(arrived ? select(sound, -least, T(kInf)) : T(kInf));
    watch.far2 = max(watch.far2, rates.arm2);
  }
  before = numbers.last();
}

}  // namespace higherpair
