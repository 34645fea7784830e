#include "exact_decision.hpp"

#include "exact_pair.hpp"
#include "higherpair/contact/certify.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

using Root = Kernel::Algebraic_real_1;

// Decides the signs at the roots of one pair.
class Decider {
public:
  Decider(const ContactPair& pair, const ExactPair& exact) : pair_(pair), exact_(exact) {
    const bool conics = exact.first.kind == FormKind::kConic && exact.second.kind == FormKind::kConic;
    if (conics) {
      set_up_pencil();
    }
    conics_ = conics;
  }

  [[nodiscard]] Decision at(const Root& root) const {
    if (exact_.first.kind == FormKind::kPoint || exact_.second.kind == FormKind::kPoint) {
      return at_point(root);
    }
    return conics_ ? at_member(root) : at_face(root);
  }

private:
  using P = ComplexPolynomial<Integer>;
  using M = std::array<std::array<P, 3>, 3>;

  [[nodiscard]] int sign(const P& p, const Root& root) const {
    return kernel_.sign_at_1_object()(to_real(p, exact_.motion.turns), root);
  }
  // factor1 S1 + factor2 S2(q); the factors have the same order in z.
  [[nodiscard]] M member(const P& factor1, const P& factor2) const {
    const auto moving = moved_primal(exact_.second.S, exact_.motion);
    M result;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        P entry;
        for (const auto& matrix : moving) {
          entry.push_back(matrix[i][j]);
        }
        // S1 is constant: times z² it has the order of the entry.
        P fixed(exact_.motion.turns ? 3 : 1);
        fixed.back() = exact_.first.S[i][j];
        result[i][j] = padded(sum(factor1 * fixed, 1, factor2 * entry), factor1.size() + entry.size() - 1);
      }
    }
    return result;
  }

  static P padded(P p, std::size_t size) {
    p.resize(std::max(size, p.size()));
    return p;
  }

  // Polynomials of the double root λ₀ = n/m: M = m (λ₀ S1 + S2), up to the sign of m.
  struct Member {
    P lambda;  ///< n
    P factor;  ///< m
    P m01;
    P adj01, adj22, trace;  ///< adj22 < 0: definite quadratic part
    std::array<P, 3> kernel;
    P m22;
    P opening;  ///< S1 along the direction of a double line: 0 where that is the axis of a parabola
  };

  [[nodiscard]] Member make_member(const P& n, const P& m) const {
    const M S = member(n, m);
    Member result;
    result.lambda = n;
    result.factor = m;
    result.m01 = S[0][1];
    result.m22 = S[2][2];
    const auto minor = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d, std::size_t e,
                           std::size_t f, std::size_t g,
                           std::size_t h) { return sum(S[a][b] * S[c][d], -1, S[e][f] * S[g][h]); };
    result.adj22 = minor(0, 0, 1, 1, 0, 1, 1, 0);
    result.adj01 = minor(0, 2, 2, 1, 0, 1, 2, 2);
    result.kernel = {minor(0, 1, 1, 2, 0, 2, 1, 1), minor(0, 2, 1, 0, 0, 0, 1, 2), result.adj22};
    const auto& S1 = exact_.first.S;
    result.opening = sum(sum(P{S1[0][0]} * S[1][1], 1, P{S1[1][1]} * S[0][0]), -2, P{S1[0][1]} * S[0][1]);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        result.trace = sum(result.trace, 1, P{exact_.first.A[i][j]} * S[i][j]);
      }
    }
    return result;
  }

  void set_up_pencil() {
    const Pencil<Integer> pencil = pencil_of(exact_.first, exact_.second, exact_.motion);
    const std::size_t size = exact_.motion.turns ? 5 : 1;
    const P a = padded(pencil.a, size);
    const P d = padded(pencil.d, size);
    const P& b = pencil.b;
    const P& c = pencil.c;
    a_sign_ = CGAL::sign(determinant(exact_.first));
    const P E = sum(b * b, -3, a * c);
    simple_ =
        make_member(sum(P{{Integer(9), Integer(0)}} * (a * d), -1, b * c), P{{Integer(2), Integer(0)}} * E);
    triple_ =
        make_member(P{{Integer(-1), Integer(0)}} * b, padded(P{{Integer(3), Integer(0)}} * a, b.size()));
  }

  // Whether a point p (homogeneous, of polynomials) is on the branches that exist; w: sign of its third
  // coordinate.
  [[nodiscard]] bool on_branches(const std::array<P, 3>& p, int w, const Root& root) const {
    if (exact_.branch1) {
      P value;
      for (std::size_t i = 0; i < 3; ++i) {
        value = sum(value, 1, P{(*exact_.branch1)[i]} * p[i]);
      }
      if (sign(value, root) * w <= 0) {
        return false;
      }
    }
    if (exact_.branch2) {
      const P value = on_moving_line(*exact_.branch2, p);
      if (sign(value, root) * w <= 0) {
        return false;
      }
    }
    return true;
  }

  // l(q)ᵀ p with l fixed in body 2.
  [[nodiscard]] P on_moving_line(const Vector3c<Integer>& l, const std::array<P, 3>& p) const {
    const auto one = [](const Complex<Integer>& c, std::size_t place) {
      P result(place + 1);
      result[place] = c;
      return result;
    };
    if (exact_.motion.turns) {
      return padded(sum(sum(one(l[0], 0) * p[0], 1, one(l[1], 2) * p[1]), 1, one(l[2], 1) * p[2]),
                    p[2].size() + 2);
    }
    const Complex<Integer>& d = exact_.motion.direction;
    const P shifted = {l[2], -(l[0] * d + l[1] * conj(d))};
    return sum(sum(P{l[0]} * p[0], 1, P{l[1]} * p[1]), 1, shifted * p[2]);
  }

  [[nodiscard]] Decision at_member(const Root& root) const {
    const int factor = sign(simple_.factor, root);
    const bool triple = factor == 0;
    const Member& member = triple ? triple_ : simple_;
    const int f = triple ? a_sign_ : factor;
    Decision decision;
    decision.opposed = sign(member.lambda, root) * f > 0;
    const int third = sign(member.adj22, root);
    const int trace = sign(member.m01, root) * f;
    const bool outside1 = pair_.curve1.side == Side::kOutside;
    const bool outside2 = pair_.curve2.side == Side::kOutside;
    const bool hyperbola = exact_.branch1 || exact_.branch2;
    if (!decision.opposed || (outside1 && outside2)) {
      decision.free = false;
    } else if (!outside1 && !outside2) {
      decision.free = true;
    } else if (!hyperbola) {
      decision.free = trace > 0 && third <= 0;
    }
    if (third != 0) {
      decision.contacts = on_branches(member.kernel, third, root) ? 1 : 0;
      return decision;
    }
    if (sign(member.adj01, root) != 0) {
      return decision;  // at infinity
    }
    if (trace == 0) {
      // M is the line at infinity twice, or 0: then the curves coincide.
      decision.degenerate = sign(member.m22, root) == 0;
      decision.contacts = decision.degenerate ? 1 : 0;
      return decision;
    }
    // A double line: it meets the first conic in two, one or no points, of which one may be at infinity.
    const int meets = sign(member.trace, root) * trace * f;
    const int far = sign(member.opening, root) == 0 ? 1 : 0;
    decision.contacts = meets > 0 ? 2 - far : (meets == 0 ? 1 : 0);
    decision.degenerate = meets == 0 || hyperbola;
    return decision;
  }

  [[nodiscard]] Decision at_point(const Root& root) const {
    const bool moving = exact_.second.kind == FormKind::kPoint;
    const Vector3c<Integer>& v = (moving ? exact_.second : exact_.first).v;
    std::array<P, 3> p = {P{v[0]}, P{v[1]}, P{v[2]}};
    if (moving && exact_.motion.turns) {
      const Complex<Integer> zero;
      p = {P{zero, zero, v[0]}, P{v[1], zero, zero}, P{zero, v[2], zero}};
    } else if (moving) {
      const Complex<Integer>& d = exact_.motion.direction;
      p[0].push_back(v[2] * d);
      p[1].push_back(v[2] * conj(d));
    }
    Decision decision;
    decision.contacts = on_branches(p, 1, root) ? 1 : 0;
    decision.opposed = true;
    decision.free = true;
    return decision;
  }

  // The contact point is A l.
  [[nodiscard]] Decision at_face(const Root& root) const {
    const bool face_moves = exact_.second.kind == FormKind::kLine;
    const Form<Integer>& conic = face_moves ? exact_.first : exact_.second;
    std::array<P, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = face_moves ? along_moving_line(conic.A[i]) : moving_pole(conic.A, exact_.first.v, i);
    }
    const int third = sign(p[2], root);
    Decision decision;
    if (third == 0) {
      return decision;
    }
    // S (A l) = det(S) l: the normals have the sign of det(S)/p₂.
    decision.contacts = on_branches(p, third, root) ? 1 : 0;
    decision.opposed = CGAL::sign(determinant(conic)) * third < 0;
    const bool inside = pair_.curve1.side == Side::kInside && pair_.curve2.side == Side::kInside;
    decision.free = decision.opposed && inside;
    return decision;
  }

  // rowᵀ l(q) of a line fixed in body 2.
  [[nodiscard]] P along_moving_line(const Vector3c<Integer>& row) const {
    return on_moving_line(exact_.second.v, {P{row[0]}, P{row[1]}, P{row[2]}});
  }

  [[nodiscard]] P moving_pole(const Matrix3c<Integer>& A, const Vector3c<Integer>& l, std::size_t i) const {
    P result;
    for (const auto& matrix : moved_dual(A, exact_.motion)) {
      result.push_back(product(matrix[i], l));
    }
    return result;
  }

  const ContactPair& pair_;
  const ExactPair& exact_;
  Kernel kernel_;
  bool conics_ = false;
  int a_sign_ = 0;
  Member simple_, triple_;
};

double outward(const Extended& x, double towards) {
  return std::nextafter(to_double(x), towards);
}

}  // namespace

bool has_exact_arithmetic() {
  return true;
}

std::optional<std::vector<DecidedRoot>> decide_roots(const ContactPair& pair, double u) {
  constexpr int kCharts = 4;
  for (int chart = 0; chart < kCharts; ++chart) {
    const ExactPair exact = make_exact(pair, u, chart);
    const bool turns = exact.motion.turns;
    const auto condition = contact_polynomial(exact.first, exact.second, exact.motion);
    const ExactPolynomial polynomial = to_real(condition, turns);
    if (polynomial.is_zero()) {
      return std::nullopt;
    }
    if (turns && polynomial.degree() + 1 < static_cast<int>(condition.size())) {
      continue;  // a root at t = ∞
    }
    const Kernel kernel;
    std::vector<std::pair<Root, Kernel::Multiplicity_type>> roots;
    kernel.solve_1_object()(polynomial, std::back_inserter(roots));
    const Decider decider(pair, exact);
    std::vector<DecidedRoot> decided;
    for (const auto& [root, multiplicity] : roots) {
      DecidedRoot each;
      each.decision = decider.at(root);
      each.multiplicity = static_cast<int>(multiplicity);
      const int bits = 200 + std::ilogb(to_double(exact.unit));
      const auto bounds = kernel.approximate_absolute_1_object()(root, bits);
      const auto q_of = [&](const Rational& bound) {
        const Extended t = to_extended(bound);
        return turns ? Extended(2 * atan(t) + exact.offset) : Extended(t * exact.unit);
      };
      each.middle = (q_of(bounds.first) + q_of(bounds.second)) / 2;
      each.q = {outward(q_of(bounds.first), -kInf), outward(q_of(bounds.second), kInf)};
      decided.push_back(each);
    }
    return decided;
  }
  return std::nullopt;
}

}  // namespace higherpair
