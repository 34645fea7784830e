#pragma once

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/contact/tracker.hpp"

#include <optional>

namespace higherpair {

/// Steps of Newton's method below this (of a radian, of a length's unit) change nothing more. Along an axis
/// of ground they may shrink for ever otherwise: a component that is nearly 0 has no rounding to stop at.
inline constexpr double kNoStep = 1e-17;

/// Sets the points and radii of the curves for the normal at.n_W and the coordinates at.u, at.q (where a body
/// is a line, n is set to that of the face); false where a curve has no such point.
[[nodiscard]] bool place_points(const ContactPair& pair, ContactPosition& at);

/// The limit position near a contact, by Newton's method on g = g_φ = g_q = 0; none where it does not
/// converge.
/// \param length  what counts as one unit of a displacement [m]
[[nodiscard]] std::optional<LimitPosition> limit_near(const ContactPair& pair, const ContactPosition& at,
                                                      double length);

}  // namespace higherpair
