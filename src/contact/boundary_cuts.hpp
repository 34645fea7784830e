#pragma once

#include "boundary_trace.hpp"
#include "higherpair/contact/contact_map.hpp"

#include <array>
#include <vector>

namespace higherpair {

/// A branch of a map of boundaries before its coordinates are brought into the range.
struct BranchDraft {
  MapBranch branch;
  TracePath path;
};

/// The curves of tangencies, cut into branches.
struct BoundaryCuts {
  std::vector<BranchDraft> drafts;
  std::vector<MapEvent> events;  ///< that the drafts' ends name
  bool complete = true;          ///< false: a curve was lost
  bool idle = false;  ///< a curve was left out along which the follower does not change the bodies' distance
};

/// Follows all curves of tangencies and cuts them where ∂gap/∂q or κ1 + κ2 changes its sign, so that u rises
/// or falls all along a branch.
/// \param motions    a pair with the motions of the two bodies
/// \param unbounded  as of map_contacts
/// \param range      that may be told to stop; the cuts are then incomplete
[[nodiscard]] BoundaryCuts cut_curves(const BoundaryTrace& trace, const ContactPair& motions,
                                      const std::array<bool, 2>& unbounded, const MapRange& range);

}  // namespace higherpair
