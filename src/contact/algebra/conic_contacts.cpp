#include "higherpair/contact/conic_contacts.hpp"

#include "contact/subdivision/support_contacts.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "tangency.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace higherpair {
namespace {

// Whether the follower's motion leaves the distance of the curves unchanged.
bool is_independent(const ContactPair& pair, double u, double size) {
  const OneFreedom& motion = pair.motion2;
  const Pose<double> X_W1 = pose_at(pair.motion1, u);
  if (motion.turns) {
    return is_centered_at(pair.curve2, motion.p_BO, size) ||
           is_centered_at(pair.curve1, X_W1.inverse_times(motion.p_WO), size);
  }
  return slides_along_itself(pair.curve1, X_W1.R_WB, motion.direction_W) ||
         slides_along_itself(pair.curve2, motion.R_WB, motion.direction_W);
}

// Two parabolas with parallel axes touch at infinity whatever q is, so that the discriminant is always 0.
// With x along the axis of the first from its vertex, k = 1/(2ℓ), s = ±1 the sense of the second axis, (x2,
// y2) its vertex: x = k1 y² and x = x2 + s k2 (y - y2)² have a double common point iff s k1 k2 y2² + (k1 - s
// k2) x2 = 0. Multiplied by 4 ℓ1 ℓ2: s y2² + 2 (ℓ2 - s ℓ1) x2 = 0.
Polynomial parallel_parabolas(const TangencyProblem& problem, const Extended& s) {
  const PlacedCurve<double>& first = problem.first_W;
  const PlacedCurve<double>& second = problem.second_at_0;
  const Complex<Extended> axis = complex_of(first.axis_W);
  const Complex<Extended> offset = complex_of(second.vertex_W - first.vertex_W);
  const Extended x2 = dot(axis, offset), y2 = cross(axis, offset);
  const Extended dx = dot(axis, problem.motion.direction), dy = cross(axis, problem.motion.direction);
  const Extended factor = 2 * (Extended(second.semi_latus) - s * Extended(first.semi_latus));
  const Extended zero = 0;
  return {{Extended(s * y2 * y2 + factor * x2), zero},
          {Extended(2 * s * y2 * dy + factor * dx), zero},
          {Extended(s * dy * dy), zero}};
}

// The common point of parabolas with parallel axes: y = -s ℓ1 y2/(ℓ2 - s ℓ1).
std::optional<Tangency> parallel_tangency(const TangencyProblem& problem, const Extended& s,
                                          const Extended& q) {
  const PlacedCurve<double>& first = problem.first_W;
  const Complex<Extended> axis = complex_of(first.axis_W);
  const Complex<Extended> v = complex_of(problem.second_at_0.vertex_W - first.vertex_W);
  const Extended y2 = cross(axis, v) + q * cross(axis, problem.motion.direction);
  const Extended l1 = first.semi_latus;
  const Extended divisor = Extended(problem.second_at_0.semi_latus) - s * l1;
  if (!(abs(divisor) * kFarthestFinite > abs(l1 * y2))) {
    return std::nullopt;
  }
  const Extended y = -s * l1 * y2 / divisor;
  const Complex<Extended> local{Extended(y * y / (2 * l1)), y};
  return Tangency{{q, Extended(0)}, complex_of(first.vertex_W) + axis * local, true};
}

// Whether the discriminant of two conics vanishes for every q.
bool always_tangent(const TangencyProblem& problem, const Polynomial& polynomial) {
  if (problem.first.kind != FormKind::kConic || problem.second.kind != FormKind::kConic) {
    return false;
  }
  const Pencil<Extended> pencil = pencil_of(problem.first, problem.second, problem.motion);
  const long double bc = size_of(pencil.b) * size_of(pencil.c);
  return vanishes(polynomial, bc * bc);
}

// The real position next to a root of the contact polynomial.
std::optional<Coordinate> real_coordinate(const Complex<Extended>& root, bool turns) {
  if (!turns) {
    const bool near = abs(root.im) <= kSplitTangency * (1 + abs(root.re));
    return near ? std::optional<Coordinate>({root.re, Extended(0)}) : std::nullopt;
  }
  const Extended radius = sqrt(norm(root));
  if (radius == 0 || abs(radius - 1) > kSplitTangency) {
    return std::nullopt;
  }
  return Extended(1 / radius) * root;
}

void add(const TangencyProblem& problem, const Tangency& tangency, std::vector<Tangency>& found) {
  for (Tangency& other : found) {
    if (auto middle = merged(problem, tangency, other)) {
      // The same one found again, or a second one that rounding cannot separate from it?
      const bool again = norm(tangency.w - other.w) + norm(tangency.at - other.at) <= Extended(kSameTangency);
      if (!again) {
        middle->exact = false;
        other = *middle;
      }
      return;
    }
  }
  found.push_back(tangency);
}

// Two parabolas, one of which turns, are tangent at infinity wherever their axes are parallel: double roots
// on the unit circle, for which the iteration for all roots would take a hundred sweeps. They are divided out
// at their known values: e^{2iq} is the ratio of the squares of the axes, which are the first entries of the
// forms.
Polynomial without_parallel_axes(const TangencyProblem& problem, Polynomial polynomial) {
  const bool conics = problem.first.kind == FormKind::kConic && problem.second.kind == FormKind::kConic;
  if (!conics || problem.first_W.q != 0 || problem.second_at_0.q != 0 || !problem.motion.turns) {
    return polynomial;
  }
  const auto axis2 = [](const Form<Extended>& form) {  // its square, whichever side the body is
    return form.S[0][1].re < 0 ? -form.S[0][0] : form.S[0][0];
  };
  const Complex<Extended> ratio = axis2(problem.second) * conj(axis2(problem.first));
  const Complex<Extended> z = square_root(Extended(1 / sqrt(norm(ratio))) * ratio);
  divide_out(polynomial, z);
  divide_out(polynomial, -z);
  return polynomial;
}

Polynomial condition_of(const TangencyProblem& problem) {
  return without_parallel_axes(problem, contact_polynomial(problem.first, problem.second, problem.motion));
}

RootsAsked roots_asked(const TangencyProblem& problem) {
  return problem.motion.turns ? RootsAsked::kOfUnitSize : RootsAsked::kReal;
}

// All tangencies, including those on the wrong branches of hyperbolas; none if every q satisfies the
// condition.
std::optional<std::vector<Tangency>> find_tangencies(const TangencyProblem& problem,
                                                     const Polynomial& polynomial) {
  std::vector<Tangency> found;
  const PlacedCurve<double>& first = problem.first_W;
  const PlacedCurve<double>& second = problem.second_at_0;
  if (always_tangent(problem, polynomial)) {
    if (first.q != 0 || second.q != 0) {
      return std::nullopt;
    }
    const Extended s = first.axis_W.dot(second.axis_W) < 0 ? -1 : 1;
    for (const Complex<Extended>& root : roots_of(parallel_parabolas(problem, s), RootsAsked::kReal)) {
      const auto at = real_coordinate(root, false);
      if (const auto tangency = at ? parallel_tangency(problem, s, at->re) : std::nullopt) {
        add(problem, *tangency, found);
      }
    }
    return found;
  }
  for (const Complex<Extended>& root : roots_of(polynomial, roots_asked(problem))) {
    if (const auto at = real_coordinate(root, problem.motion.turns)) {
      for (const Tangency& tangency : tangencies_at(problem, *at)) {
        add(problem, tangency, found);
      }
    }
  }
  return found;
}

struct Finder {
  const ContactPair& pair;
  const TangencyProblem& problem;
  double u;

  // Of the 100 digits those below 1e-30 are noise of an exact 0.
  [[nodiscard]] static Vector2d point(const Complex<Extended>& w) {
    const auto clean = [](const Extended& x) { return abs(x) < kNoiseOfZero ? 0.0 : to_double(x); };
    return {clean(w.re), clean(w.im)};
  }

  [[nodiscard]] double coordinate(const Coordinate& at) const {
    const Vector2d rounded = point(at);
    if (!problem.motion.turns) {
      return rounded.x() * problem.length;
    }
    return principal_angle(angle_of(rounded));
  }

  [[nodiscard]] bool on_branches(const Tangency& tangency) const {
    PlacedCurve<double> second = problem.second_at_0;
    const Vector2d at = point(tangency.at);
    if (problem.motion.turns) {
      const Vector2d v = (pair.curve2.vertex_B - pair.motion2.p_BO) / problem.length;
      const Rotation<double> turn{at.x(), at.y()};
      second.vertex_W = turn * v;
      second.axis_W = turn * pair.curve2.axis_B;
    } else {
      second.vertex_W += at.x() * pair.motion2.direction_W;
    }
    return on_branch(problem.first_W, point(tangency.w)) && on_branch(second, point(tangency.w));
  }

  // Whether the interiors of two bodies with opposed normals are disjoint. Two convex bodies are separated by
  // their common tangent. With one concave: f2 >= -λ₀ f1 everywhere if and only if M = λ₀ Q1 + Q2 >= 0
  // (S-lemma); a hyperbola has a branch that does not count, so that the distance is computed instead.
  [[nodiscard]] bool is_free(const Tangency& tangency, double kappa_sum, double q) const {
    if (const auto always = always_free(pair.curve1, pair.curve2)) {
      return *always;
    }
    if (kappa_sum < 0) {
      return false;
    }
    if (pair.curve1.q < 0 || pair.curve2.q < 0) {
      const Separation apart = separation(pair.curve1, pose_at(pair.motion1, u), pair.curve2,
                                          pose_at(pair.motion2, q), kFineGap * problem.length);
      return apart.gap >= -kFreeOverlap * problem.length;
    }
    const Matrix3c<Extended> M = double_member(problem, tangency.at).M;
    // M has its double point at the contact: its sign is that of its quadratic part.
    const Extended lowest = M[0][1].re - sqrt(norm(M[0][0]));
    return lowest >= -kNotDefinite * abs(M[0][1].re);
  }

  [[nodiscard]] CurveContact contact(const Tangency& tangency) const {
    const TangencyShape shape = shape_at(problem, tangency);
    const bool point1 = norm(shape.G1) == 0;
    const bool point2 = norm(shape.G2) == 0;
    CurveContact contact;
    contact.u = u;
    contact.q = coordinate(tangency.at);
    contact.p_W = problem.origin_W + problem.length * point(tangency.w);
    const Complex<Extended> G = point1 ? -shape.G2 : shape.G1;
    contact.n_W = point(Extended(1 / sqrt(norm(G))) * G);
    contact.opposed = point1 || point2 || dot(shape.G1, shape.G2) < 0;
    const double kappa_sum = shape.kappa1 + (contact.opposed ? shape.kappa2 : -shape.kappa2);
    const double kappa = std::max(std::abs(shape.kappa1), std::abs(shape.kappa2));
    contact.conforming = !point1 && !point2 && std::abs(kappa_sum) <= kSameCurvature * kappa;
    const Vector2d w = point(tangency.w);
    const Vector2d v = problem.motion.turns ? perp(w) : pair.motion2.direction_W;
    const double gap_q = contact.n_W.dot(v);
    contact.at_limit =
        (!tangency.exact && !contact.conforming) || std::abs(gap_q) <= kGapQMayVanish * v.norm();
    contact.branch = !contact.opposed || contact.at_limit ? 0 : (gap_q > 0 ? 1 : -1);
    const bool conics = is_conic(pair.curve1) && is_conic(pair.curve2);
    contact.coincident = conics && contact.conforming && double_member(problem, tangency.at).coincident;
    contact.free = contact.opposed && is_free(tangency, contact.conforming ? 0 : kappa_sum, contact.q);
    return contact;
  }
};

bool is_pair(const ContactPair& pair) {
  const bool lines = is_line(pair.curve1) && is_line(pair.curve2);
  const bool points = is_point(pair.curve1) && is_point(pair.curve2);
  return !lines && !points;
}

CurveContacts sorted(std::vector<CurveContact> contacts) {
  std::sort(contacts.begin(), contacts.end(),
            [](const CurveContact& a, const CurveContact& b) { return a.q < b.q; });
  return {ContactsStatus::kComplete, std::move(contacts)};
}

CurveContacts list_all(const ContactPair& pair, double u, const TangencyProblem& problem,
                       const Polynomial& polynomial) {
  const auto found = find_tangencies(problem, polynomial);
  if (!found) {
    return {ContactsStatus::kTangentAtInfinity, {}};
  }
  const Finder finder{pair, problem, u};
  std::vector<CurveContact> contacts;
  for (const Tangency& tangency : *found) {
    if (finder.on_branches(tangency)) {
      contacts.push_back(finder.contact(tangency));
    }
  }
  return sorted(std::move(contacts));
}

// Two convex conics near a rough root, where they touch if they neither overlap nor are apart.
class RoughContact {
public:
  RoughContact(const ContactPair& pair, double u, const TangencyProblem& problem, double q)
      : pair_(pair), u_(u), problem_(problem), q_(q), here_(separation_at(q)) {}

  // Whether they do not touch within rounding of the root.
  [[nodiscard]] bool is_clear() const {
    if (here_.gap == -kInf) {  // their asymptotes cross
      return pair_.motion2.turns && separation_at(q_ + kClearTurn).gap == -kInf &&
             separation_at(q_ - kClearTurn).gap == -kInf;
    }
    double size = problem_.length;
    for (const Curve& curve : {pair_.curve1, pair_.curve2}) {
      size = curve.q == 0 ? size : std::max({size, semi_axes(curve)[0], semi_axes(curve)[1]});
    }
    return std::abs(here_.gap) > kClearGap * size;
  }

  // The contact, if they touch far from a limit and from infinity.
  [[nodiscard]] std::optional<CurveContact> contact() const {
    if (!(std::abs(here_.gap) <= kTouching * problem_.length)) {
      return std::nullopt;
    }
    const PlacedCurve<double> first = place(pair_.curve1, pose_at(pair_.motion1, u_));
    const Vector2d v_W = velocity_per_q(pair_.motion2, support_point(first, here_.n_W).p_W);
    const double gap_q = here_.n_W.dot(v_W);
    const int branch = gap_q > 0 ? 1 : -1;
    const ContactResult solved = solve_contact(pair_, u_, q_, here_.n_W, branch);
    const double far = (solved.at.p1_W - problem_.origin_W).norm();
    if (!(std::abs(gap_q) > kClearlyMoves * v_W.norm()) || solved.status != ContactStatus::kOk ||
        !(coordinate_distance(pair_.motion2, problem_.length, solved.at.q, q_) <= kTouching) ||
        !(far <= kClearlyFinite * problem_.length)) {
      return std::nullopt;
    }
    CurveContact contact;
    contact.u = u_;
    contact.q = pair_.motion2.turns ? principal_angle(solved.at.q) : solved.at.q;
    contact.p_W = solved.at.p1_W;
    contact.n_W = solved.at.n_W;
    contact.opposed = contact.free = true;
    contact.branch = branch;
    return contact;
  }

private:
  [[nodiscard]] Separation separation_at(double q) const {
    return separation(pair_.curve1, pose_at(pair_.motion1, u_), pair_.curve2, pose_at(pair_.motion2, q),
                      kFineGap * problem_.length);
  }

  const ContactPair& pair_;
  double u_;
  const TangencyProblem& problem_;
  double q_;
  Separation here_;
};

// The free contacts at rough roots; none if a rough root is not sufficient to tell.
std::optional<std::vector<CurveContact>> rough_contacts(const ContactPair& pair, double u,
                                                        const TangencyProblem& problem,
                                                        const Polynomial& polynomial) {
  const auto roots =
      always_tangent(problem, polynomial) ? std::nullopt : simple_roots_of(polynomial, roots_asked(problem));
  if (!roots) {
    return std::nullopt;
  }
  std::vector<CurveContact> contacts;
  for (const Complex<long double>& root : *roots) {
    const bool turns = problem.motion.turns;
    const auto q = static_cast<double>(turns ? std::atan2(root.im, root.re) : root.re * problem.length);
    const RoughContact rough(pair, u, problem, q);
    if (rough.is_clear()) {
      continue;
    }
    const auto contact = rough.contact();
    if (!contact) {
      return std::nullopt;
    }
    contacts.push_back(*contact);
  }
  return contacts;
}

}  // namespace

CurveContacts find_curve_contacts(const ContactPair& pair, double u) {
  if (!is_pair(pair)) {
    return {};
  }
  if (!is_algebraic(pair)) {
    return list_support_contacts(pair, u);
  }
  const TangencyProblem problem = make_problem(pair, u);
  if (is_independent(pair, u, problem.length)) {
    const Coordinate any{Extended(problem.motion.turns ? 1 : 0), Extended(0)};
    const bool touches = !tangencies_at(problem, any).empty();
    return {touches ? ContactsStatus::kTouchesEverywhere : ContactsStatus::kTouchesNowhere, {}};
  }
  return list_all(pair, u, problem, condition_of(problem));
}

CurveContacts find_free_contacts(const ContactPair& pair, double u) {
  const bool conics = is_algebraic(pair) && is_conic(pair.curve1) && is_conic(pair.curve2);
  if (!conics || always_free(pair.curve1, pair.curve2) != true) {
    return find_curve_contacts(pair, u);
  }
  const TangencyProblem problem = make_problem(pair, u);
  if (is_independent(pair, u, problem.length)) {
    return find_curve_contacts(pair, u);
  }
  const Polynomial polynomial = condition_of(problem);
  auto contacts = rough_contacts(pair, u, problem, polynomial);
  return contacts ? sorted(*std::move(contacts)) : list_all(pair, u, problem, polynomial);
}

std::string_view describe(ContactsStatus status) {
  switch (status) {
    case ContactsStatus::kComplete:
      return "every contact is listed";
    case ContactsStatus::kTouchesEverywhere:
      return "the curves touch whatever the follower's position: its joint does not change their distance";
    case ContactsStatus::kTouchesNowhere:
      return "the curves never touch: the follower's joint does not change their distance";
    case ContactsStatus::kTangentAtInfinity:
      return "the hyperbolas share an asymptote whatever the follower's position";
    case ContactsStatus::kUndecided:
      return "there are places at which it is not decided whether the curves touch";
    case ContactsStatus::kNoPair:
      break;
  }
  return "two lines or two points make no contact";
}

}  // namespace higherpair
