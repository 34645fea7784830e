#pragma once

#include "higherpair/linkage/driver.hpp"

namespace higherpair {

/// Motion of a piston, from its outer dead centre towards the crank's pivot: a slider-crank without offset.
struct PistonMotion {
  double x = 0;  ///< [m]
  double v = 0;  ///< [m/s]
  double a = 0;  ///< [m/s²]
};

/// With θ the crank's angle from the outer dead centre, λ = r/l, q = λ sin θ, w = √(1 - q²):
///     x = r (1 - cos θ) + l (1 - w),   dx/dθ = r sin θ (1 + λ cos θ/w).
/// \param r  crank [m]
/// \param l  connecting rod [m]
/// \pre 0 < r < l.
[[nodiscard]] PistonMotion exact_piston_motion(double r, double l, const AngleMotion& crank);

/// The first two harmonics, w ≈ 1 - q²/2 by the binomial series:
///     x = r (1 - cos θ) + r²/(2l) sin² θ,   dx/dθ = r (sin θ + r/(2l) sin 2θ),
///     d²x/dθ² = r (cos θ + (r/l) cos 2θ).
/// \pre r >= 0, l > 0.
[[nodiscard]] PistonMotion harmonic_piston_motion(double r, double l, const AngleMotion& crank);

/// The largest error |exact - harmonic| over a turn at constant speed, and where: also at -θ and π ± θ.
struct HarmonicError {
  struct Largest {
    double error = 0;  ///< in units of r, rω, rω² for x, v, a
    double theta = 0;  ///< crank angle from the outer dead centre [rad], in [0, π/2]
  };
  Largest x;
  Largest v;
  Largest a;
};

/// To full precision, also where the error is tiny.
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
