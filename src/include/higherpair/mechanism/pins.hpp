#pragma once

#include "higherpair/mechanism/plan.hpp"

#include <vector>

namespace higherpair {

/// A pin and all bodies on it: revolute joints that share their points form one pin.
struct Pin {
  std::vector<BodyPoint> ends;  ///< one for each body, in the order of bodies
  std::vector<int> joints;      ///< of Mechanism::joints; ends.size() - 1 hold it together
};

/// All pins, in the order of their first joints. Two points of a body are the same if they differ by less
/// than 1e-12 of their distance from the frame's origin.
[[nodiscard]] std::vector<Pin> find_pins(const Mechanism& mechanism);

/// The bodies to which both wheels of gears or a belt are pinned at their centres: one of them is the
/// carrier.
[[nodiscard]] std::vector<int> carriers_of(const Mechanism& mechanism, const Joint& wheels,
                                           const std::vector<Pin>& pins);

}  // namespace higherpair
