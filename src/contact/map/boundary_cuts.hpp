#pragma once

#include "boundary_trace.hpp"
#include "higherpair/contact/contact_map.hpp"

#include <array>
#include <vector>

namespace higherpair {

/// A branch of a map of boundaries before its coordinates are shifted into the range.
struct BranchDraft {
  MapBranch branch;
  TracePath path;
};

/// The curves of tangencies, cut into branches.
struct BoundaryCuts {
  std::vector<BranchDraft> drafts;
  std::vector<MapEvent> events;  ///< to which the ends of the drafts refer
  bool complete = true;          ///< false: a curve was lost
  bool idle = false;  ///< a curve was left out along which the follower does not change the bodies' distance
};

/// Traces all curves of tangencies and splits them where ∂gap/∂q or κ1 + κ2 changes its sign, so that u is
/// monotonic along each branch.
/// \param motions    a pair with the motions of the two bodies
/// \param unbounded  as of map_contacts
/// \param range      once it is stopped, the cuts are incomplete
[[nodiscard]] BoundaryCuts cut_curves(const BoundaryTrace& trace, const ContactPair& motions,
                                      const std::array<bool, 2>& unbounded, const MapRange& range);

}  // namespace higherpair
