#pragma once

#include "higherpair/contact/contact_pair.hpp"

namespace higherpair {

/// Sets the points and radii of the curves for the normal at.n_W and the coordinates at.u, at.q (where a body
/// is a line, n is set to that of the face); false where a curve has no such point.
[[nodiscard]] bool place_points(const ContactPair& pair, ContactPosition& at);

}  // namespace higherpair
