#pragma once

#include "higherpair/geometry/curve.hpp"

namespace higherpair {

/// Arc length of a conic from its vertex to the point whose convex-side normal is turned by ψ from the normal
/// at the vertex, positive for ψ > 0 (counter-clockwise) [m].
///     s(ψ) = ℓ ∫₀^ψ dτ / (cos²τ + q sin²τ)^{3/2}
///          = ℓ [ sin ψ R_F(cos²ψ, w², 1) + (1 - q)/3 sin³ψ R_D(cos²ψ, 1, w²) ],   w² = cos²ψ + q sin²ψ
/// by Carlson's symmetric integrals (DLMF 19.25.14 with the characteristic equal to k² = 1 - q): one form for
/// circle, ellipse, parabola and hyperbola. An ellipse goes on over any number of turns.
/// Lines and points: 0.
/// \param psi  [rad]; for a parabola or hyperbola within its cone of normals
[[nodiscard]] double arc_length(const Curve& curve, double psi);

/// The angle of the convex-side normal at the vertex in the body's frame [rad], in (-π, π]: the direction
/// against axis_B.
[[nodiscard]] double vertex_normal_angle(const Curve& curve);

}  // namespace higherpair
