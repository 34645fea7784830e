#pragma once

#include "sketch.hpp"

#include <cstdint>

namespace higherpair::fire {

/// A cam whose flank is shaped by a random motion law (dwells, rises and returns of random types), and a
/// follower that slides, with an offset from the pivot, or swings, with a roller, a flat face or a knife
/// edge. The cam is large enough to avoid undercut. Its twin has no contact: the follower is driven by the
/// law.
[[nodiscard]] Sketch random_law_cam(std::uint64_t seed);

}  // namespace higherpair::fire
