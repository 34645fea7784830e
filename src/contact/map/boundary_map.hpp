#pragma once

#include "higherpair/contact/contact_map.hpp"

namespace higherpair {

/// map_contacts of two boundaries; the free_changes of its branches are left empty.
[[nodiscard]] ContactMap map_boundaries(const BoundaryPair& pair, const MapRange& range,
                                        const std::array<bool, 2>& unbounded);

}  // namespace higherpair
