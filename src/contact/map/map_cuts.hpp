#pragma once

#include "higherpair/contact/contact_map.hpp"

#include <vector>

// The critical positions of a pair in the driver's range, and the intervals between them.

namespace higherpair {

/// A driver position at which branches may begin and end.
struct MapCut {
  double low = 0, high = 0;  ///< range of the critical positions merged into it
  std::vector<int> events;   ///< indices into MapCuts::events
  bool runaway = false;      ///< contacts may run off to infinity here
  bool crossing = false;     ///< branches may cross here
};

/// The range between two neighbouring cuts, in which every contact moves smoothly.
struct MapInterval {
  double low = 0, high = 0;                          ///< the critical positions at its sides
  double middle = 0;                                 ///< where its contacts are listed
  bool crossing_low = false, crossing_high = false;  ///< branches may cross there
};

struct MapCuts {
  MapStatus status = MapStatus::kNoPair;
  bool cyclic = false;  ///< the last interval is followed by the first, one turn later
  double start = 0, end = 0;
  double size = 0;               ///< unit of displacements [m]
  std::vector<MapEvent> events;  ///< by rising u
  std::vector<MapCut> cuts;      ///< by rising u
  std::vector<MapInterval> intervals;

  /// The cut at one side of an interval; none at the ends of the range or if there are no cuts.
  [[nodiscard]] const MapCut* cut_beside(int interval, bool forward) const;
};

[[nodiscard]] MapCuts cuts_of(const ContactPair& pair, const MapRange& range);

}  // namespace higherpair
