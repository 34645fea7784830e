#pragma once

#include "floor.hpp"
#include "higherpair/analysis/run.hpp"
#include "sixbar_by_hand.hpp"

namespace higherpair::bench {

/// A shipped linkage, and the same one by hand.
template <class ByHand>
struct LinkageCase {
  ByHand by_hand;
  Run run;  ///< at the driver's start
};

/// Both end the program if the library's results over a turn differ from those by hand: the motion of the
/// bodies, and in the six-bar all pin forces and the driving torque, by reactions and by power.
[[nodiscard]] LinkageCase<FourBarByHand> checked_four_bar();
[[nodiscard]] LinkageCase<SixBarByHand> checked_watt_sixbar();

}  // namespace higherpair::bench
