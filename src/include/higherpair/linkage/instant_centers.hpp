#pragma once

#include "higherpair/geometry/pose.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace higherpair {

enum class InstantCenterKind {
  kUndefined,   ///< the two bodies move as one: every point is a centre
  kPoint,       ///< the point that has the same velocity on both
  kAtInfinity,  ///< they translate against each other
};

/// The instant centre (pole) of two bodies of a list, i < j.
struct InstantCenter {
  std::size_t i = 0;
  std::size_t j = 0;
  InstantCenterKind kind = InstantCenterKind::kUndefined;
  Vector2d p_W = Vector2d::Zero();  ///< kPoint: the centre [m]
  /// kAtInfinity: unit direction towards it, perpendicular to the relative velocity (the opposite would do as
  /// well).
  Vector2d u_W = Vector2d::Zero();
};

/// All n(n-1)/2 instant centres, in the order (0,1), (0,2) … (1,2) …, from the bodies' positions, velocities
/// and angular velocities; the ground is a body at rest like any other. The three centres of any three bodies
/// lie on one line (Kennedy's theorem).
///
/// With Δ the difference j - i in velocity at the origin o of body j: p = o + ẑ×Δv/Δω.
/// Δω counts as zero below `kPoleTolerance` times the largest |ω|, Δv below that fraction of the largest
/// velocity in the list (of an origin, or |ω| times the distance of two origins), and Δω also where Δω·size
/// is below that fraction of the largest velocity: the rates come from a chain of groups, with rounding of
/// their own.
/// \param size  of the mechanism [m]
[[nodiscard]] std::vector<InstantCenter> instant_centers(std::span<const BodyMotion> bodies, double size);

}  // namespace higherpair
