#pragma once

#include "sketch.hpp"

#include <cstdint>

namespace higherpair::fire {

/// A cam whose flank comes from a random motion law (dwell, rise and return of random laws), and a follower
/// that slides beside the pivot or swings, with a roller, a flat face or a knife edge; the cam is large
/// enough not to be undercut. Its twin has no contact: the follower is driven by the law.
[[nodiscard]] Sketch random_law_cam(std::uint64_t seed);

}  // namespace higherpair::fire
