#pragma once

#include "chain_kernel.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// How fast a body moves at most for a unit velocity of the driver.
struct MotionBound {
  Vector2d p_B = Vector2d::Zero();  ///< a point of it
  double speed = 0;                 ///< of this point
  double acceleration = 0;
  double omega = 0;
  double alpha = 0;
};

/// Whether between positions of the driver no group of a chain comes near a limit or a crossing of branches,
/// so that the solution in the modes of the first position is the one to which the motion leads.
///
/// What must not reach its limit is known at every position (`watches`). Between two of them, `step` apart, a
/// function f is off its chord by no more than step²/8 max |f″|. Here |f″| is bounded from lengths and from
/// bounds of the rates of the bodies before, group by group; once the group is known to stay away from its
/// limit, its own rates are bounded too.
/// Contacts of ovals have been held against each other from row to row already (chain_ovals.hpp); of them
/// the bounds are taken for the groups behind them.
/// \param watches  of the groups
/// \param size     of the mechanism [m]
/// \param bounds   of the bodies; the result where it is true
[[nodiscard]] bool stays_on_branches(std::span<const ChainGroup> groups,
                                     std::span<const ChainWatch<double>> watches, double step, double size,
                                     std::vector<MotionBound>& bounds);

/// Whether a contact presses in all rows and between them, from its forces in rows at even steps. A function
/// is off its chord by 1/8 of its second difference, which itself changes as the fourth one says; four times
/// as much is allowed for, which covers kinks as well. Forces that change a good deal from row to row are not
/// judged.
[[nodiscard]] bool presses_throughout(std::span<const double> forces);

}  // namespace higherpair
