#pragma once

#include "higherpair/contact/common_normal.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// The common normals of a body and the ring that it is in at which their gap has a local minimum of at most
/// `reach` [m]: the zeros of g′(φ) = (p2 - p1)·t at which it rises, g″ = -(ρ1 + ρ2) - g > 0, isolated by
/// halving arcs of normals until the sign of g′ on each is that of a cubic. Empty if neither body is a ring,
/// or one is a line. \param reach  may be infinite \param known  the normal of a minimum that is left out,
/// such as that of a contact; may be null
[[nodiscard]] std::vector<CommonNormal> least_gaps(const Curve& curve1, const Pose<double>& X_W1,
                                                   const Curve& curve2, const Pose<double>& X_W2,
                                                   double reach, const Vector2d* known = nullptr);

/// Whether two infinite curves overlap however far out: some normal of the ring is none of the body in it.
[[nodiscard]] bool overlap_far_out(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                                   const Pose<double>& X_W2);

/// The same minimum after the bodies have moved a little; none where it cannot be followed, or is not a
/// minimum any more.
[[nodiscard]] std::optional<CommonNormal> moved_least_gap(const Curve& curve1, const Pose<double>& X_W1,
                                                          const Curve& curve2, const Pose<double>& X_W2,
                                                          const CommonNormal& before);

}  // namespace higherpair
