#include "higherpair/contact/conic_intersections.hpp"

#include "extended_form.hpp"
#include "polynomial_roots.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

using Number = Complex<Extended>;

// Both conics about the vertex of the first, in units of `length`.
struct TwoConics {
  const PlacedCurve<double>& first;
  const PlacedCurve<double>& second;
  double length = 1;
  Number axis;
  Extended q, l;
  Form<Extended> other;

  [[nodiscard]] Vector2d in_ground(const Number& w) const {
    return first.vertex_W + length * Vector2d(to_double(w.re), to_double(w.im));
  }

  [[nodiscard]] bool is_on_both(const Number& w) const {
    const Extended off = abs(value_at(other, w)) / sqrt(norm(gradient_at(other, w)));
    return to_double(off) <= kOnCurve * (1 + to_double(Extended(sqrt(norm(w)))));
  }
};

// The lines through the vertex, x = s y, meet y² = 2ℓx - qx² again at (2ℓs² : 2ℓs : 1 + qs²). With
// s = tan(θ/2) = -i (z - 1)/(z + 1), z = e^{iθ}, the far vertex s = ∞ is no exception. Coefficients of
// 1, z, z² of the point's homogeneous coordinates (w, w̄, 1).
std::array<Polynomial, 3> parametrised(const TwoConics& problem) {
  const auto combination = [](const Number& square, const Number& linear, const Number& constant) {
    const Number i_linear{Extended(-linear.im), linear.re};
    return Polynomial{constant - square + i_linear, Extended(2) * (constant + square),
                      constant - square - i_linear};
  };
  const Number one{Extended(1), Extended(0)};
  const Number along = Extended(2 * problem.l) * problem.axis;
  const Number across{Extended(-along.im), along.re};
  return {combination(along, across, {}), combination(conj(along), conj(across), {}),
          combination(problem.q * one, {}, one)};
}

Polynomial quartic(const std::array<Polynomial, 3>& point, const Matrix3c<Extended>& S) {
  Polynomial result(5);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Polynomial term = point[i] * point[j];
      for (std::size_t k = 0; k < term.size(); ++k) {
        result[k] += S[i][j] * term[k];
      }
    }
  }
  return result;
}

std::optional<Number> point_at(const std::array<Polynomial, 3>& point, const Number& z) {
  Vector3c<Extended> p;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = point[i][0] + z * (point[i][1] + z * point[i][2]);
  }
  return finite_point(p);
}

struct Found {
  Number z;
  Number w;
  int multiplicity = 1;
};

Number unit(const Number& z) {
  return Extended(1 / sqrt(norm(z))) * z;
}

bool is_same(const TwoConics& problem, const std::array<Polynomial, 3>& point, const Found& a,
             const Number& z, const Number& w) {
  if (!(to_double(norm(a.w - w)) < kTwoPoints * kTwoPoints)) {
    return false;
  }
  const Number middle = a.z + z;
  if (norm(middle) < Extended(1)) {
    return false;
  }
  const auto between = point_at(point, unit(middle));
  return between && problem.is_on_both(*between);
}

bool coincident(const TwoConics& problem, const std::array<Polynomial, 3>& point) {
  constexpr int kProbes = 9;
  for (int k = 0; k < kProbes; ++k) {
    const Vector2d direction = unit_vector(2 * kPi * k / kProbes + 0.1);
    const auto w = point_at(point, unit(complex_of(direction)));
    if (w && !problem.is_on_both(*w)) {
      return false;
    }
  }
  return true;
}

}  // namespace

ConicIntersections intersect_conics(const Curve& curve1, const Pose<double>& X_W1, const Curve& curve2,
                                    const Pose<double>& X_W2) {
  ConicIntersections result;
  if (!is_conic(curve1) || !is_conic(curve2)) {
    return result;
  }
  const PlacedCurve<double> first = place(curve1, X_W1);
  const PlacedCurve<double> second = place(curve2, X_W2);
  const Vector2d offset = second.vertex_W - first.vertex_W;
  const double size = std::max({offset.norm(), first.semi_latus, second.semi_latus});
  const double length = std::exp2(std::ceil(std::log2(size)));
  const Number v =
      Extended(1 / Extended(length)) * (complex_of(second.vertex_W) - complex_of(first.vertex_W));
  const TwoConics problem{first,
                          second,
                          length,
                          complex_of(first.axis_W),
                          Extended(first.q),
                          Extended(first.semi_latus) / length,
                          form_of(curve2, v, complex_of(second.axis_W), length)};
  const std::array<Polynomial, 3> point = parametrised(problem);
  if (coincident(problem, point)) {
    result.status = IntersectionStatus::kCoincident;
    return result;
  }
  std::vector<Found> found;
  for (const Number& root : roots_of(quartic(point, problem.other.S))) {
    if (norm(root) == 0 || abs(sqrt(norm(root)) - 1) > kSplitCrossing) {
      continue;
    }
    const Number z = unit(root);
    const auto w = point_at(point, z);
    if (!w || !problem.is_on_both(*w)) {
      continue;
    }
    const auto same = std::find_if(found.begin(), found.end(),
                                   [&](const Found& other) { return is_same(problem, point, other, z, *w); });
    if (same != found.end()) {
      ++same->multiplicity;
    } else {
      found.push_back({z, *w, 1});
    }
  }
  for (const Found& each : found) {
    const Vector2d p = problem.in_ground(each.w);
    if (on_branch(first, p) && on_branch(second, p)) {
      result.points.push_back({p, each.multiplicity});
    }
  }
  result.status = IntersectionStatus::kPoints;
  return result;
}

}  // namespace higherpair
