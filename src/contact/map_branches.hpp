#pragma once

#include "map_network.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// The branches of a network, sampled; their free_changes are left empty.
[[nodiscard]] std::vector<MapBranch> branches_of(const ContactPair& pair, const MapRange& range,
                                                 MapNetwork& network);

/// The contact of a branch at u, followed from a point of it; none where that fails.
[[nodiscard]] std::optional<MapPoint> followed(const ContactPair& pair, const MapRange& range,
                                               const MapBranch& branch, const MapPoint& from, double u);

}  // namespace higherpair
