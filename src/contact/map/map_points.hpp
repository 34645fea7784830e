#pragma once

#include "higherpair/contact/contact_map.hpp"

#include <optional>

namespace higherpair {

/// a - b for two follower coordinates, up to whole turns.
[[nodiscard]] inline double gap_of_q(const ContactMap& map, double a, double b) {
  return map.pair.motion2.turns ? nearest_turn(a - b, 0) : a - b;
}

/// A solved contact as a point of a map. \param opposed  whether the normals are opposed on its branch
[[nodiscard]] MapPoint point_of(const ContactPair& pair, const MapRange& range, bool opposed,
                                const ContactPosition& at);

/// The contact of a branch at u, followed from one of its points; none where that fails.
[[nodiscard]] std::optional<MapPoint> followed(const ContactPair& pair, const MapRange& range,
                                               const MapBranch& branch, const MapPoint& from, double u);

}  // namespace higherpair
