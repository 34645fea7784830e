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
  /// For a turning follower: its coordinate in the pair less that on its carrier [rad].
  double carrier_angle = 0;
  double posed = 0;  ///< coordinate of the follower on its carrier in the poses [rad or m]
};

struct Branches {
  std::vector<ContactPlace> contacts;           ///< those that place a follower by themselves
  std::vector<std::vector<double>> assemblies;  ///< coordinates of Mechanism::joints [rad or m]
  bool complete = true;  ///< false: there are more assemblies than listed, or coupled bodies
};

/// Contents of `branches` at the drivers' positions: the contacts of followers (with their carriers placed as
/// in the assembly nearest to the poses), and every combination of assembly modes that can be closed.
/// Contacts in an assembly are those that their `approach` selects.
[[nodiscard]] tl::expected<Branches, StartFailure> list_branches(const Mechanism& mechanism,
                                                                 const std::vector<double>& drivers);

}  // namespace higherpair
