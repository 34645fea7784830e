#pragma once

#include "map_network.hpp"

#include <vector>

namespace higherpair {

/// The branches of a network, sampled; their free_changes are left empty. The network is not complete where a
/// branch cannot be followed to all of its samples.
[[nodiscard]] std::vector<MapBranch> branches_of(const ContactPair& pair, const MapRange& range,
                                                 MapNetwork& network);

}  // namespace higherpair
