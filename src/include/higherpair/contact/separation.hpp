#pragma once

#include "higherpair/geometry/curve.hpp"
#include "higherpair/geometry/pose.hpp"

#include <optional>

namespace higherpair {

/// Distance of two bodies over their whole boundaries; vectors in ground W.
struct Separation {
  /// Signed distance [m]: > 0 apart, 0 touching, < 0 overlapping; -inf: overlapping however far apart.
  double gap = 0;
  /// The normal (out of body 1) along which it is measured; contact happens there.
  Vector2d n_W = Vector2d::UnitX();
};

/// Signed distance of two bodies at their poses, each convex or concave throughout.
/// With g(n) = (p2 - p1)·n for the points of outward normals n and -n: two convex bodies are apart iff max g
/// > 0, and that maximum is the distance; a convex body is clear of one with a concave curve (in a ring) iff
/// min g > 0. The extreme over all n is found by subdivision: on an arc of normals of half-width d about m,
/// from g'' + g = -(ρ1 + ρ2) and a bound R of ±(ρ1 + ρ2), g is at most R + (g_m - R) cos δ + g'_m sin δ. No
/// extreme is missed. -inf where no common normal exists (the bodies overlap however far they are moved along
/// their opening).
/// \param tolerance  the result is within this of the true distance [m]; > 0
[[nodiscard]] Separation separation(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                                    const Pose<double>& X_W2, double tolerance);

/// Whether two curves that touch with opposed normals leave the interiors of their bodies disjoint, wherever
/// they touch: always for two convex bodies and for a point, never for two concave ones or a line in a ring;
/// none where it depends on the position.
[[nodiscard]] std::optional<bool> always_free(const Curve& curve1, const Curve& curve2);

}  // namespace higherpair
