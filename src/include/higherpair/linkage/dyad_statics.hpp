#pragma once

#include "higherpair/geometry/pose.hpp"

// The forces inside a dyad whose two outer joints are held, by moments about points at which an unknown force
// has none: templates over the scalar, for one position or for several at once. What acts on a body apart
// from the dyad's own joints, inertia included, is given by its moment about such a point.

namespace higherpair {

/// What link b of an RRR dyad does to link a at their pin C:
///     arm_a × C = -moment_a,   arm_b × C = moment_b.
/// Not finite where the links are in line.
/// \param arm_a, arm_b        from A (B) to C [m]
/// \param moment_a, moment_b  on link a about A, on link b about B [N m]
template <class T>
[[nodiscard]] inline Vector2<T> rrr_inner_force(const Vector2<T>& arm_a, const Vector2<T>& arm_b,
                                                const T& moment_a, const T& moment_b) {
  const T det = cross(arm_a, arm_b);
  return {-(moment_a * arm_b.x() + moment_b * arm_a.x()) / det,
          -(moment_a * arm_b.y() + moment_b * arm_a.y()) / det};
}

/// What the slider of an RRP dyad, or its line itself, does to the link at its pin C. The line takes nothing
/// along its unit direction u, so that along it the link carries what acts on the slider:
///     C·u = along,   arm × C = -moment.
/// Not finite where the link is square to the line.
/// \param arm     from A to C [m]
/// \param moment  on the link about A [N m]
/// \param along   what acts on the slider along u [N]
template <class T>
[[nodiscard]] inline Vector2<T> rrp_inner_force(const Vector2<T>& arm, const Vector2<T>& u, const T& moment,
                                                const T& along) {
  const T across = -(moment + along * cross(arm, u)) / (arm.x() * u.x() + arm.y() * u.y());
  return {along * u.x() - across * u.y(), along * u.y() + across * u.x()};
}

/// What the slider of an RPR dyad, or the pin B itself, does to the link across its line, along u turned
/// +90°: the guide passes a moment on, so that about A and B only the sum of both is held.
///     s across = -(moment_a + moment_b),   s = (B - A)·u.
/// \param moment_a, moment_b  on the link about A, on the slider about B [N m]
template <class T>
[[nodiscard]] inline T rpr_inner_force(const T& s, const T& moment_a, const T& moment_b) {
  return -(moment_a + moment_b) / s;
}

}  // namespace higherpair
