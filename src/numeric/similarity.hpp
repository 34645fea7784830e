#pragma once

#include <algorithm>
#include <complex>

namespace higherpair {

/// The similarity p -> z p that brings places P nearest to targets T, as complex numbers: Σ|T - z P|² is
/// least for z = Σ P̄T/Σ|P|², of modulus 1 without scaling, real and >= 0 without turning, 1 without both.
/// 0 where a single point is nearest. \param sum  Σ P̄T \param size2  Σ|P|²
[[nodiscard]] inline std::complex<double> best_similarity(const std::complex<double>& sum, double size2,
                                                          bool turn, bool scale) {
  const double far = std::abs(sum);
  if (turn && scale) return size2 > 0 ? sum / size2 : 0;
  if (turn) return far > 0 ? sum / far : 1;
  if (scale) return size2 > 0 ? std::max(0.0, sum.real()) / size2 : 0;
  return 1;
}

}  // namespace higherpair
