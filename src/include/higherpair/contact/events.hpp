#pragma once

#include "higherpair/contact/tracker.hpp"

#include <optional>

namespace higherpair {

/// The end of a stroke: where the follower is at rest and turns back, dq/du = 0, between the driver
/// position of the track and `u`, to full precision: u is known to (rounding of dq)/|d²q/du²|. None where
/// dq/du has the same sign at both ends, or the contact is lost between them. At most one end of several is
/// found; rows that follow the motion closely have one at most between them.
[[nodiscard]] std::optional<ContactPosition> stroke_end(const ContactTrack& track, double u);

/// The conforming contact near a position: κ1 + κ2 = 0 where a convex and a concave curve of equal radius
/// touch, gap = ∂gap/∂φ = ∂²gap/∂φ² = 0. There two contacts of the pair merge, and the motion has no
/// acceleration. By Newton's method on these three in (φ, q, u) with ∂²gap/∂φ² = -(ρ1 + ρ2), dρ/dφ from the
/// conics. Rates are left 0. None where a body is a line or a point, both are circles, or the iteration does
/// not converge; the solution may lie far from `at`: its distance is for the caller to judge.
/// \param length  what counts as one unit of a displacement [m]
[[nodiscard]] std::optional<ContactPosition> conforming_near(const ContactPair& pair,
                                                             const ContactPosition& at, double length);

}  // namespace higherpair
