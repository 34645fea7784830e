#pragma once

#include "higherpair/front/model.hpp"

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

// Maps of a mechanism's contacts (configuration spaces): every contact of two curves over a turn of the
// driver, or the range of a sliding one, as branches in the plane of the coordinates of the driver's and the
// follower's joint, in the profile's units. Branches are numbered from 1.

/// Most rows of a map: all are kept in memory.
inline constexpr std::int64_t kMostMapRows = 10'000'000;

/// What is mapped, and how finely.
struct MapSettings {
  std::optional<std::int64_t>
      samples;  ///< rows over the range, 2 to kMostMapRows; none: as many as the profile's run has
  double tolerance = 1e-9;  ///< largest overlap at which a contact counts as free, relative to
                            ///< the size of the bodies
  const std::atomic<bool>* stop = nullptr;  ///< once true, the map is abandoned
};

/// A contact on a branch; in the profile's units.
struct MapRow {
  double driver = 0;    ///< coordinate of the driver's joint
  double position = 0;  ///< of the follower
  double x = 0;         ///< contact point
  double y = 0;
  double normal = 0;  ///< angle of the outward normal of the contact's first body in the profile,
                      ///< continuous along a branch
  bool free = false;  ///< the bodies do not overlap
};

/// Where a branch begins or ends.
struct MapEndReport {
  std::string type;  ///< "fold", "conforming", "infinity", "end", "range", "closed", "lost"
  double driver = 0;
  double position = 0;
  std::optional<int> other;  ///< number of the branch that merges there
};

/// A curve of contacts that meets others at its ends only.
struct MapBranchReport {
  bool opposed = false;
  int turns = 0;  ///< turns of the driver after which it closes; 0: it does not close
  MapEndReport begin, end;
  std::vector<MapRow> rows;          ///< in ascending order of the driver coordinate
  std::vector<MapRow> free_changes;  ///< where the bodies begin or cease to overlap
  std::vector<MapRow> extremes;      ///< of the follower
};

/// Where branches merge or cross, or a contact is conforming.
struct MapEventReport {
  std::string type;  ///< "fold", "crossing", "conforming"
  MapRow at;
  bool opposed = false;
  std::vector<int> branches;
};

/// Another branch that comes near the mechanism's own one.
struct NeighbourReport {
  int branch = 0;
  double driver = 0;    ///< where
  double distance = 0;  ///< distance between the follower's coordinates there
};

/// The branch that the mechanism is on.
struct OwnBranch {
  int branch = 0;
  double driver = 0;  ///< at the start
  double position = 0;
  std::optional<NeighbourReport> at_start;  ///< the nearest other branch at the start
  std::optional<NeighbourReport> nearest;   ///< the nearest on the whole map
};

/// The map of one contact.
struct ContactMapReport {
  std::string contact;
  std::string refusal;  ///< why there is no map; empty if there is one
  std::string driver_joint, driver_unit;
  std::string position_joint, position_unit;
  double start = 0, end = 0;  ///< range of the driver
  bool complete = true;       ///< the branches account for every contact at every sample
  std::vector<MapBranchReport> branches;
  std::vector<MapEventReport> events;
  std::optional<OwnBranch> own;
};

/// The maps of a mechanism's contacts.
struct MapReport {
  std::string title;
  std::string length_unit, angle_unit;
  std::string not_started;  ///< why the mechanism cannot be started, and so is on no branch; empty if it can
  bool stopped = false;     ///< by MapSettings::stop: `contacts` is empty
  std::vector<ContactMapReport> contacts;
};

/// Maps every slipping contact whose bodies are both joined to ground. Fails if no contact has a map.
[[nodiscard]] Result<MapReport> map_of(const Model& model, const MapSettings& settings = {});

}  // namespace higherpair
