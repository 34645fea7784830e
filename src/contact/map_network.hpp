#pragma once

#include "higherpair/contact/contact_map.hpp"
#include "higherpair/contact/tracker.hpp"

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

/// Between two neighbouring cuts, in which every contact moves smoothly.
struct MapInterval {
  double low = 0, high = 0;                          ///< the critical positions at its sides
  double middle = 0;                                 ///< where its contacts are listed
  bool crossing_low = false, crossing_high = false;  ///< branches may cross there
};

/// One contact in the middle of an interval.
struct MapNode {
  int interval = 0;
  ContactTrack track;  ///< of the pair whose normals are opposed here
  bool opposed = true;
  NodeSide before, behind;
};

struct MapNetwork {
  MapStatus status = MapStatus::kNoPair;
  bool complete = true;
  bool cyclic = false;  ///< the last interval is followed by the first, one turn later
  double start = 0, end = 0;
  double size = 0;  ///< what counts as one unit of a displacement [m]
  std::vector<MapInterval> intervals;
  std::vector<MapEvent> events;  ///< by rising u
  std::vector<MapNode> nodes;    ///< by intervals
};

[[nodiscard]] MapNetwork build_network(const ContactPair& pair, const MapRange& range);

/// Between two follower coordinates, in units: radians up to whole turns, or shares of the size.
[[nodiscard]] double difference_of_q(const ContactPair& pair, double size, double a, double b);

}  // namespace higherpair
