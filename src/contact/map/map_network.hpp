#pragma once

#include "higherpair/contact/contact_map.hpp"
#include "higherpair/contact/tracker.hpp"
#include "map_cuts.hpp"

#include <vector>

// The contacts at the middles of the intervals between critical positions, and which of them are on one
// branch.

namespace higherpair {

/// What follows a node on one side of its interval: the next node, or the end of the branch.
struct NodeSide {
  int node = -1;  ///< the next node on this side; -1: the branch ends here
  MapEndType type = MapEndType::kLost;
  int event = -1;   ///< index into MapNetwork::events
  double u = 0;     ///< of the end
  double turn = 0;  ///< whole turns to add to the next node's q to make it continuous with this one's [rad]
};

/// One contact in the middle of an interval.
struct MapNode {
  int interval = 0;
  ContactTrack track;  ///< of the pair with its sides chosen so that the normals are opposed here
  bool opposed = true;
  NodeSide before, behind;
};

struct MapNetwork : MapCuts {
  bool complete = true;
  std::vector<MapNode> nodes;  ///< by intervals
};

/// The contacts of every interval and their links. `status` is not kOk where they cannot be listed.
[[nodiscard]] MapNetwork build_network(const ContactPair& pair, const MapRange& range);

}  // namespace higherpair
