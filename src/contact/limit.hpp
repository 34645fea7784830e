#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/contact/tracker.hpp"

#include <optional>

namespace higherpair {

/// Sets the points and radii of the curves for the normal at.n_W and the coordinates at.u, at.q (where a body
/// is a line, n is set to that of the face); false where a curve has no such point.
[[nodiscard]] bool place_points(const ContactPair& pair, ContactPosition& at);

/// The limit position near a contact, by Newton's method on g = g_φ = g_q = 0; none where it does not
/// converge.
/// \param length  what counts as one unit of a displacement [m]
[[nodiscard]] std::optional<LimitPosition> limit_near(const ContactPair& pair, const ContactPosition& at,
                                                      double length);

}  // namespace higherpair
