#pragma once

#include "higherpair/analysis/run.hpp"

#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// A contact that places a follower, as a pair of curves whose first body is at rest.
struct ContactPlace {
  int contact = 0;
  CarriedBody follower;
  ContactPair pair;            ///< body 1: the known one
  double u = 0;                ///< its coordinate
  bool known_is_first = true;  ///< whether the contact names the known body first
  double carrier_angle =
      0;             ///< of a turning follower: its coordinate in the pair less that on its carrier [rad]
  double posed = 0;  ///< follower's coordinate on its carrier in the poses [rad or m]
};

struct Branches {
  std::vector<ContactPlace> contacts;           ///< those that place a follower by themselves
  std::vector<std::vector<double>> assemblies;  ///< coordinates of Mechanism::joints [rad or m]
  bool complete = true;                         ///< false: more assemblies than are listed, or coupled bodies
};

/// What `branches` lists at the drivers' positions: the contacts of followers (where their carriers stand in
/// the assembly nearest to the poses), and every combination of assembly modes that closes. Contacts in an
/// assembly are those that their `approach` picks.
[[nodiscard]] tl::expected<Branches, StartFailure> list_branches(const Mechanism& mechanism,
                                                                 const std::vector<double>& drivers);

}  // namespace higherpair
