#pragma once

#include "higherpair/analysis/mapped_contacts.hpp"
#include "higherpair/contact/contact_map.hpp"
#include "higherpair/io/profile.hpp"

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace higherpair::cli {

// The maps of a mechanism's contacts in the profile's units, as joint coordinates, for their writers.
// Branches are numbered from 1.

struct MapRow {
  double driver = 0;
  double position = 0;
  double x = 0;
  double y = 0;
  double normal = 0;  ///< angle of the outward normal of the file's first body, continuous along a branch
  bool free = false;
};

struct MapEndReport {
  std::string type;
  double driver = 0;
  double position = 0;
  std::optional<int> other;  ///< number of the branch that merges there
};

struct MapBranchReport {
  bool opposed = false;
  int turns = 0;
  MapEndReport begin, end;
  std::vector<MapRow> rows;  ///< by rising driver coordinate
  std::vector<MapRow> free_changes;
  std::vector<MapRow> extremes;
};

struct MapEventReport {
  std::string type;
  MapRow at;
  bool opposed = false;
  std::vector<int> branches;
};

struct NeighbourReport {
  int branch = 0;
  double driver = 0;
  double distance = 0;
};

/// The branch that the mechanism is on.
struct OwnBranch {
  int branch = 0;
  double driver = 0;  ///< at the start
  double position = 0;
  std::optional<NeighbourReport> at_start;
  std::optional<NeighbourReport> nearest;
};

struct ContactMapReport {
  std::string contact;
  std::string refusal;  ///< why there is no map; empty: there is
  std::string driver_joint, driver_unit;
  std::string position_joint, position_unit;
  double start = 0, end = 0;  ///< range of the driver
  bool complete = true;
  std::vector<MapBranchReport> branches;
  std::vector<MapEventReport> events;
  std::optional<OwnBranch> own;
};

struct MapReport {
  std::string title;
  std::string length_unit, angle_unit;
  std::vector<ContactMapReport> contacts;
};

/// A map in the profile's units.
[[nodiscard]] ContactMapReport map_report(const Profile& profile, const MappedContact& mapped,
                                          const ContactMap& map);

[[nodiscard]] std::string map_text(const MapReport& report);
[[nodiscard]] std::string map_csv(const MapReport& report);
[[nodiscard]] nlohmann::ordered_json map_json(const MapReport& report);

}  // namespace higherpair::cli
