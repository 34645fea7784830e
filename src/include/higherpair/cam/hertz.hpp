#pragma once

namespace higherpair {

/// Elastic constants of a body.
struct ElasticMaterial {
  double modulus = 0;  ///< of elasticity, E > 0 [Pa]
  double poisson = 0;  ///< Poisson's ratio ν, 0 <= ν <= 0.5
};

/// Effective modulus E* of two bodies, 1/E* = (1 - ν1²)/E1 + (1 - ν2²)/E2 [Pa] (Johnson, Contact Mechanics,
/// 1985, eq. 4.10).
[[nodiscard]] double contact_modulus(const ElasticMaterial& first, const ElasticMaterial& second);

/// Hertz's pressure between two cylinders with parallel axes, without friction (Johnson, eqs. 4.43 to 4.45):
/// its largest value p0 = √(P E* κ/π) [Pa], in the middle of the strip of contact. 0 without load.
/// \param load       P, force per length of the line of contact, >= 0 [N/m]
/// \param curvature  κ = κ1 + κ2 of the two bodies, > 0: a concave one has κ < 0, a flat one 0 [1/m]
/// \param modulus    E*, see contact_modulus [Pa]
[[nodiscard]] double line_pressure(double load, double curvature, double modulus);

}  // namespace higherpair
