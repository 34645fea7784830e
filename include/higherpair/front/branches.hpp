#pragma once

#include "higherpair/front/model.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// How contacts and assemblies are listed.
struct BranchesSettings {
  bool certify = false;     ///< decide every contact in exact arithmetic
  double tolerance = 1e-9;  ///< largest closure error, of the size of the mechanism
};

/// A contact of two curves that the follower can be brought to, in the profile's units.
struct ContactEntry {
  double position = 0;  ///< coordinate of the follower's joint
  double x = 0;         ///< contact point in ground
  double y = 0;
  double normal = 0;     ///< angle of the outward normal of the contact's first body
  bool opposed = false;  ///< the outward normals of the two bodies are opposed
  bool free = false;     ///< the interiors of the bodies are disjoint: only these contacts are possible
  std::string remark;    ///< what is special about it, or empty
  std::optional<std::array<double, 2>> certified;  ///< interval of the position that holds this one alone
};

/// Every position of one follower in which the two curves of its contact touch.
struct ContactReport {
  std::string contact;
  std::string joint;  ///< of the follower
  std::string position_unit;
  std::vector<ContactEntry> entries;
  std::string note;       ///< why there is no list, or empty
  bool complete = false;  ///< `entries` are proven to be all; of curves in parts, those of opposed normals
  std::vector<std::array<double, 2>> undecided;  ///< else intervals of the position in which others may be
  std::string proof;                             ///< of curves in parts: the same in a sentence; else empty
  std::string certificate;                       ///< what was certified; empty: not asked for
};

/// Every way in which a mechanism can be put together at the first positions of its drivers.
struct BranchesReport {
  std::string title;
  std::string length_unit;
  std::string angle_unit;
  std::string drivers;                  ///< their positions in words
  double driver = 0;                    ///< position of the first
  std::vector<ContactReport> contacts;  ///< of those contacts that place a follower by themselves
  std::vector<std::string> joints;      ///< all
  std::vector<std::string> joint_units;
  std::vector<std::vector<double>> assemblies;  ///< coordinates of `joints`
  bool complete = true;                         ///< false: there may be more assemblies
  bool certified = false;                       ///< it was asked for
};

/// Whether this build can certify contacts: it has exact arithmetic.
[[nodiscard]] bool can_certify();

/// All contacts and all assemblies at the first positions of the drivers. Fails where there is none, with
/// the reason, and as kInternal where exact arithmetic does not agree.
[[nodiscard]] Result<BranchesReport> branches_of(const Model& model, const BranchesSettings& settings = {});

// The maps of a mechanism's contacts: every contact of two curves over the driver's turn, as branches in the
// plane of the coordinates of the two joints, in the profile's units. Branches are numbered from 1.

/// What is mapped, and how finely.
struct MapSettings {
  std::optional<std::int64_t> samples;  ///< rows over the range, >= 2; none: as many as the profile's run has
  double tolerance = 1e-9;              ///< largest overlap of a contact that counts as free, of the size
  const std::atomic<bool>* stop = nullptr;  ///< once true, the map is given up
};

/// A contact on a branch; in the profile's units.
struct MapRow {
  double driver = 0;    ///< coordinate of the driver's joint
  double position = 0;  ///< of the follower
  double x = 0;         ///< contact point
  double y = 0;
  double normal = 0;  ///< angle of the outward normal of the file's first body, continuous along a branch
  bool free = false;  ///< the bodies are free of each other
};

/// Where a branch begins or ends.
struct MapEndReport {
  std::string type;  ///< "fold", "conforming", "infinity", "range", "closed"
  double driver = 0;
  double position = 0;
  std::optional<int> other;  ///< number of the branch that merges there
};

/// A curve of contacts that neither ends nor meets another one in between.
struct MapBranchReport {
  bool opposed = false;
  int turns = 0;  ///< of the driver after which it closes; 0: it does not
  MapEndReport begin, end;
  std::vector<MapRow> rows;          ///< by rising driver coordinate
  std::vector<MapRow> free_changes;  ///< where the bodies begin or cease to be free of each other
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
  double distance = 0;  ///< between the follower's coordinates there
};

/// The branch that the mechanism is on.
struct OwnBranch {
  int branch = 0;
  double driver = 0;  ///< at the start
  double position = 0;
  std::optional<NeighbourReport> at_start;  ///< the nearest at the start
  std::optional<NeighbourReport> nearest;   ///< the nearest on the whole map
};

/// The map of one contact.
struct ContactMapReport {
  std::string contact;
  std::string refusal;  ///< why there is no map; empty: there is
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
  std::string not_started;  ///< why the mechanism is on no branch; empty: it is
  bool stopped = false;     ///< by MapSettings::stop: there are no contacts
  std::vector<ContactMapReport> contacts;
};

/// Maps every contact that slips and whose bodies both depend on ground. Fails where none has a map.
[[nodiscard]] Result<MapReport> map_of(const Model& model, const MapSettings& settings = {});

}  // namespace higherpair
