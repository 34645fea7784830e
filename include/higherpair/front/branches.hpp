#pragma once

#include "higherpair/front/model.hpp"

#include <array>
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

}  // namespace higherpair
