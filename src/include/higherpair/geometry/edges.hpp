#pragma once

#include "higherpair/geometry/boundary.hpp"

namespace higherpair {

/// How far the normal turns on the edge at an end of an open boundary, away from that of the curve there
/// [rad]: the body is taken to be cut off square, as a face ends at the side of a block. A contact that turns
/// further has slipped off. Less than a quarter turn by what costs a contact some 1e-16 of the driver: for a
/// follower that slides across its face a limit position lies there, and rounding would choose between both.
inline constexpr double kEdgeTurn = kPi / 2 - 1e-8;

/// An open chain whose ends act as edges: at each a corner on which the normals go on turning, by kEdgeTurn,
/// as they would in front of any other convex corner. So nothing else has to know of ends. The flank of a
/// tooth (involute_of) has no edge where it ends: there the next tooth takes over. A closed boundary as it
/// is. \pre one chain
[[nodiscard]] Boundary with_edges(const Boundary& boundary);

/// Whether a span is the edge at an end of an open boundary.
[[nodiscard]] bool is_edge(const Boundary& boundary, int span);

}  // namespace higherpair
