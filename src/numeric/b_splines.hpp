#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace higherpair {

/// Polynomials c0 + c1 t + … of a degree below kTerms.
template <std::size_t kTerms>
using PolynomialOf = std::array<double, kTerms>;

/// The degree + 1 B-splines that do not vanish between knots k and k + 1, as powers of the distance from knot
/// k: the j-th belongs to control point k - degree + j. Cox and de Boor's recursion (C. de Boor, A Practical
/// Guide to Splines, 2001, chapter IX).
/// \pre degree < kTerms; knots k - degree + 1 … k + degree exist, knot k is below knot k + 1
template <std::size_t kTerms>
[[nodiscard]] std::array<PolynomialOf<kTerms>, kTerms> b_splines_between(const std::vector<double>& knots,
                                                                         std::size_t degree, std::size_t k) {
  // sum += (constant + slope t) p
  const auto add = [](PolynomialOf<kTerms>& sum, const PolynomialOf<kTerms>& p, double constant,
                      double slope) {
    for (std::size_t i = 0; i < kTerms; ++i) {
      sum[i] += constant * p[i] + (i > 0 ? slope * p[i - 1] : 0);
    }
  };
  const auto& u = knots;
  std::array<PolynomialOf<kTerms>, kTerms> b{};
  b[degree][0] = 1;
  for (std::size_t r = 1; r <= degree; ++r) {
    for (std::size_t j = degree - r; j <= degree; ++j) {
      const std::size_t i = k - degree + j;
      PolynomialOf<kTerms> sum{};
      if (j > degree - r) {
        const double width = u[i + r] - u[i];
        add(sum, b[j], (u[k] - u[i]) / width, 1 / width);
      }
      if (j < degree) {
        const double width = u[i + r + 1] - u[i + 1];
        add(sum, b[j + 1], (u[i + r + 1] - u[k]) / width, -1 / width);
      }
      b[j] = sum;
    }
  }
  return b;
}

}  // namespace higherpair
