#pragma once

#include "extended.hpp"

#include <vector>

namespace higherpair {

/// Coefficient of x^k at place k.
using Polynomial = std::vector<Complex<Extended>>;

/// The roots that are asked for: those farther than 1e-3 from there are found roughly only.
enum class RootsAsked { kAll, kOfUnitSize, kReal };

/// All complex roots but those at infinity, a multiple one as often as it counts, by the method of Ehrlich
/// and Aberth from starting values on the radii of the Newton polygon (D. A. Bini, Numerical computation of
/// polynomial zeros by means of Aberth's method, Numer. Algorithms 13, 1996). Simple roots come to nearly the
/// full precision, double ones to more than 20 digits. Coefficients below 1e-80 of the largest at either end
/// count as 0: at the lower end they give roots at 0. Empty for a constant and for the zero polynomial.
[[nodiscard]] std::vector<Complex<Extended>> roots_of(const Polynomial& coefficients,
                                                      RootsAsked asked = RootsAsked::kAll);

/// Divides a polynomial by (x - root), |root| = 1, as often as that is a root to 70 digits, but not more than
/// twice.
void divide_out(Polynomial& coefficients, const Complex<Extended>& root);

/// Whether all coefficients but that of x^`except` (-1: none) are negligible against `scale`.
[[nodiscard]] bool vanishes(const Polynomial& coefficients, long double scale, int except = -1);

/// Σ |coefficient|, a measure of size.
[[nodiscard]] long double size_of(const Polynomial& coefficients);

}  // namespace higherpair
