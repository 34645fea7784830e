#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <optional>

// Where the motion of one pair ends, by Newton's method on its own conditions.

namespace higherpair {

/// A position beyond which the driver cannot go on this branch: gap = ∂gap/∂φ = ∂gap/∂q = 0, or a conforming
/// contact, or where the contact runs off to infinity along an open curve.
struct LimitPosition {
  double u = 0;
  double q = 0;
};

/// The limit position near a contact, by Newton's method on g = g_φ = g_q = 0; none where it does not
/// converge.
/// \param length  what counts as one unit of a displacement [m]
[[nodiscard]] std::optional<LimitPosition> limit_near(const ContactPair& pair, const ContactPosition& at,
                                                      double length);

/// The conforming contact near a position: κ1 + κ2 = 0 where a convex and a concave curve of equal radius
/// touch, gap = ∂gap/∂φ = ∂²gap/∂φ² = 0. There two contacts of the pair merge, and the motion has no
/// acceleration. By Newton's method on these three in (φ, q, u) with ∂²gap/∂φ² = -(ρ1 + ρ2), dρ/dφ from the
/// conics. Rates are left 0. None where a body is a line or a point, both are circles, or the iteration does
/// not converge; the solution may lie far from `at`: its distance is for the caller to judge.
/// \param length  what counts as one unit of a displacement [m]
[[nodiscard]] std::optional<ContactPosition> conforming_near(const ContactPair& pair,
                                                             const ContactPosition& at, double length);

}  // namespace higherpair
