#pragma once

#include "higherpair/linkage/four_bar.hpp"

#include <vector>

namespace higherpair {

/// A position in which a link of a four-bar is at rest while the others move: the two other moving links are
/// in line (crank and coupler at the rocker's limits, coupler and rocker at the crank's) or parallel (crank
/// and rocker at the coupler's). It is a dead point for that link as a driver.
struct FourBarLimit {
  double theta2 = 0;            ///< [rad], in (-π, π]
  double theta3 = 0;            ///< [rad]
  double theta4 = 0;            ///< [rad]
  bool same_direction = false;  ///< the angles of the two others are equal; otherwise they differ by π
  /// Driven by the crank: sign of sin(θ3 - θ4). Both modes meet at the crank's limits; kPlus there.
  AssemblyMode mode = AssemblyMode::kPlus;
  bool change_point = false;  ///< all links are in line: the link may pass through instead of turning back
};

/// All limit positions of a link: none if it turns fully, else two or four (including those mirrored at the
/// ground link), fewer if change points are among them. `theta2` gives them as crank angles, the link's own
/// angle as angles of the link.
///
/// With weights w = (r2, r3, -r4) the loop is w2 u2 + w3 u3 + w4 u4 = r1 u1. For link X, and u_Z = ±u_Y of
/// the two others, a triangle remains: (w_Y ± w_Z) u_Y + w_X u_X = r1 u1. Where w_Y ± w_Z = 0 the link can
/// stay on the ground link while the others swing (the coupler of a parallelogram, a folded kite): of these
/// positions the two in line are given, the change points.
///
/// \pre r1, r2, r3, r4 > 0; `link` is not ground.
[[nodiscard]] std::vector<FourBarLimit> four_bar_limits(const FourBar& linkage, FourBarLink link);

}  // namespace higherpair
