#pragma once

#include "higherpair/geometry/body_jerk.hpp"
#include "higherpair/mechanism/constraint_rows.hpp"

#include <vector>

namespace higherpair {

/// Which curves a contact has for the jerk.
enum class ContactShape {
  kTrue,    ///< the curves themselves
  kFrozen,  ///< circles of curvature fixed in the bodies: the equivalent linkage frozen at this instant
};

/// The third derivative of a ConstraintRow: with J = (j_x, j_y, α̇) of a body's frame, in ground,
///     Σ coefficient·J + delta = 0,
/// with the coefficients of the row. The functions append the deltas [m/s³] of the rows that append_rows and
/// append_driver_row append, in their order; the motions of `bodies` must fulfil those rows, up to
/// accelerations.

/// Revolute, prismatic, slot, gears and belts; a line that turns with its body A has the derivatives ω_A d⊥,
/// α_A d⊥ - ω_A² d and (α̇_A - ω_A³) d⊥ - 3 ω_A α_A d of its direction.
void append_jerk_terms(const Mechanism& mechanism, const Joint& joint, const std::vector<BodyMotion>& bodies,
                       std::vector<double>& deltas);

/// Along n, and for a rolling contact along t (see contact_jerk).
void append_jerk_terms(const Mechanism& mechanism, const Contact& contact, const ContactMotion& motion,
                       const std::vector<BodyMotion>& bodies, ContactShape shape,
                       std::vector<double>& deltas);

/// A driver whose acceleration does not change.
void append_driver_jerk_term(const Mechanism& mechanism, const Joint& joint,
                             const std::vector<BodyMotion>& bodies, std::vector<double>& deltas);

}  // namespace higherpair
