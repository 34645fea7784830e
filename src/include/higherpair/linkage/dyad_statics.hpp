#pragma once

#include "higherpair/geometry/pose.hpp"

// Forces inside a dyad whose two outer joints are held, from moments about points at which one unknown force
// has no moment: templates over the scalar, for one position or several at once. All loads on a body other
// than those of the dyad's own joints, inertia included, are given by their moment about such a point.

namespace higherpair {

/// Force of link b of an RRR dyad on link a at their pin C:
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

/// Force of the slider of an RRP dyad, or of its line itself, on the link at its pin C. The line transmits no
/// force along its unit direction u, so the link carries the loads on the slider in that direction:
///     C·u = along,   arm × C = -moment.
/// Not finite where the link is perpendicular to the line.
/// \param arm     from A to C [m]
/// \param moment  on the link about A [N m]
/// \param along   load on the slider along u [N]
template <class T>
[[nodiscard]] inline Vector2<T> rrp_inner_force(const Vector2<T>& arm, const Vector2<T>& u, const T& moment,
                                                const T& along) {
  const T across = -(moment + along * cross(arm, u)) / (arm.x() * u.x() + arm.y() * u.y());
  return {along * u.x() - across * u.y(), along * u.y() + across * u.x()};
}

/// Force of the slider of an RPR dyad, or of the pin B itself, on the link across its line, along u turned
/// +90°. The guide transmits a moment, so that only the sum of the moments about A and B is balanced:
///     s across = -(moment_a + moment_b),   s = (B - A)·u.
/// \param moment_a, moment_b  on the link about A, on the slider about B [N m]
template <class T>
[[nodiscard]] inline T rpr_inner_force(const T& s, const T& moment_a, const T& moment_b) {
  return -(moment_a + moment_b) / s;
}

}  // namespace higherpair
