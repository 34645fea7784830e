#pragma once

#include "higherpair/contact/contact_map.hpp"

#include <optional>

namespace higherpair {

/// a - b of two follower coordinates, up to whole turns.
[[nodiscard]] inline double gap_of_q(const ContactMap& map, double a, double b) {
  return map.pair.motion2.turns ? nearest_turn(a - b, 0) : a - b;
}

/// A solved contact as a point of a map. \pre `at` lies on a branch whose normals are opposed or not as told
[[nodiscard]] MapPoint point_of(const ContactPair& pair, const MapRange& range, bool opposed,
                                const ContactPosition& at);

/// The contact of a branch at u, followed from a point of it; none where that fails.
[[nodiscard]] std::optional<MapPoint> followed(const ContactPair& pair, const MapRange& range,
                                               const MapBranch& branch, const MapPoint& from, double u);

}  // namespace higherpair
