#pragma once

#include "higherpair/contact/boundary_contact.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// The contact of opposed normals that Newton's method finds from a place on each boundary; q of a turning
/// follower is in (-π, π]. The bodies may overlap there.
[[nodiscard]] std::optional<BoundaryContact> contact_between(const BoundaryPair& pair, double u,
                                                             const BoundaryPlace& place1,
                                                             const BoundaryPlace& place2);

/// Contacts found from the crossings of the polylines of find_boundary_contacts(); some may occur more than
/// once.
[[nodiscard]] std::vector<BoundaryContact> contacts_at_crossings(const BoundaryPair& pair, double u);

/// Whether the follower's motion opens or closes the contact and the bodies do not cut into each other: κ1 +
/// κ2 > 0.
[[nodiscard]] bool is_proper(const BoundaryContact& contact);

/// Sorts by rising q.
void sort_by_coordinate(std::vector<BoundaryContact>& contacts);

}  // namespace higherpair
