#pragma once

#include "higherpair/geometry/boundary.hpp"

namespace higherpair {

/// The boundary with an edge at each end of an open chain: a corner on which the normals turn on by
/// kEdgeTurn, as on any other convex corner, so that ends need no treatment of their own. The flank of a
/// tooth (involute_of) has no edge where it ends: there the next tooth takes over. A closed boundary is
/// returned as it is.
/// \pre one chain
[[nodiscard]] Boundary with_edges(const Boundary& boundary);

/// Whether a span is the edge at an end of an open boundary.
[[nodiscard]] bool is_edge(const Boundary& boundary, int span);

}  // namespace higherpair
