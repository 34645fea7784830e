#pragma once

#include "higherpair/mechanism/description.hpp"

#include <atomic>
#include <optional>
#include <vector>

namespace higherpair {

/// Positions of a driver between which a mechanism can be assembled [rad or m].
struct StartRange {
  double low = 0;
  double high = 0;
};

/// Where the first driver could start a mechanism that cannot be assembled with the drivers at these
/// positions, the other drivers being held there. By trying 72 positions, over the turn that begins at its
/// position or up to twice the size of the mechanism to either side of it, and halving at the ends of what is
/// found: a range narrower than the 72nd part may be missed. At most three ranges, the nearest first; their
/// ends are within 1e-9 of the span, on the side where it can be assembled, of a driver that turns the lower
/// one in [0, 2π). Empty where there is none; nothing where the positions are not what is wrong, and once
/// stopped.
/// \param tolerance  as of start_run
/// \param stop       once true, the search is given up; may be null
[[nodiscard]] std::optional<std::vector<StartRange>> find_start_ranges(
    const Mechanism& mechanism, const std::vector<double>& drivers, double tolerance,
    const std::atomic<bool>* stop = nullptr);

}  // namespace higherpair
