#pragma once

#include "chain_kernel.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// Bounds of a body's motion for a unit velocity of the driver.
struct MotionBound {
  Vector2d p_B = Vector2d::Zero();  ///< a point of the body
  double speed = 0;                 ///< speed of that point
  double acceleration = 0;
  double omega = 0;
  double alpha = 0;
};

/// Whether no group of a chain comes near a limit or a crossing of branches between the positions of the
/// driver, so that the solution in the modes of the first position is the one to which the motion leads.
///
/// The quantity of each group that must not reach its limit is known at every position (`watches`). Between
/// two positions, `step` apart, a function f deviates from its chord by no more than step²/8 max |f″|. Here
/// |f″| is bounded from lengths and from the bounds of the rates of preceding bodies, group by group; once a
/// group is known to stay away from its limit, its own rates are bounded too.
/// Contacts of ovals have already been checked from row to row (chain_ovals.hpp); for them bounds are
/// computed only because following groups need them.
/// \param watches  of the groups
/// \param size     of the mechanism [m]
/// \param bounds   of the bodies; the result where it is true
[[nodiscard]] bool stays_on_branches(std::span<const ChainGroup> groups,
                                     std::span<const ChainWatch<double>> watches, double step, double size,
                                     std::vector<MotionBound>& bounds);

/// Whether a contact presses in all rows and between them, judged by its forces in evenly spaced rows. A
/// function deviates from its chord by 1/8 of its second difference, whose own change is estimated by the
/// fourth difference; four times as much is allowed for, which covers kinks as well. False also where forces
/// change too much from row to row to be judged.
[[nodiscard]] bool presses_throughout(std::span<const double> forces);

}  // namespace higherpair
