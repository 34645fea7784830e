#include "polynomial_roots.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/pose.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr int kMaxSweeps = 100;

// The built-in number of the widest range, which includes a root to the power of 16.
using Rough = long double;
using RoughComplex = Complex<Rough>;
using RoughComplexes = std::vector<RoughComplex>;

RoughComplex rough(const RoughComplex& a) {
  return a;
}

RoughComplex rough(const Complex<Extended>& a) {
  return {to_long_double(a.re), to_long_double(a.im)};
}

// Starting values: for each edge of the upper hull of (k, log|c_k|), as many points on a circle as the edge
// is long.
RoughComplexes starting_values(const Polynomial& c) {
  std::vector<double> height;
  for (const auto& coefficient : c) {
    height.push_back(static_cast<double>(std::log(magnitude(coefficient))));
  }
  std::vector<std::size_t> hull;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const auto below = [&](std::size_t a, std::size_t b) {
      const double left = (height[b] - height[a]) / static_cast<double>(b - a);
      return left <= (height[k] - height[b]) / static_cast<double>(k - b);
    };
    while (hull.size() >= 2 && below(hull[hull.size() - 2], hull.back())) {
      hull.pop_back();
    }
    if (std::isfinite(height[k])) {
      hull.push_back(k);
    }
  }
  RoughComplexes values;
  for (std::size_t edge = 1; edge < hull.size(); ++edge) {
    const std::size_t count = hull[edge] - hull[edge - 1];
    const double slope = (height[hull[edge - 1]] - height[hull[edge]]) / static_cast<double>(count);
    const Rough radius = std::exp(Rough(slope));
    for (std::size_t i = 0; i < count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count);
      const double angle = 2 * kPi * (share + static_cast<double>(edge) / 7) + 0.7;
      values.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
  return values;
}

// p(x) and p'(x).
template <class T>
std::pair<Complex<T>, Complex<T>> evaluate(const std::vector<Complex<T>>& c, const Complex<T>& x) {
  Complex<T> value = c.back();
  Complex<T> slope;
  for (std::size_t k = c.size() - 1; k-- > 0;) {
    slope = slope * x + value;
    value = value * x + c[k];
  }
  return {value, slope};
}

// Aberth's correction of root i: Newton's, with the other roots divided out. Near a simple root these matter
// only in proportion to the correction itself, so that a rough sum over them costs no digits.
template <class T>
Complex<T> correction(const std::vector<Complex<T>>& c, const std::vector<Complex<T>>& x, std::size_t i) {
  const auto [value, slope] = evaluate(c, x[i]);
  if (norm(value) == 0) return {};
  RoughComplex others;
  for (std::size_t j = 0; j < x.size(); ++j) {
    const RoughComplex d = rough(x[i] - x[j]);
    if (j != i && norm(d) != 0) others += inverse(d);
  }
  const Complex<T> divisor = slope * inverse(value) - Complex<T>{T(others.re), T(others.im)};
  return norm(divisor) == 0 ? Complex<T>{} : inverse(divisor);
}

// \param done  roots to leave as they are
template <class T>
void iterate(const std::vector<Complex<T>>& c, std::vector<Complex<T>>& x, const T& converged_squared,
             std::vector<bool> done) {
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    bool all_done = true;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (done[i]) continue;
      const Complex<T> step = correction(c, x, i);
      x[i] = x[i] - step;
      done[i] = norm(step) <= converged_squared * norm(x[i]);
      all_done = all_done && done[i];
    }
    if (all_done) return;
  }
}

RoughComplexes rough(const Polynomial& c) {
  RoughComplexes rough_c;
  for (const auto& coefficient : c) rough_c.push_back(rough(coefficient));
  return rough_c;
}

// The starting values, improved as far as the precision of long double allows.
RoughComplexes rough_roots(const Polynomial& c) {
  const RoughComplexes start = starting_values(c);
  RoughComplexes x = start;
  iterate(rough(c), x, kRoughlyConvergedSquared, std::vector<bool>(x.size(), false));
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::isfinite(x[i].re) && std::isfinite(x[i].im) ? x[i] : start[i];
  }
  return x;
}

Rough magnitude(const RoughComplex& a) {
  return std::hypot(a.re, a.im);
}

// Radius of a disc that contains a root of p: n |p(x_i)| / (|c_n| Π |x_i - x_j|), including the rounding of
// p(x_i). \param rounding  of a sum of products of this type, relative to the sum of their sizes
template <class T>
Rough radius_of_disc(const std::vector<Complex<T>>& c, const std::vector<Complex<T>>& x, std::size_t i,
                     Rough rounding) {
  const Rough at = magnitude(x[i]);
  Rough terms = 0, product = magnitude(c.back());
  for (std::size_t k = c.size(); k-- > 0;) terms = terms * at + magnitude(c[k]);
  for (std::size_t j = 0; j < x.size(); ++j) product *= j == i ? 1 : magnitude(x[i] - x[j]);
  const Rough value = magnitude(evaluate(c, x[i]).first) + rounding * terms;
  return static_cast<Rough>(x.size()) * value / product;
}

// Distance of a value from where roots are asked for.
template <class T>
Rough distance_from_asked(const Complex<T>& x, RootsAsked asked) {
  return std::abs(asked == RootsAsked::kOfUnitSize ? magnitude(x) - 1 : rough(x).im);
}

// Which roots are proven not to be where roots are wanted: connected discs contain as many roots as discs
// (Gershgorin), so a root is elsewhere if no chain of discs connects it with one that reaches there.
std::vector<bool> lying_elsewhere(const Polynomial& c, const std::vector<Complex<Extended>>& x,
                                  RootsAsked asked) {
  std::vector<bool> elsewhere(x.size());
  std::vector<Rough> radii;
  for (std::size_t i = 0; i < x.size(); ++i) radii.push_back(radius_of_disc(c, x, i, kRoundingOfTerms));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Rough nearby = radii[i] + kNearbyRoots * (1 + magnitude(x[i]));
    elsewhere[i] = distance_from_asked(x[i], asked) > nearby;  // false for NaN
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t j = 0; elsewhere[i] && j < x.size(); ++j) {
        if (elsewhere[j] || magnitude(x[i] - x[j]) > radii[i] + radii[j]) continue;
        elsewhere[i] = false;
        changed = true;
      }
    }
  }
  return elsewhere;
}

// Without the coefficients at both ends that count as 0; `zeros` is the number of those at the lower end.
struct Trimmed {
  Polynomial polynomial;
  std::size_t zeros = 0;
};

Trimmed trimmed(const Polynomial& coefficients) {
  long double largest = 0;
  for (const auto& coefficient : coefficients) {
    largest = std::max(largest, magnitude(coefficient));
  }
  const auto matters = [&](const Complex<Extended>& c) {
    return magnitude(c) > kNegligibleCoefficient * largest;
  };
  const auto first = std::find_if(coefficients.begin(), coefficients.end(), matters);
  const auto last = std::find_if(coefficients.rbegin(), coefficients.rend(), matters).base();
  if (first == coefficients.end()) {
    return {};
  }
  return {Polynomial(first, last), static_cast<std::size_t>(first - coefficients.begin())};
}

}  // namespace

std::vector<Complex<Extended>> roots_of(const Polynomial& coefficients, RootsAsked asked) {
  const auto [c, zeros] = trimmed(coefficients);
  if (c.empty()) {
    return {};
  }
  std::vector<Complex<Extended>> x;
  for (const auto& [re, im] : rough_roots(c)) x.push_back({Extended(re), Extended(im)});
  iterate(c, x, Extended(kConvergedSquared), lying_elsewhere(c, x, asked));
  x.insert(x.end(), zeros, Complex<Extended>{});
  return x;
}

std::optional<std::vector<Complex<long double>>> simple_roots_of(const Polynomial& coefficients,
                                                                 RootsAsked asked) {
  const auto [extended_c, zeros] = trimmed(coefficients);
  if (extended_c.empty() || (zeros > 0 && asked == RootsAsked::kReal)) {
    return std::nullopt;
  }
  const RoughComplexes c = rough(extended_c), x = rough_roots(extended_c);
  std::vector<Rough> radii;
  for (std::size_t i = 0; i < x.size(); ++i) radii.push_back(radius_of_disc(c, x, i, kRoughRounding));
  RoughComplexes found;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Rough off = distance_from_asked(x[i], asked), nearby = kNearbyRoots * (1 + magnitude(x[i]));
    if (off > radii[i] + nearby) continue;
    // A root whose mirror image would be in the same disc is its own mirror image.
    bool alone = off <= radii[i] && radii[i] <= kSharpRoot * (1 + magnitude(x[i]));
    for (std::size_t j = 0; j < x.size() && alone; ++j) {
      alone = j == i || magnitude(x[i] - x[j]) > radii[i] + radii[j] + nearby;
    }
    if (!alone) return std::nullopt;  // also for NaN
    found.push_back(x[i]);
  }
  return found;
}

void divide_out(Polynomial& coefficients, const Complex<Extended>& root) {
  for (int i = 0; i < 2 && coefficients.size() > 1; ++i) {
    Polynomial quotient(coefficients.size() - 1);
    Complex<Extended> rest = coefficients.back();
    for (std::size_t k = quotient.size(); k-- > 0;) {
      quotient[k] = rest;
      rest = rest * root + coefficients[k];
    }
    if (!(magnitude(rest) <= kRootRest * size_of(coefficients))) {
      return;
    }
    coefficients = std::move(quotient);
  }
}

bool vanishes(const Polynomial& coefficients, long double scale) {
  return std::none_of(coefficients.begin(), coefficients.end(), [&](const Complex<Extended>& coefficient) {
    return magnitude(coefficient) > kNegligibleCoefficient * scale;
  });
}

long double size_of(const Polynomial& coefficients) {
  long double sum = 0;
  for (const auto& coefficient : coefficients) {
    sum += magnitude(coefficient);
  }
  return sum;
}

}  // namespace higherpair
