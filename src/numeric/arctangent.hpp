#pragma once

#include <array>
#include <cmath>

namespace higherpair {

/// atan2(y, x) [rad] without branches, for doubles and packs alike; accurate to 2 units in the last place.
/// (x, y) must be finite and not (0, 0). With t = min/max of |x|, |y|, and above tan(π/8) t' = (t - 1)/(t +
/// 1) about π/4,
///     atan t = t + t³ P(t²),   |t| <= tan(π/8),
/// P of degree 10 by interpolation at Chebyshev points: relative error 5e-18.
template <class T>
[[nodiscard]] [[gnu::always_inline]] inline T arctangent(const T& y, const T& x) {
  using std::abs;
  using std::copysign;
  constexpr std::array<double, 11> kP{-0.3333333333333333,  0.1999999999999552,   -0.14285714284666542,
                                      0.11111111015256292,  -0.09090904578121085, 0.07692183190760651,
                                      -0.0666451144646022,  0.05858148904795124,  -0.050854496960392584,
                                      0.039231657085083686, -0.019176885636589053};
  constexpr double kTanEighth = 0.41421356237309503;  // tan(π/8)
  constexpr double kQuarterPi = 0.7853981633974483;
  constexpr double kQuarterPiRest = 3.061616997868383e-17;  // π/4 less its double
  const T ax = abs(x);
  const T ay = abs(y);
  const auto steep = ay > ax;
  const T high = select(steep, ay, ax);
  const T low = select(steep, ax, ay);
  const auto wide = low > T(kTanEighth) * high;
  const T t = select(wide, low - high, low) / select(wide, low + high, high);
  const T z = t * t;
  // Pairs of terms do not have to wait for each other.
  const auto pair = [&](std::size_t k) { return T(kP[k]) + T(kP[k + 1]) * z; };
  const T z2 = z * z;
  const T z4 = z2 * z2;
  const T p = (pair(0) + pair(2) * z2) + ((pair(4) + pair(6) * z2) + (pair(8) + T(kP[10]) * z2) * z4) * z4;
  // The angle is base ± (t + tail); each octant has its base, a multiple of π/4.
  const auto left = x < T(0);
  const T turned = select(left, -t, t);
  const T turn = select(steep, -turned, turned);
  const T of_octant = select(wide, T(1), T(0));
  const T first = select(steep, T(2) - of_octant, of_octant);  // in quarters of π
  const T base = select(left, T(4) - first, first);
  const T angle = base * T(kQuarterPi) + (turn + (turn * z * p + base * T(kQuarterPiRest)));
  return copysign(angle, y);
}

}  // namespace higherpair
