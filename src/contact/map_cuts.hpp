#pragma once

#include "higherpair/contact/contact_map.hpp"

#include <vector>

// The critical positions of a pair in the driver's range, and the intervals between them.

namespace higherpair {

/// A place at which branches may begin and end.
struct MapCut {
  double low = 0, high = 0;  ///< of the critical positions that it represents
  std::vector<int> events;   ///< indices into MapCuts::events
  bool runaway = false;      ///< contacts may run off to infinity here
  bool crossing = false;     ///< branches may cross here
};

/// Between two neighbouring cuts, in which every contact moves smoothly.
struct MapInterval {
  double low = 0, high = 0;                          ///< the critical positions at its sides
  double middle = 0;                                 ///< where its contacts are listed
  bool crossing_low = false, crossing_high = false;  ///< branches may cross there
};

struct MapCuts {
  MapStatus status = MapStatus::kNoPair;
  bool cyclic = false;  ///< the last interval is followed by the first, one turn later
  double start = 0, end = 0;
  double size = 0;               ///< what counts as one unit of a displacement [m]
  std::vector<MapEvent> events;  ///< by rising u
  std::vector<MapCut> cuts;      ///< by rising u
  std::vector<MapInterval> intervals;

  /// The cut at one side of an interval; none at the ends of the range and where there is no cut at all.
  [[nodiscard]] const MapCut* cut_beside(int interval, bool forward) const;
};

[[nodiscard]] MapCuts cuts_of(const ContactPair& pair, const MapRange& range);

/// Between two follower coordinates, in units: radians up to whole turns, or shares of the size.
[[nodiscard]] double difference_of_q(const ContactPair& pair, double size, double a, double b);

}  // namespace higherpair
