#pragma once

#include "extended.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// The coefficient of x^k at index k.
using Polynomial = std::vector<Complex<Extended>>;

/// Which roots are wanted: others, farther than 1e-3 from those, are found only roughly.
enum class RootsAsked { kOfUnitSize, kReal };

/// All complex roots except those at infinity, each as often as its multiplicity, by the method of Ehrlich
/// and Aberth from starting values on the radii of the Newton polygon (D. A. Bini, Numerical computation of
/// polynomial zeros by means of Aberth's method, Numer. Algorithms 13, 1996). Simple roots are found to
/// nearly the full precision, double ones to more than 20 digits. Coefficients at either end that are below
/// 1e-80 of the largest count as 0; at the lower end they give roots at 0. Empty for a constant and for the
/// zero polynomial.
[[nodiscard]] std::vector<Complex<Extended>> roots_of(const Polynomial& coefficients, RootsAsked asked);

/// The roots asked for, to 1e-12, if each of them is proven to be simple and no other root is within 1e-3 of
/// it or of the circle or line on which it lies. The roots of the polynomial must be symmetric about that.
/// Works in long double, and is many times faster than roots_of().
[[nodiscard]] std::optional<std::vector<Complex<long double>>> simple_roots_of(const Polynomial& coefficients,
                                                                               RootsAsked asked);

/// Divides a polynomial by (x - root), |root| = 1, as long as that is a root to 70 digits, but at most twice.
void divide_out(Polynomial& coefficients, const Complex<Extended>& root);

/// Whether all coefficients are negligible against `scale`.
[[nodiscard]] bool vanishes(const Polynomial& coefficients, long double scale);

/// Σ |coefficient|, a measure of size.
[[nodiscard]] long double size_of(const Polynomial& coefficients);

}  // namespace higherpair
