#pragma once

#include <algorithm>
#include <cmath>

namespace higherpair {

/// The cubic through values at 0 and 1 with the derivatives there (Hermite's interpolation).
struct HermiteCubic {
  double f0 = 0, d0 = 0;  ///< value and derivative at 0
  double f1 = 0, d1 = 0;  ///< and at 1

  [[nodiscard]] double operator()(double t) const {
    const double u = 1 - t;
    return f0 * u * u * (1 + 2 * t) + f1 * t * t * (3 - 2 * t) + t * u * (d0 * u - d1 * t);
  }

  /// Where it is least between 0 and 1. \pre d0 < 0 < d1
  [[nodiscard]] double lowest_at() const {
    const double square = 3 * (f1 - f0) - 2 * d0 - d1;  // f0 + d0 t + square t^2 + cube t^3
    const double cube = d0 + d1 - 2 * (f1 - f0);
    return std::clamp(-d0 / (square + std::sqrt(square * square - 3 * cube * d0)), 0.0, 1.0);
  }
};

}  // namespace higherpair
