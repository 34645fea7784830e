#include "tangency.hpp"

#include "higherpair/contact/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

Coordinate advanced(const TangencyProblem& problem, const Coordinate& at, const Extended& step) {
  if (!problem.motion.turns) {
    return {Extended(at.re + step), Extended(0)};
  }
  // The rotation by 2 atan(step/2).
  const Complex<Extended> half{Extended(1), Extended(step / 2)};
  return at * (half * half) * inverse(Complex<Extended>{norm(half), Extended(0)});
}

using Column = std::array<Extended, 3>;
using Columns = std::array<Column, 3>;

Extended determinant(const Columns& J) {
  const auto& [a, b, c] = J;
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// Newton's method for f1 = f2 = ∇f1 × ∇f2 = 0 in (w, q). It does not improve double roots: a step that
// increases the distance is rejected. \pre two conics
void refine(const TangencyProblem& problem, Tangency& tangency) {
  const Form<Extended>& first = problem.first;
  double distance = shape_at(problem, tangency).distance;
  for (int i = 0; i < 8; ++i) {
    const Form<Extended> second = moved(problem, tangency.at);
    const Complex<Extended>& w = tangency.w;
    const Complex<Extended> G1 = gradient_at(first, w);
    const Complex<Extended> G2 = gradient_at(second, w);
    // Velocity of the material of body 2 at w.
    const Complex<Extended> v =
        problem.motion.turns ? Complex<Extended>{Extended(-w.im), w.re} : problem.motion.direction;
    Complex<Extended> dG2_dq = -hessian_times(second, v);
    if (problem.motion.turns) {
      dG2_dq += Complex<Extended>{Extended(-G2.im), G2.re};
    }
    Columns J;
    for (int k = 0; k < 2; ++k) {
      const Complex<Extended> dw{Extended(k == 0 ? 1 : 0), Extended(k)};
      J[k] = {dot(G1, dw), dot(G2, dw),
              cross(hessian_times(first, dw), G2) + cross(G1, hessian_times(second, dw))};
    }
    J[2] = {Extended(0), -dot(G2, v), cross(G1, dG2_dq)};
    const Column r{value_at(first, w), value_at(second, w), cross(G1, G2)};
    const Extended det = determinant(J);
    if (det == 0) {
      return;
    }
    // Cramer's rule: extended numbers have digits to spare.
    const Column step{determinant({r, J[1], J[2]}) / det, determinant({J[0], r, J[2]}) / det,
                      determinant({J[0], J[1], r}) / det};
    const double length = to_double(abs(step[0]) + abs(step[1]) + abs(step[2]));
    if (!(length < kLongestRefinement) || length < kNoRefinement) {
      return;
    }
    Tangency next = tangency;
    next.w = w - Complex<Extended>{step[0], step[1]};
    next.at = advanced(problem, tangency.at, -step[2]);
    const double next_distance = shape_at(problem, next).distance;
    if (next_distance > distance) {
      return;
    }
    tangency = next;
    distance = next_distance;
  }
}

std::vector<Complex<Extended>> candidate_points(const TangencyProblem& problem, const Form<Extended>& second,
                                                const Coordinate& at) {
  const Form<Extended>& first = problem.first;
  if (first.kind == FormKind::kPoint) {
    return {first.v[0]};
  }
  if (second.kind == FormKind::kPoint) {
    return {second.v[0]};
  }
  std::vector<Complex<Extended>> points;
  if (first.kind == FormKind::kLine || second.kind == FormKind::kLine) {
    const bool line_first = first.kind == FormKind::kLine;
    const Form<Extended>& conic = line_first ? second : first;
    if (const auto pole = finite_point(conic.A * (line_first ? first.v : second.v))) {
      points.push_back(*pole);
    }
    return points;
  }
  const DoubleMember member = double_member(problem, at);
  if (member.coincident) {
    return {complex_of(problem.first_W.vertex_W)};
  }
  const Matrix3c<Extended> adj = adjugate(member.M);
  long double rank2 = 0, rank1 = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      rank2 += magnitude(adj[i][j]);
      rank1 += to_long_double(norm(member.M[i][j]));
    }
  }
  if (const auto kernel = finite_point(adj[2])) {
    points.push_back(*kernel);
  }
  if (rank2 <= kDoubleLine * rank1) {
    const auto more = points_on_double_line(member.M, first);
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

bool touches(const TangencyProblem& problem, const Tangency& tangency) {
  const TangencyShape shape = shape_at(problem, tangency);
  const auto reach = static_cast<double>(1 + magnitude(tangency.w));
  return reach <= kFarthestFinite && shape.distance <= kOnCurve * reach && shape.misalignment <= kAligned;
}

// d dᵀ for d = (z̄, z, 1): a rotation multiplies the entries of a form by its entries.
Matrix3c<Extended> turn_of_pairs(const Coordinate& z) {
  const Complex<Extended> one{Extended(1), Extended(0)}, square = z * z, length{norm(z), Extended(0)};
  return {{{conj(square), length, conj(z)}, {length, square, z}, {conj(z), z, one}}};
}

// Product of symmetric matrices, entry by entry.
Matrix3c<Extended> times_each(const Matrix3c<Extended>& a, const Matrix3c<Extended>& b) {
  Matrix3c<Extended> product;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) product[i][j] = product[j][i] = a[i][j] * b[i][j];
  }
  return product;
}

Matrix3c<Extended> value_of(const MatrixPolynomial<Extended>& m, const Extended& q) {
  return m[0] + q * (m[1] + q * m[2]);
}

// Enlarges a tiny conic to 1e-40 of the length, which moves no contact in the digits of a double: the square
// of a size below 1e-50 is lost in the digits of the extended numbers, to which the curve would be a point.
Curve resolvable(Curve curve, double length) {
  if (is_conic(curve)) {
    const double size = curve.q == 0 ? curve.semi_latus : std::max(semi_axes(curve)[0], semi_axes(curve)[1]);
    curve.semi_latus *= std::max(1.0, kSmallestConic * length / size);
  }
  return curve;
}

}  // namespace

TangencyProblem make_problem(const ContactPair& given, double u) {
  ContactPair pair = given;
  const OneFreedom& motion = pair.motion2;
  TangencyProblem problem;
  problem.origin_W = motion.p_WO;
  problem.motion.turns = motion.turns;
  problem.motion.direction = complex_of(motion.direction_W);
  PlacedCurve<double> first = place(pair.curve1, pose_at(pair.motion1, u));
  double size = (pair.curve2.vertex_B - motion.p_BO).norm();
  size = std::max({size, (first.vertex_W - motion.p_WO).norm(), first.semi_latus, pair.curve2.semi_latus});
  problem.length = size > 0 ? std::exp2(std::ceil(std::log2(size))) : 1;
  pair.curve1 = resolvable(pair.curve1, problem.length);
  pair.curve2 = resolvable(pair.curve2, problem.length);
  first.semi_latus = pair.curve1.semi_latus;
  const auto scaled = [&](const Complex<Extended>& v) { return Extended(1 / Extended(problem.length)) * v; };
  const Complex<Extended> origin = complex_of(motion.p_WO);
  problem.first = form_of(pair.curve1, scaled(complex_of(first.vertex_W) - origin), complex_of(first.axis_W),
                          problem.length);
  const Complex<Extended> turn =
      motion.turns ? Complex<Extended>{Extended(1), Extended(0)}
                   : Complex<Extended>{Extended(motion.R_WB.cos), Extended(motion.R_WB.sin)};
  const Complex<Extended> v = complex_of(pair.curve2.vertex_B) - complex_of(motion.p_BO);
  problem.second =
      form_of(pair.curve2, scaled(turn * v), turn * complex_of(pair.curve2.axis_B), problem.length);
  problem.first_W = first;
  problem.second_at_0 = place(pair.curve2, pose_at(motion, 0));
  for (PlacedCurve<double>* curve : {&problem.first_W, &problem.second_at_0}) {
    curve->vertex_W = (curve->vertex_W - motion.p_WO) / problem.length;
    curve->semi_latus /= problem.length;
  }
  return problem;
}

Form<Extended> moved(const TangencyProblem& problem, const Coordinate& at) {
  Form<Extended> form = problem.second;
  const Extended& q = at.re;
  if (problem.motion.turns) {
    form.S = times_each(turn_of_pairs(at), form.S);
    form.v[0] = (form.kind == FormKind::kLine ? conj(at) : at) * form.v[0];
    form.v[1] = conj(form.v[0]);
    return form;
  }
  form.S = value_of(moved_primal(form.S, problem.motion), q);
  const Complex<Extended> d = q * problem.motion.direction;
  if (form.kind == FormKind::kLine) {
    form.v[2] = form.v[2] - form.v[0] * d - form.v[1] * conj(d);
  } else {
    form.v[0] += d;
    form.v[1] += conj(d);
  }
  return form;
}

Form<Extended> moved_with_dual(const TangencyProblem& problem, const Coordinate& at) {
  Form<Extended> form = moved(problem, at);
  form.A = problem.motion.turns ? times_each(turn_of_pairs(conj(at)), problem.second.A)
                                : value_of(moved_dual(problem.second.A, problem.motion), at.re);
  return form;
}

TangencyShape shape_at(const TangencyProblem& problem, const Tangency& tangency) {
  const Form<Extended> second = moved(problem, tangency.at);
  TangencyShape shape;
  const auto look = [&](const Form<Extended>& form, Complex<Extended>& G, double& kappa) {
    if (form.kind == FormKind::kPoint) {
      shape.distance = std::max(shape.distance, static_cast<double>(magnitude(tangency.w - form.v[0])));
      return;
    }
    G = gradient_at(form, tangency.w);
    kappa = curvature(form, G);
    const long double off = to_long_double(abs(value_at(form, tangency.w))) / magnitude(G);
    shape.distance = std::max(shape.distance, static_cast<double>(off));
  };
  look(problem.first, shape.G1, shape.kappa1);
  look(second, shape.G2, shape.kappa2);
  const long double scale = magnitude(shape.G1) * magnitude(shape.G2);
  if (scale > 0) {
    shape.misalignment = static_cast<double>(to_long_double(abs(cross(shape.G1, shape.G2))) / scale);
  }
  return shape;
}

DoubleMember double_member(const TangencyProblem& problem, const Coordinate& at) {
  const Form<Extended> second = moved_with_dual(problem, at);
  const Form<Extended>& first = problem.first;
  const Extended a = determinant(first);
  const Extended b = product(first.A, second.S).re;
  const Extended c = product(first.S, second.A).re;
  const Extended d = determinant(second);
  // The double root is a root of the derivative as well.
  const Extended D = b * b - 3 * a * c;
  const Extended root = D > 0 ? Extended(sqrt(D)) : Extended(0);
  const auto value = [&](const Extended& l) { return Extended(abs(((a * l + b) * l + c) * l + d)); };
  const Extended one = (-b + root) / (3 * a);
  const Extended other = (-b - root) / (3 * a);
  const Matrix3c<Extended> scaled = (value(one) < value(other) ? one : other) * first.S;
  DoubleMember member;
  member.M = scaled + second.S;
  Extended left = 0;
  Extended whole = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      left += norm(member.M[i][j]);
      whole += norm(scaled[i][j]) + norm(second.S[i][j]);
    }
  }
  member.coincident = left <= kOnCurve * kOnCurve * whole;
  return member;
}

std::vector<Tangency> tangencies_at(const TangencyProblem& problem, const Coordinate& at) {
  const Form<Extended> second = moved_with_dual(problem, at);
  const bool conics = problem.first.kind == FormKind::kConic && second.kind == FormKind::kConic;
  std::vector<Tangency> found;
  for (const Complex<Extended>& w : candidate_points(problem, second, at)) {
    Tangency tangency{at, w, true};
    if (conics) {
      refine(problem, tangency);
    }
    tangency.exact = shape_at(problem, tangency).distance <= kExactTangency;
    const bool new_one = std::none_of(found.begin(), found.end(), [&](const Tangency& other) {
      return merged(problem, tangency, other).has_value();
    });
    if (new_one && touches(problem, tangency)) {
      found.push_back(tangency);
    }
  }
  return found;
}

bool has_finite_point(const TangencyProblem& problem, const Coordinate& at) {
  const Form<Extended> second = moved_with_dual(problem, at);
  if (problem.first.kind == FormKind::kConic && second.kind == FormKind::kConic) {
    const Matrix3c<Extended> adj = adjugate(double_member(problem, at).M);
    return finite_point(adj[2]).has_value();
  }
  return !candidate_points(problem, second, at).empty();
}

std::optional<Tangency> merged(const TangencyProblem& problem, const Tangency& a, const Tangency& b) {
  const double apart = to_double(norm(a.w - b.w) + norm(a.at - b.at));
  if (!(apart < kTwoTangencies)) {
    return std::nullopt;
  }
  Tangency middle = a;
  middle.w = Extended(0.5) * (a.w + b.w);
  middle.at = a.at + b.at;
  const Extended scale = problem.motion.turns ? Extended(sqrt(norm(middle.at))) : Extended(2);
  middle.at = Extended(1 / scale) * middle.at;
  // From the middle of the chord onto the curve.
  for (int i = 0; i < 2 && problem.first.kind != FormKind::kPoint; ++i) {
    const Complex<Extended> G = gradient_at(problem.first, middle.w);
    middle.w = middle.w - Extended(value_at(problem.first, middle.w) / norm(G)) * G;
  }
  return touches(problem, middle) ? std::optional(middle) : std::nullopt;
}

}  // namespace higherpair
