#pragma once

#include "higherpair/analysis/run.hpp"

#include <cstddef>

namespace higherpair {

/// Number of places, corners excepted, at which the two bodies of a contact touch at the last position of a
/// run: 2 where two pairs of teeth are in mesh, 0 where a contact that may separate is open.
[[nodiscard]] std::size_t touching_places(const Run& run, std::size_t contact);

}  // namespace higherpair
