#include "extended_form.hpp"

#include "higherpair/contact/tolerances.hpp"

#include <cmath>

namespace higherpair {

Complex<Extended> square_root(const Complex<Extended>& a) {
  const Extended r = sqrt(norm(a));
  const Extended re = sqrt(Extended((r + abs(a.re)) / 2));
  const Extended im = re == 0 ? Extended(0) : Extended(a.im / (2 * re));
  if (a.re >= 0) {
    return {re, im};
  }
  return {Extended(abs(im)), a.im < 0 ? Extended(-re) : re};
}

Complex<Extended> complex_of(const Vector2d& v) {
  return {Extended(v.x()), Extended(v.y())};
}

Extended value_at(const Form<Extended>& form, const Complex<Extended>& w) {
  const Vector3c<Extended> p = homogeneous(w);
  return form.kind == FormKind::kLine ? product(form.v, p).re : product(p, form.S * p).re;
}

Complex<Extended> gradient_at(const Form<Extended>& form, const Complex<Extended>& w) {
  const Extended scale = form.kind == FormKind::kLine ? 2 : 4;
  const Vector3c<Extended> p = homogeneous(w);
  const Complex<Extended> half = form.kind == FormKind::kLine ? form.v[0] : product(form.S[0], p);
  return scale * conj(half);
}

Complex<Extended> hessian_times(const Form<Extended>& form, const Complex<Extended>& dw) {
  if (form.kind == FormKind::kLine) {
    return {};
  }
  return Extended(4) * conj(form.S[0][0] * dw + form.S[0][1] * conj(dw));
}

double curvature(const Form<Extended>& form, const Complex<Extended>& G) {
  const Complex<Extended> t{-G.im, G.re};
  const long double n = to_long_double(norm(G));
  return static_cast<double>(to_long_double(dot(t, hessian_times(form, t))) / (n * std::sqrt(n)));
}

std::optional<Complex<Extended>> finite_point(const Vector3c<Extended>& v) {
  const Extended far = norm(v[0]) + norm(v[1]);
  if (norm(v[2]) * (kFarthestFinite * kFarthestFinite) < far || norm(v[2]) == 0) {
    return std::nullopt;
  }
  const Complex<Extended> w = v[0] * inverse(v[2]);
  const Complex<Extended> w_bar = v[1] * inverse(v[2]);
  // The nearest real point, if rounding has made the coordinates not quite conjugate.
  return Extended(0.5) * (w + conj(w_bar));
}

std::vector<Complex<Extended>> points_on_double_line(const Matrix3c<Extended>& M,
                                                     const Form<Extended>& conic) {
  const Extended sign = M[0][1].re < 0 ? -1 : 1;
  const Complex<Extended> m0 = square_root(sign * M[0][0]);
  const Extended n = norm(m0);
  if (n == 0) {
    return {};
  }
  const Extended m2 = dot(m0, sign * M[0][2]) / n;
  const Complex<Extended> foot = Extended(-m2 / (2 * n)) * conj(m0);
  const Complex<Extended> t = Complex<Extended>{Extended(0), Extended(1)} * conj(m0);
  const Vector3c<Extended> along = {t, conj(t), Complex<Extended>{}};
  const Vector3c<Extended> S_along = conic.S * along;
  const Extended a = product(along, S_along).re;
  const Extended b = product(homogeneous(foot), S_along).re;
  const Extended c = value_at(conic, foot);
  const Extended D = b * b - a * c;
  const Extended root = D > 0 ? Extended(sqrt(D)) : Extended(0);
  std::vector<Complex<Extended>> points;
  for (const Extended& numerator : {Extended(-b + root), Extended(-b - root)}) {
    if (a != 0) {
      points.push_back(foot + Extended(numerator / a) * t);
    } else if (b != 0) {
      points.push_back(foot + Extended(-c / (2 * b)) * t);
    }
  }
  return points;
}

}  // namespace higherpair
