#pragma once

#include "higherpair/contact/contact_map.hpp"
#include "higherpair/contact/tracker.hpp"
#include "map_cuts.hpp"

#include <vector>

// The contacts in the middles of the intervals between critical positions, and which of them are one branch.

namespace higherpair {

/// Where a node's branch ends beyond one side of its interval.
struct NodeSide {
  int node = -1;  ///< the next one on this side; -1: the branch ends here
  MapEndType type = MapEndType::kLost;
  int event = -1;   ///< index into MapNetwork::events
  double u = 0;     ///< of the end
  double turn = 0;  ///< what the next one's q lacks to be continuous with this one's: whole turns [rad]
};

/// One contact in the middle of an interval.
struct MapNode {
  int interval = 0;
  ContactTrack track;  ///< of the pair whose normals are opposed here
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
