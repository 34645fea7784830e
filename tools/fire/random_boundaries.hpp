#pragma once

#include "sketch.hpp"

#include <cstdint>

namespace higherpair::fire {

/// One pair of flanks of spur gears with random module, teeth, pressure angle and profile shift, at a centre
/// distance of at least that without backlash, moved while they touch. In its twin a gear joint replaces the
/// contact.
[[nodiscard]] Sketch random_flank_pair(std::uint64_t seed);

/// An ellipse that turns under an open face, flat or round, which may be too narrow for it. Its twin is a
/// block with that face and sides square to it, whose corners are the ends of the face.
[[nodiscard]] Sketch random_open_face(std::uint64_t seed);

/// Changes a cam with straight parts and rounded corners: its roller touches an offset of the outline. In the
/// twin the roller is larger by the offset and touches the outline itself.
[[nodiscard]] Sketch with_offset(Sketch cam, std::uint64_t seed);

}  // namespace higherpair::fire
