#pragma once

#include "map_network.hpp"

#include <vector>

namespace higherpair {

/// The branches of a network, sampled; their free_changes are left empty.
[[nodiscard]] std::vector<MapBranch> branches_of(const ContactPair& pair, const MapRange& range,
                                                 MapNetwork& network);

}  // namespace higherpair
