#pragma once

#include "higherpair/mechanism/plan.hpp"

#include <vector>

namespace higherpair {

/// A body with coordinates that no condition determines.
struct LooseBody {
  int body = 0;
  bool turning_only = false;  ///< only its angle is free
};

struct Structure {
  std::vector<BodySet> sets;  ///< in an order of solution
  std::vector<LooseBody> loose;
  int surplus = 0;  ///< number of conditions for which no coordinate is left
};

/// Matches conditions with coordinates (a maximum matching of the bipartite graph) and orders the strongly
/// connected components of the bodies. If there are too many conditions, those that others imply at an
/// assembled position are left out first. A surplus condition (drivers come first, slip of rolling contacts
/// last) belongs to the last placed of its bodies.
[[nodiscard]] Structure analyse_structure(const Mechanism& mechanism);

/// The bodies whose angle nothing but rolling contacts set: with these slipping, as many coordinates are left
/// over. Where there is a choice of which, a body that rolls keeps the angle of its pose rather than another,
/// a carried one (a roller on an arm) rather than one on ground (a cam), and one that is round about its pin,
/// or nearly, rather than any other. It does not depend on the order of bodies, joints and contacts in the
/// description.
[[nodiscard]] std::vector<int> phase_bodies(const Mechanism& mechanism);

}  // namespace higherpair
