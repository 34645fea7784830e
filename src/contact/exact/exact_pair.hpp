#pragma once

#include "contact/algebra/contact_pencil.hpp"
#include "contact/algebra/extended.hpp"
#include "higherpair/contact/contact_pair.hpp"

#include <optional>

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/CORE_BigInt.h>
#include <CGAL/CORE_BigRat.h>

// CGAL's number types are confined to the sources of exact decisions.

namespace higherpair {

using Integer = CORE::BigInt;
using Rational = CORE::BigRat;
using Kernel = CGAL::Algebraic_kernel_d_1<Integer>;
using ExactPolynomial = Kernel::Polynomial_1;

/// A pair of curves with integer coefficients. Forms are scaled by positive factors.
struct ExactPair {
  Form<Integer> first;
  Form<Integer> second;  ///< at the coordinate 0 of the chart
  PencilMotion<Integer> motion;
  /// For a hyperbola: the line h with hᵀp > 0 on the side of the branch that belongs to the body.
  std::optional<Vector3c<Integer>> branch1, branch2;
  /// q = 2 atan(t) + offset (turning) or q = unit·t (sliding) for a root t.
  Extended offset = 0;
  Extended unit = 1;
};

/// The doubles of the pair as exact numbers, the driver turned by a rational rotation within 2^-60 of u.
/// \param chart  0, 1, …: each has t = ∞ at another position q
[[nodiscard]] ExactPair make_exact(const ContactPair& pair, double u, int chart);

/// Rewrites a polynomial in z (times z^N, with 2N + 1 coefficients, real for |z| = 1) as one in t = tan(q/2)
/// times (1 + t²)^N; one in q is real already. The result is scaled by a positive factor.
[[nodiscard]] ExactPolynomial to_real(const ComplexPolynomial<Integer>& p, bool turns);

[[nodiscard]] Extended to_extended(const Rational& x);

}  // namespace higherpair
