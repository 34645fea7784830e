#include "polynomial_roots.hpp"

#include "higherpair/geometry/vector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr int kMaxSweeps = 100;
const Extended kNegligible("1e-80");
const Extended kConvergedSquared("1e-120");  // square of the relative correction that ends the iteration

Extended magnitude(const Complex<Extended>& a) {
  return sqrt(norm(a));
}

double log_magnitude(const Complex<Extended>& a) {
  const Extended n = norm(a);
  if (n == 0) {
    return -std::numeric_limits<double>::infinity();
  }
  int exponent = 0;
  const double fraction = to_double(Extended(frexp(n, &exponent)));
  return (std::log(fraction) + exponent * std::log(2.0)) / 2;
}

// Starting values: on each edge of the upper hull of (k, log|c_k|) as many points on a circle as it is long.
std::vector<Complex<Extended>> starting_values(const Polynomial& c) {
  std::vector<double> height;
  for (const auto& coefficient : c) {
    height.push_back(log_magnitude(coefficient));
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
  std::vector<Complex<Extended>> values;
  for (std::size_t edge = 1; edge < hull.size(); ++edge) {
    const std::size_t count = hull[edge] - hull[edge - 1];
    const double slope = (height[hull[edge - 1]] - height[hull[edge]]) / static_cast<double>(count);
    const Extended radius = exp(Extended(slope));
    for (std::size_t i = 0; i < count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count);
      const double angle = 2 * kPi * (share + static_cast<double>(edge) / 7) + 0.7;
      values.push_back({Extended(radius * std::cos(angle)), Extended(radius * std::sin(angle))});
    }
  }
  return values;
}

// p(x) and p'(x).
std::pair<Complex<Extended>, Complex<Extended>> evaluate(const Polynomial& c, const Complex<Extended>& x) {
  Complex<Extended> value = c.back();
  Complex<Extended> slope;
  for (std::size_t k = c.size() - 1; k-- > 0;) {
    slope = slope * x + value;
    value = value * x + c[k];
  }
  return {value, slope};
}

// Aberth's correction of root i: Newton's, with the other roots divided out.
Complex<Extended> correction(const Polynomial& c, const std::vector<Complex<Extended>>& x, std::size_t i) {
  const auto [value, slope] = evaluate(c, x[i]);
  if (norm(value) == 0) {
    return {};
  }
  Complex<Extended> divisor = slope * inverse(value);
  for (std::size_t j = 0; j < x.size(); ++j) {
    const Complex<Extended> d = x[i] - x[j];
    if (j != i && norm(d) != 0) {
      divisor = divisor - inverse(d);
    }
  }
  return norm(divisor) == 0 ? Complex<Extended>{} : inverse(divisor);
}

void iterate(const Polynomial& c, std::vector<Complex<Extended>>& x) {
  std::vector<bool> done(x.size(), false);
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    bool all_done = true;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (done[i]) {
        continue;
      }
      const Complex<Extended> step = correction(c, x, i);
      x[i] = x[i] - step;
      done[i] = norm(step) <= kConvergedSquared * norm(x[i]);
      all_done = all_done && done[i];
    }
    if (all_done) {
      return;
    }
  }
}

}  // namespace

std::vector<Complex<Extended>> roots_of(const Polynomial& coefficients) {
  Extended largest = 0;
  for (const auto& coefficient : coefficients) {
    largest = std::max(largest, magnitude(coefficient));
  }
  const auto matters = [&](const Complex<Extended>& c) { return magnitude(c) > kNegligible * largest; };
  const auto first = std::find_if(coefficients.begin(), coefficients.end(), matters);
  const auto last = std::find_if(coefficients.rbegin(), coefficients.rend(), matters).base();
  if (first == coefficients.end()) {
    return {};
  }
  const Polynomial trimmed(first, last);
  std::vector<Complex<Extended>> x = starting_values(trimmed);
  iterate(trimmed, x);
  x.insert(x.end(), static_cast<std::size_t>(first - coefficients.begin()), Complex<Extended>{});
  return x;
}

bool vanishes(const Polynomial& coefficients, const Extended& scale, int except) {
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    if (static_cast<int>(k) != except && magnitude(coefficients[k]) > kNegligible * scale) {
      return false;
    }
  }
  return true;
}

Extended size_of(const Polynomial& coefficients) {
  Extended sum = 0;
  for (const auto& coefficient : coefficients) {
    sum += magnitude(coefficient);
  }
  return sum;
}

}  // namespace higherpair
