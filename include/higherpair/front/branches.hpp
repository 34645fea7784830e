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

}  // namespace higherpair
