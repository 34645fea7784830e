#pragma once

namespace higherpair {

/// A piston that moves from its outer dead centre towards the crank's pivot (a slider-crank without offset).
/// With θ the crank's angle from the outer dead centre, crank r, rod l, λ = r/l, q = λ sin θ, w = √(1 - q²),
/// exactly
///     x = r (1 - cos θ) + l (1 - w),   dx/dθ = r sin θ (1 + λ cos θ/w),
/// and by its first two harmonics, w ≈ 1 - q²/2,
///     x = r (1 - cos θ) + r²/(2l) sin² θ,   dx/dθ = r (sin θ + λ/2 sin 2θ),   d²x/dθ² = r (cos θ + λ cos
///     2θ).
/// Largest error |exact - harmonic| over a turn at constant speed, and where it occurs: also at -θ and π ± θ.
struct HarmonicError {
  struct Largest {
    double error = 0;  ///< in units of r, rω, rω² for x, v, a
    double theta = 0;  ///< crank angle from the outer dead centre [rad], in [0, π/2]
  };
  Largest x;
  Largest v;
  Largest a;
};

/// To full precision, even where the error is tiny.
///
/// With m = 1/w - 1, μ = 1 - λ² and G(m) = -3λ² + (9μ - 1) m + μ (10 m² + 5 m³ + m⁴), exact - harmonic is
///     x: λ³ sin⁴θ/(2 (1 + w)²),   v: λ m sin θ cos θ,   a: -(m/λ) G(m)/(1 + m)².
/// x is worst at θ = 90°, v where a vanishes, at the one root of G, and a at 90°. (Its other extreme is
/// before that root, where -G/(1 + m)² <= 3λ² (1 - m/m_root) if λ² <= 8/9, and m (-G)/(1 + m)² <= 9/8 always:
/// at most 3/4 of it.)
///
/// \param lambda  r/l
/// \pre 0 < lambda < 1.
[[nodiscard]] HarmonicError harmonic_error(double lambda);

}  // namespace higherpair
