#pragma once

#include "higherpair/mechanism/plan.hpp"

#include <span>
#include <string>

namespace higherpair {

/// The names of bodies, "coupler, rocker".
[[nodiscard]] std::string body_names(const Mechanism& mechanism, std::span<const int> bodies);

/// A group in words, with the names of the description: "crank: driven at crank_pivot", "coupler, rocker:
/// dyad RRR, two links between pins", "a, b, c: coupled bodies, solved together by Newton's method".
[[nodiscard]] std::string describe(const Mechanism& mechanism, const Group& group);

}  // namespace higherpair
