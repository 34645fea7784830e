#include "exact_pair.hpp"

#include <cmath>

#include <boost/multiprecision/cpp_int.hpp>

namespace higherpair {
namespace {

using Point = Complex<Rational>;

Point exact(const Vector2d& v) {
  return {Rational(v.x()), Rational(v.y())};
}

Point times(const Point& rotation, const Vector2d& v) {
  return rotation * exact(v);
}

// A rational rotation within 2^-60 of the angle; quarter turns exactly.
Point rational_rotation(double angle) {
  using Number = Extended::Number;
  const Number& quarter = boost::math::constants::half_pi<Number>();
  const Number turns = round(Number(Number(angle) / quarter));
  const Number rest = Number(angle) - turns * quarter;
  // The double nearest to a quarter turn is taken as one.
  const bool is_quarter = abs(rest) <= std::abs(angle) * std::ldexp(1.0, -53);
  Point rotation{Rational(1), Rational(0)};
  if (!is_quarter) {
    const Number scaled = round(Number(ldexp(Number(tan(Number(rest / 2))), 62)));
    const std::string digits = scaled.convert_to<boost::multiprecision::cpp_int>().str();
    const Rational t(Integer(digits.c_str()), Integer(1) << 62);
    const Rational scale = Rational(1) / (Rational(1) + t * t);
    rotation = {Rational((Rational(1) - t * t) * scale), Rational(Rational(2) * t * scale)};
  }
  const int count = ((static_cast<int>(std::lround(std::fmod(turns.convert_to<double>(), 4.0))) % 4) + 4) % 4;
  for (int i = 0; i < count; ++i) {
    rotation = {Rational(-rotation.im), rotation.re};
  }
  return rotation;
}

Integer lcm(const Integer& a, const Integer& b) {
  return a / CGAL::gcd(a, b) * b;
}

// Makes rational numbers integers, by a common positive factor.
struct Common {
  Integer denominator = 1;

  void add(const Rational& x) { denominator = lcm(denominator, CGAL::abs(CORE::denominator(x))); }
  [[nodiscard]] Integer whole(const Rational& x) const {
    return CORE::numerator(x) * (denominator / CORE::denominator(x));
  }
};

Vector3c<Integer> whole(const Vector3c<Rational>& v) {
  Common common;
  for (const Point& x : v) {
    common.add(x.re);
    common.add(x.im);
  }
  Vector3c<Integer> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = {common.whole(v[i].re), common.whole(v[i].im)};
  }
  return result;
}

Form<Integer> whole(const Form<Rational>& form) {
  Form<Integer> result{form.kind, {}, {}, whole(form.v)};
  if (form.kind == FormKind::kPoint) {
    result.A = outer(result.v, result.v);
  } else if (form.kind == FormKind::kLine) {
    result.S = outer(result.v, result.v);
  } else {
    Common common;
    for (const auto& row : form.S) {
      for (const Point& x : row) {
        common.add(x.re);
        common.add(x.im);
      }
    }
    Integer divisor = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        result.S[i][j] = {common.whole(form.S[i][j].re), common.whole(form.S[i][j].im)};
        divisor = CGAL::gcd(CGAL::gcd(divisor, result.S[i][j].re), result.S[i][j].im);
      }
    }
    divisor = CGAL::abs(divisor);
    for (auto& row : result.S) {
      for (Complex<Integer>& x : row) {
        x = {Integer(x.re / divisor), Integer(x.im / divisor)};
      }
    }
    result.A = adjugate(result.S);
  }
  return result;
}

// The half-plane ℓ - q x > 0, on the side of the hyperbola's branch that exists.
std::optional<Vector3c<Integer>> branch_line(const Curve& curve, const Point& v, const Point& u) {
  if (curve.q >= 0) {
    return std::nullopt;
  }
  const Rational q(curve.q);
  return whole(line_form<Rational>(-q * u.re, -q * u.im, Rational(curve.semi_latus) + q * dot(u, v)).v);
}

}  // namespace

ExactPair make_exact(const ContactPair& pair, double u, int chart) {
  const OneFreedom& m1 = pair.motion1;
  const OneFreedom& m2 = pair.motion2;
  const Point turn1 = m1.turns ? rational_rotation(u) : Point{Rational(m1.R_WB.cos), Rational(m1.R_WB.sin)};
  Point v1 = exact(m1.p_WO) - exact(m2.p_WO) + turn1 * (exact(pair.curve1.vertex_B) - exact(m1.p_BO));
  if (!m1.turns) {
    v1 += Rational(u) * exact(m1.direction_W);
  }
  const Point u1 = times(turn1, pair.curve1.axis_B);
  ExactPair result;
  Point turn2{Rational(m2.R_WB.cos), Rational(m2.R_WB.sin)};
  if (m2.turns) {
    turn2 = {Rational(1), Rational(0)};
    const Point step{Rational(3, 5), Rational(4, 5)};
    for (int i = 0; i < chart; ++i) {
      turn2 = turn2 * step;
    }
    result.offset = chart * atan(Extended(4) / 3);
  }
  const Point v2 = turn2 * (exact(pair.curve2.vertex_B) - exact(m2.p_BO));
  const Point u2 = times(turn2, pair.curve2.axis_B);
  result.first = whole(form_of(pair.curve1, v1, u1));
  result.second = whole(form_of(pair.curve2, v2, u2));
  result.branch1 = branch_line(pair.curve1, v1, u1);
  result.branch2 = branch_line(pair.curve2, v2, u2);
  result.motion.turns = m2.turns;
  const Vector3c<Rational> d = {exact(m2.direction_W), {}, {}};
  Common common;
  common.add(d[0].re);
  common.add(d[0].im);
  result.motion.direction = {common.whole(d[0].re), common.whole(d[0].im)};
  result.unit = m2.turns ? Extended(1) : to_extended(Rational(common.denominator));
  return result;
}

ExactPolynomial to_real(const ComplexPolynomial<Integer>& p, bool turns) {
  std::vector<Integer> real;
  if (!turns) {
    for (const auto& c : p) {
      real.push_back(c.re);
    }
    return ExactPolynomial(real.begin(), real.end());
  }
  // z = (1 + it)/(1 - it): Horner's rule, with one more factor 1 - it at each step.
  const ComplexPolynomial<Integer> up = {{Integer(1), Integer(0)}, {Integer(0), Integer(1)}};
  const ComplexPolynomial<Integer> down = {{Integer(1), Integer(0)}, {Integer(0), Integer(-1)}};
  ComplexPolynomial<Integer> result = {p.back()};
  ComplexPolynomial<Integer> power = {{Integer(1), Integer(0)}};
  for (std::size_t k = p.size() - 1; k-- > 0;) {
    power = power * down;
    result = sum(result * up, 1, ComplexPolynomial<Integer>{p[k]} * power);
  }
  for (const auto& c : result) {
    real.push_back(c.re);
  }
  return ExactPolynomial(real.begin(), real.end());
}

Extended to_extended(const Rational& x) {
  const auto convert = [](const Integer& n) { return Extended(n.get_str()); };
  return convert(CORE::numerator(x)) / convert(CORE::denominator(x));
}

}  // namespace higherpair
