#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <optional>

// Where the motion of a single pair ends, by Newton's method on the pair's own conditions.

namespace higherpair {

/// A position beyond which the driver cannot move on this branch: gap = ∂gap/∂φ = ∂gap/∂q = 0, a conforming
/// contact, or a contact that runs off to infinity along an open curve.
struct LimitPosition {
  double u = 0;
  double q = 0;
};

/// The limit position near a contact, by Newton's method on g = g_φ = g_q = 0; none where it does not
/// converge.
/// \param length  unit of a displacement [m]
[[nodiscard]] std::optional<LimitPosition> limit_near(const ContactPair& pair, const ContactPosition& at,
                                                      double length);

/// The conforming contact near a position: κ1 + κ2 = 0 where a convex and a concave curve of equal radius
/// touch, gap = ∂gap/∂φ = ∂²gap/∂φ² = 0. Two contacts of the pair merge there, and the acceleration is
/// infinite. Solves these three conditions for (φ, q, u) by Newton's method with ∂²gap/∂φ² = -(ρ1 + ρ2) and
/// dρ/dφ from the conics. Rates are left 0. None where a body is a line or a point, both are circles, or the
/// iteration does not converge. The solution may lie far from `at`; the caller has to judge the distance.
/// \param length  unit of a displacement [m]
[[nodiscard]] std::optional<ContactPosition> conforming_near(const ContactPair& pair,
                                                             const ContactPosition& at, double length);

}  // namespace higherpair
