#pragma once

#include "higherpair/geometry/boundary.hpp"

namespace higherpair {

/// An open chain whose ends act as edges: at each a corner on which the normals go on turning, by kEdgeTurn,
/// as they would in front of any other convex corner. So nothing else has to know of ends. The flank of a
/// tooth (involute_of) has no edge where it ends: there the next tooth takes over. A closed boundary as it
/// is. \pre one chain
[[nodiscard]] Boundary with_edges(const Boundary& boundary);

/// Whether a span is the edge at an end of an open boundary.
[[nodiscard]] bool is_edge(const Boundary& boundary, int span);

}  // namespace higherpair
