#pragma once

#include "higherpair/contact/boundary_contact.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// The contact of opposed normals that Newton's method finds from a place on each boundary, turning followers
/// in (-π, π]; the bodies may cut each other there.
[[nodiscard]] std::optional<BoundaryContact> contact_between(const BoundaryPair& pair, double u,
                                                             const BoundaryPlace& place1,
                                                             const BoundaryPlace& place2);

/// Those from the crossings of the polylines of find_boundary_contacts(), some of them several times.
[[nodiscard]] std::vector<BoundaryContact> contacts_at_crossings(const BoundaryPair& pair, double u);

/// Whether the follower's motion opens and closes it, and the bodies do not cut each other: κ1 + κ2 > 0.
[[nodiscard]] bool is_proper(const BoundaryContact& contact);

/// By rising q.
void sort_by_coordinate(std::vector<BoundaryContact>& contacts);

}  // namespace higherpair
