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
  double tolerance = 1e-9;  ///< largest closure error, relative to the size of the mechanism; > 0
};

/// A position of the follower in which two curves touch, in the profile's units.
struct ContactEntry {
  double position = 0;  ///< coordinate of the follower's joint
  double x = 0;         ///< contact point in ground
  double y = 0;
  double normal = 0;     ///< angle of the outward normal of the contact's first body
  bool opposed = false;  ///< the outward normals of the two bodies are opposed
  bool free = false;     ///< the interiors of the bodies are disjoint: only such contacts are physically
                         ///< possible
  std::string remark;    ///< what is special about it, or empty
  std::optional<std::array<double, 2>> certified;  ///< interval of the position that contains this contact
                                                   ///< and no other
};

/// Every position of one follower in which the two curves of its contact touch.
struct ContactReport {
  std::string contact;
  std::string joint;  ///< the joint of the follower
  std::string position_unit;
  std::vector<ContactEntry> entries;
  std::string note;       ///< why there is no list, or empty
  bool complete = false;  ///< `entries` are proven to be all; for curves of several parts all with opposed
                          ///< normals
  std::vector<std::array<double, 2>> undecided;  ///< if not: intervals of the position that may hold others
  std::string proof;                             ///< for curves of several parts: the same as a sentence;
                                                 ///< else empty
  std::string certificate;                       ///< what was certified; empty: not requested
};

/// All assemblies of a mechanism at the first positions of its drivers.
struct BranchesReport {
  std::string title;
  std::string length_unit;
  std::string angle_unit;
  std::string drivers;                  ///< the drivers' positions as text
  double driver = 0;                    ///< position of the first driver
  std::vector<ContactReport> contacts;  ///< one for each contact that alone determines the position of a
                                        ///< follower
  std::vector<std::string> joints;      ///< all
  std::vector<std::string> joint_units;
  std::vector<std::vector<double>> assemblies;  ///< one for each assembly: the coordinates of `joints`
  bool complete = true;                         ///< false: there may be more assemblies
  bool certified = false;                       ///< certification was requested
};

/// Whether this build has the exact arithmetic that certifying contacts needs.
[[nodiscard]] bool can_certify();

/// All contacts and all assemblies at the first positions of the drivers. Fails with the reason if there is
/// none, and with kInternal if exact arithmetic disagrees with the list.
[[nodiscard]] Result<BranchesReport> branches_of(const Model& model, const BranchesSettings& settings = {});

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
