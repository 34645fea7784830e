#pragma once

#include "higherpair/mechanism/description.hpp"

#include <vector>

namespace higherpair {

/// Bodies that must be placed together, and the conditions that do it: all whose last unplaced body is among
/// them.
struct BodySet {
  std::vector<int> bodies;
  std::vector<int> joints;
  std::vector<int> contacts;
  std::vector<int> drivers;
};

/// Which coordinates of which bodies nothing places.
struct LooseBody {
  int body = 0;
  bool turning_only = false;  ///< only its angle is free
};

struct Structure {
  std::vector<BodySet> sets;  ///< in an order of solution
  std::vector<LooseBody> loose;
  int surplus = 0;  ///< conditions that no coordinate is left for
};

/// Matches conditions with coordinates (a maximum matching of the bipartite graph) and orders the strongly
/// connected components of the bodies. Where there are too many, conditions that others imply at an assembled
/// position are left out first. A surplus condition (drivers come first, slip of rolling contacts
/// last) counts to the last placed of its bodies.
[[nodiscard]] Structure analyse_structure(const Mechanism& mechanism);

}  // namespace higherpair
