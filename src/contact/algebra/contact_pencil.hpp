#pragma once

#include "complex.hpp"
#include "higherpair/geometry/curve.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

// The algebra of tangency, over any ring T (extended or exact numbers).
//
// A point is p = (w, w̄, 1) with the complex number w = x + iy. A conic is pᵀ S p < 0 in the body, its dual is
// A = adj(S): the lines l with lᵀ A l = 0 touch it. A line l has S = l lᵀ, A = 0; a point p has A = p pᵀ.
// When body 2 turns by q about w = 0, with z = e^{iq}, S becomes D S D and A becomes D⁻¹ A D⁻¹,
// D = diag(1/z, z, 1): every entry takes a power of z. When it slides by q along d, they become TᵀST and
// T⁻¹AT⁻ᵀ with T = I + q N, N = -(d, d̄, 0) e₃ᵀ, N² = 0.

namespace higherpair {

enum class FormKind { kConic, kLine, kPoint };

template <class T>
struct Form {
  FormKind kind = FormKind::kPoint;
  Matrix3c<T> S;  ///< of a conic or line
  Matrix3c<T> A;  ///< of a conic or point
  Vector3c<T> v;  ///< of a line: l with lᵀp < 0 in the body; of a point: p
};

/// The conic A x² + B y² + C xy + D x + E y + F < 0 (coefficients k in this order). S is 4 times that form.
template <class T>
[[nodiscard]] Form<T> conic_form(const std::array<T, 6>& k) {
  Form<T> form{FormKind::kConic, {}, {}, {}};
  const Complex<T> ww{T(k[0] - k[1]), T(-k[2])};
  const Complex<T> mixed{T(k[0] + k[1]), T(0)};
  const Complex<T> linear{k[3], T(-k[4])};
  form.S = {{{ww, mixed, linear},
             {mixed, conj(ww), conj(linear)},
             {linear, conj(linear), Complex<T>{T(T(4) * k[5]), T(0)}}}};
  form.A = adjugate(form.S);
  return form;
}

/// The half-plane a x + b y + c < 0.
template <class T>
[[nodiscard]] Form<T> line_form(const T& a, const T& b, const T& c) {
  const Complex<T> l{a, T(-b)};
  Form<T> form{FormKind::kLine, {}, {}, {l, conj(l), Complex<T>{T(T(2) * c), T(0)}}};
  form.S = outer(form.v, form.v);
  return form;
}

/// The body side (y² + q x² - 2 ℓ x) < 0 with x along the axis u from the vertex v and y across, side = ±1.
/// Up to a positive factor it depends only on the ratio of ℓ and |u|.
template <class T>
[[nodiscard]] Form<T> vertex_form(const T& side, const T& q, const T& l, const Complex<T>& v,
                                  const Complex<T>& u) {
  const T x0 = dot(u, v);
  const T y0 = cross(u, v);
  const T two(2);
  return conic_form<T>(
      {T(side * (u.im * u.im + q * u.re * u.re)), T(side * (u.re * u.re + q * u.im * u.im)),
       T(side * two * (q - T(1)) * u.re * u.im), T(side * two * (y0 * u.im - (q * x0 + l) * u.re)),
       T(side * two * (-y0 * u.re - (q * x0 + l) * u.im)), T(side * (y0 * y0 + (q * x0 + two * l) * x0))});
}

template <class T>
[[nodiscard]] Vector3c<T> homogeneous(const Complex<T>& w) {
  return {w, conj(w), Complex<T>{T(1), T(0)}};
}

template <class T>
[[nodiscard]] Form<T> point_form(const Complex<T>& w) {
  Form<T> form{FormKind::kPoint, {}, {}, homogeneous(w)};
  form.A = outer(form.v, form.v);
  return form;
}

/// The form of a curve with its vertex at v and its axis along u, its lengths divided by `length`: for a
/// conic 4 side (y² + q x² - 2 ℓ x) with x along the axis from the vertex and y across; for a line -2x.
template <class T>
[[nodiscard]] Form<T> form_of(const Curve& curve, const Complex<T>& v, const Complex<T>& u,
                              double length = 1) {
  if (is_point(curve)) {
    return point_form(v);
  }
  if (is_line(curve)) {
    return line_form<T>(T(-u.re), T(-u.im), dot(u, v));
  }
  const T side(curve.side == Side::kInside ? 1 : -1);
  return vertex_form<T>(side, T(curve.q), T(T(curve.semi_latus) / T(length)), v, u);
}

/// How body 2 moves: it turns about w = 0, or slides along `direction`.
template <class T>
struct PencilMotion {
  bool turns = true;
  Complex<T> direction;
};

/// A matrix whose entries are polynomials, as a list of matrices: that at index k is the coefficient of x^k.
/// Turning: x = z, and everything is multiplied by z²; sliding: x = q.
template <class T>
using MatrixPolynomial = std::vector<Matrix3c<T>>;

template <class T>
[[nodiscard]] MatrixPolynomial<T> turned(const Matrix3c<T>& matrix, int sense) {
  constexpr std::array<int, 3> kPower = {-1, 1, 0};
  MatrixPolynomial<T> result(5);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const int power = 2 + sense * (kPower[i] + kPower[j]);
      result[power][i][j] = matrix[i][j];
    }
  }
  return result;
}

/// S(q) of body 2.
template <class T>
[[nodiscard]] MatrixPolynomial<T> moved_primal(const Matrix3c<T>& S, const PencilMotion<T>& motion) {
  if (motion.turns) {
    return turned(S, 1);
  }
  // Nᵀ S = -e₃ (S d)ᵀ
  const Vector3c<T> d = {motion.direction, conj(motion.direction), Complex<T>{}};
  const Vector3c<T> e3 = {Complex<T>{}, Complex<T>{}, Complex<T>{T(1), T(0)}};
  const Vector3c<T> Sd = S * d;
  const Matrix3c<T> linear = T(-1) * (outer(e3, Sd) + outer(Sd, e3));
  Matrix3c<T> square{};
  square[2][2] = product(d, Sd);
  return {S, linear, square};
}

/// A(q) of body 2.
template <class T>
[[nodiscard]] MatrixPolynomial<T> moved_dual(const Matrix3c<T>& A, const PencilMotion<T>& motion) {
  if (motion.turns) {
    return turned(A, -1);
  }
  // -N A = d (A e₃)ᵀ
  const Vector3c<T> d = {motion.direction, conj(motion.direction), Complex<T>{}};
  return {A, outer(d, A[2]) + outer(A[2], d), A[2][2].re * outer(d, d)};
}

template <class T>
using ComplexPolynomial = std::vector<Complex<T>>;

template <class T>
[[nodiscard]] ComplexPolynomial<T> operator*(const ComplexPolynomial<T>& a, const ComplexPolynomial<T>& b) {
  ComplexPolynomial<T> c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].re == T(0) && a[i].im == T(0)) {  // most coefficients of a constant
      continue;
    }
    for (std::size_t j = 0; j < b.size(); ++j) {
      c[i + j] += a[i] * b[j];
    }
  }
  return c;
}

template <class T>
[[nodiscard]] ComplexPolynomial<T> traces(const Matrix3c<T>& fixed, const MatrixPolynomial<T>& moving) {
  ComplexPolynomial<T> result;
  for (const Matrix3c<T>& matrix : moving) {
    result.push_back(product(fixed, matrix));
  }
  return result;
}

template <class T>
[[nodiscard]] T determinant(const Form<T>& conic) {
  return product(conic.S[0], conic.A[0]).re;
}

/// det(λ S1 + S2(q)) = a λ³ + b λ² + c λ + d; the constants a and d are stored as polynomials of the same
/// kind as b and c.
template <class T>
struct Pencil {
  ComplexPolynomial<T> a, b, c, d;
};

template <class T>
[[nodiscard]] Pencil<T> pencil_of(const Form<T>& first, const Form<T>& second,
                                  const PencilMotion<T>& motion) {
  const std::size_t one = motion.turns ? 2 : 0;
  Pencil<T> pencil;
  pencil.a.resize(one + 1);
  pencil.a[one].re = determinant(first);
  pencil.d.resize(one + 1);
  pencil.d[one].re = determinant(second);
  pencil.b = traces(first.A, moved_primal(second.S, motion));
  pencil.c = traces(first.S, moved_dual(second.A, motion));
  return pencil;
}

/// a + s b, the shorter one padded with zeros.
template <class T>
[[nodiscard]] ComplexPolynomial<T> sum(ComplexPolynomial<T> a, int s, const ComplexPolynomial<T>& b) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t k = 0; k < b.size(); ++k) {
    a[k] += T(s) * b[k];
  }
  return a;
}

/// Discriminant of the cubic: b²c² - 4ac³ - 4b³d + 18abcd - 27a²d². In z it is z⁸ times a Laurent polynomial.
template <class T>
[[nodiscard]] ComplexPolynomial<T> discriminant(const Pencil<T>& pencil) {
  const auto& [a, b, c, d] = pencil;
  const ComplexPolynomial<T> bc = b * c;
  const ComplexPolynomial<T> ad = a * d;
  const ComplexPolynomial<T> cubes = sum(a * (c * (c * c)), 1, d * (b * (b * b)));
  return sum(sum(sum(bc, 18, ad) * bc, -4, cubes), -27, ad * ad);
}

/// lᵀ p for a line and a point, one of which moves; as a polynomial in z it is multiplied by z.
template <class T>
[[nodiscard]] ComplexPolynomial<T> incidence(const Form<T>& first, const Form<T>& second,
                                             const PencilMotion<T>& motion) {
  const bool point_moves = second.kind == FormKind::kPoint;
  if (motion.turns) {
    // (z, 1/z, 1) times a point, (1/z, z, 1) times a line.
    const std::size_t up = point_moves ? 0 : 1;
    ComplexPolynomial<T> result(3);
    result[2] = first.v[up] * second.v[up];
    result[0] = first.v[1 - up] * second.v[1 - up];
    result[1] = first.v[2] * second.v[2];
    return result;
  }
  const Vector3c<T> d = {motion.direction, conj(motion.direction), Complex<T>{}};
  // A moved point is p + q p₃ d: where its coordinates have been multiplied by p₃ to make them whole, so is
  // d.
  const Complex<T> per_q =
      point_moves ? product(first.v, d) * second.v[2] : -(product(second.v, d) * first.v[2]);
  return {product(first.v, second.v), per_q};
}

/// The polynomial in z or q whose roots on the unit circle, or real roots, are the candidates for contact.
/// \pre not two lines and not two points
template <class T>
[[nodiscard]] ComplexPolynomial<T> contact_polynomial(const Form<T>& first, const Form<T>& second,
                                                      const PencilMotion<T>& motion) {
  const bool conic1 = first.kind == FormKind::kConic;
  const bool conic2 = second.kind == FormKind::kConic;
  if (conic1 && conic2) {
    return discriminant(pencil_of(first, second, motion));
  }
  if (!conic1 && !conic2) {
    return incidence(first, second, motion);
  }
  // lᵀ A l of the line and the conic, or pᵀ S p of the point and the conic.
  const bool line = (conic1 ? second : first).kind == FormKind::kLine;
  if (conic1) {
    return line ? traces(first.A, moved_primal(second.S, motion))
                : traces(first.S, moved_dual(second.A, motion));
  }
  return line ? traces(first.S, moved_dual(second.A, motion))
              : traces(first.A, moved_primal(second.S, motion));
}

}  // namespace higherpair
