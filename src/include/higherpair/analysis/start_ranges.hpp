#pragma once

#include "higherpair/mechanism/description.hpp"

#include <atomic>
#include <optional>
#include <vector>

namespace higherpair {

/// A range of driver positions in which a mechanism can be assembled [rad or m].
struct StartRange {
  double low = 0;
  double high = 0;
};

/// Start positions of the first driver for a mechanism that cannot be assembled with the drivers at these
/// positions, the other drivers being held. 72 positions are tried, over the turn that begins at its position
/// or up to twice the size of the mechanism to either side, and 36 in each of the two steps next to its
/// position; the ends of the ranges found are refined by bisection. Ranges narrower than these steps may be
/// missed. At most three ranges, the nearest of those found first. Their ends are accurate to 1e-9 of the
/// span and lie on the side where assembly is possible; for a turning driver their middle is within half a
/// turn of its position. Empty where there are none; none where the failure has another cause than the
/// positions, or once stopped.
/// \param tolerance  as for start_run
/// \param stop       once true, the search is abandoned; may be null
[[nodiscard]] std::optional<std::vector<StartRange>> find_start_ranges(
    const Mechanism& mechanism, const std::vector<double>& drivers, double tolerance,
    const std::atomic<bool>* stop = nullptr);

}  // namespace higherpair
