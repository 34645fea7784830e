#pragma once

#include "higherpair/numeric/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

namespace higherpair {

// Series p(t) = Σ c_k T_k(t), -1 <= t <= 1. As |T_k| <= 1, its values lie within c_0 ± Σ_{k>0} |c_k|. These
// bounds become as tight as desired when the interval is halved repeatedly: this finds minima and signs
// without missing any.

inline constexpr std::size_t kNodes = 16;

/// Coefficients c_0, c_1, …
using ChebyshevSeries = std::array<double, kNodes>;

/// The points at which a series is interpolated, ascending, excluding the ends: zeros of T_16.
[[nodiscard]] inline double node(std::size_t j) {
  return -std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / kNodes);
}

/// The series with these values at the nodes.
[[nodiscard]] inline ChebyshevSeries interpolate(const ChebyshevSeries& values) {
  // cos(k π (j + 1/2)/16) has 64 different values.
  static const auto cosines = [] {
    std::array<double, 4 * kNodes> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
      table[i] = std::cos(std::numbers::pi * static_cast<double>(i) / (2 * kNodes));
    }
    return table;
  }();
  ChebyshevSeries c{};
  for (std::size_t k = 0; k < kNodes; ++k) {
    for (std::size_t j = 0; j < kNodes; ++j) {
      c[k] += values[j] * cosines[k * (2 * (kNodes - 1 - j) + 1) % cosines.size()];
    }
    c[k] *= (k == 0 ? 1.0 : 2.0) / kNodes;
  }
  return c;
}

/// p(t) by Clenshaw's recurrence.
[[nodiscard]] inline double value_at(const ChebyshevSeries& p, double t) {
  double b1 = 0, b2 = 0;
  for (std::size_t k = kNodes; k-- > 1;) {
    const double b = p[k] + 2 * t * b1 - b2;
    b2 = b1;
    b1 = b;
  }
  return p[0] + t * b1 - b2;
}

[[nodiscard]] inline ChebyshevSeries derivative(const ChebyshevSeries& p) {
  ChebyshevSeries d{};
  for (std::size_t k = kNodes; k-- > 1;) {
    d[k - 1] = (k + 1 < kNodes ? d[k + 1] : 0) + 2 * static_cast<double>(k) * p[k];
  }
  d[0] /= 2;
  return d;
}

/// The same function on the left (side -1) or right (+1) half of the interval.
[[nodiscard]] inline ChebyshevSeries half(const ChebyshevSeries& p, double side) {
  ChebyshevSeries values;
  for (std::size_t j = 0; j < kNodes; ++j) {
    values[j] = value_at(p, (node(j) + side) / 2);
  }
  return interpolate(values);
}

/// Σ_{k>0} |c_k|.
[[nodiscard]] inline double spread(const ChebyshevSeries& p) {
  double sum = 0;
  for (std::size_t k = 1; k < kNodes; ++k) {
    sum += std::abs(p[k]);
  }
  return sum;
}

/// A bound of |p(t)|: Σ |c_k|.
[[nodiscard]] inline double bound_of(const ChebyshevSeries& p) {
  return std::abs(p[0]) + spread(p);
}

/// The first t >= from with p(t) < level. The series represents the part [low, high] of the original
/// interval.
[[nodiscard]] inline std::optional<double> first_below(const ChebyshevSeries& p, double level, double from,
                                                       double low = -1, double high = 1) {
  const double reach = spread(p);
  if (high < from || !(p[0] - reach < level)) {
    return std::nullopt;
  }
  if (p[0] + reach < level || high - low < kNarrowestBelow) {
    return std::max(low, from);
  }
  const double middle = (low + high) / 2;
  const auto left = first_below(half(p, -1), level, from, low, middle);
  return left ? left : first_below(half(p, 1), level, from, middle, high);
}

struct LowestValue {
  double t = 0;
  double value = 0;
};

/// Replaces `best` by lower values of p until none is lower by more than `tolerance`.
inline void find_lower(const ChebyshevSeries& p, double tolerance, LowestValue& best, double low = -1,
                       double high = 1) {
  if (!(p[0] - spread(p) < best.value - tolerance)) {
    return;
  }
  const double middle = (low + high) / 2;
  for (const auto& [t, local] : {std::pair(low, -1.0), std::pair(middle, 0.0), std::pair(high, 1.0)}) {
    const double value = value_at(p, local);
    best = value < best.value ? LowestValue{t, value} : best;
  }
  if (high - low > kNarrowestLower) {
    find_lower(half(p, -1), tolerance, best, low, middle);
    find_lower(half(p, 1), tolerance, best, middle, high);
  }
}

/// The minimum close to `t`, by the zero of the derivative, where the value is insensitive to t.
[[nodiscard]] inline double settled_minimum(const ChebyshevSeries& p, double t) {
  const ChebyshevSeries first = derivative(p);
  const ChebyshevSeries second = derivative(first);
  double best = t;
  for (int i = 0; i < 4; ++i) {
    const double step = -value_at(first, best) / value_at(second, best);
    if (!(value_at(second, best) > 0) || !(std::abs(step) < kNearMinimum) || std::abs(best + step) > 1) {
      return t;
    }
    best += step;
  }
  return best;
}

}  // namespace higherpair
