#pragma once

#include "higherpair/contact/common_normal.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// The common normals of a body and the ring that it is in at which their gap has a local minimum of at most
/// `reach` [m]: all of them, by subdivision of the normals until the gap's curvature g″ = -(ρ1 + ρ2) - g or
/// its slope has one sign on an arc. Only where the bodies nearly conform over a whole arc, to some 1e-7 of
/// their size, are arcs left undecided. Empty if neither body is a ring, or one is a line.
/// \param reach  may be infinite
[[nodiscard]] std::vector<CommonNormal> least_gaps(const Curve& curve1, const Pose<double>& X_W1,
                                                   const Curve& curve2, const Pose<double>& X_W2,
                                                   double reach);

/// Whether two infinite curves overlap however far out: some normal of the ring is none of the body in it.
[[nodiscard]] bool overlap_far_out(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                                   const Pose<double>& X_W2);

/// The same minimum after the bodies have moved a little; none where it cannot be followed, or is not a
/// minimum any more.
[[nodiscard]] std::optional<CommonNormal> moved_least_gap(const Curve& curve1, const Pose<double>& X_W1,
                                                          const Curve& curve2, const Pose<double>& X_W2,
                                                          const CommonNormal& before);

}  // namespace higherpair
