#pragma once

#include "cases.hpp"
#include "floor.hpp"

namespace higherpair::bench {

/// The four-bar that the pair circle_on_circle is equivalent to everywhere.
inline constexpr FourBarByHand kFourBar{0.08, 0.01, 0.035, 0.06, 1};

/// Each of these ends the program where the library's answers over a whole turn are wrong.

/// By hand: the loop closes and the rates are differences of the angles; the library's function and its
/// kernel give the same.
void check_four_bar();

/// Tracked over a turn: closure at every step, q against a solution that does not use the library (circle on
/// circle: also the four-bar by hand; flat face: the support function with both derivatives), rates against
/// differences of q.
void check_tracking(const Case& reference);

/// The row of the motion table and its text say what the track says.
void check_rows(const Case& reference);

}  // namespace higherpair::bench
