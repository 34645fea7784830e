#pragma once

#include "higherpair/mechanism/plan.hpp"

#include <string>

namespace higherpair {

/// A group in words, by the names of the description: "crank: driven at crank_pivot", "coupler, rocker: dyad
/// RRR, two links between pins", "a, b, c: coupled bodies, solved together by Newton's method".
[[nodiscard]] std::string describe(const Mechanism& mechanism, const Group& group);

}  // namespace higherpair
