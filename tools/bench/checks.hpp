#pragma once

#include "cases.hpp"
#include "floor.hpp"

namespace higherpair::bench {

/// The four-bar to which the pair circle_on_circle is equivalent in all positions.
inline constexpr FourBarByHand kFourBar{0.08, 0.01, 0.035, 0.06, 1};

/// Each of these functions ends the program if the library's results over a whole turn are wrong.

/// The four-bar by hand: its loop closes and its rates agree with differences of the angles.
void check_four_bar();

/// Follows a contact over a turn. Tests closure at every step, q against a solution that does not use the
/// library (for circle on circle also the four-bar by hand, for the flat face the support function with both
/// derivatives), and rates against differences of q.
void check_tracking(const Case& reference);

/// The row of the motion table and its text agree with the track.
void check_rows(const Case& reference);

}  // namespace higherpair::bench
