#pragma once

#include "sketch.hpp"

#include <cstdint>

namespace higherpair::fire {

/// One pair of flanks of spur gears of random module, teeth, pressure angle and profile shift, at a distance
/// from where they mesh without play upwards, moved while they touch. Its twin has a joint of gears in place
/// of the contact.
[[nodiscard]] Sketch random_flank_pair(std::uint64_t seed);

/// An ellipse that turns under an open face, flat or round, which may be too narrow for it. Its twin is a
/// block with that face and sides square to it: the ends are its corners.
[[nodiscard]] Sketch random_open_face(std::uint64_t seed);

/// A cam of straight parts and rounded corners with its roller: the roller on an offset of the outline. In
/// the twin it is larger by as much, on the outline itself.
[[nodiscard]] Sketch with_offset(Sketch cam, std::uint64_t seed);

}  // namespace higherpair::fire
