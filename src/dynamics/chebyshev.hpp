#pragma once

#include "higherpair/dynamics/contact_forces.hpp"
#include "higherpair/geometry/vector.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {

// Series p(t) = Σ c_k T_k(t), -1 <= t <= 1. As |T_k| <= 1, its values lie within c_0 ± Σ_{k>0} |c_k|, and
// they come to lie as near to these bounds as one likes when the interval is halved again and again: that is
// how minima and signs are found without missing one.

inline constexpr std::size_t kNodes = ForceSeries().size();

/// The points at which a series is interpolated, ascending, none of them an end: zeros of T_16.
[[nodiscard]] inline double node(std::size_t j) {
  return -std::cos(kPi * (static_cast<double>(j) + 0.5) / kNodes);
}

/// The series with these values at the nodes.
[[nodiscard]] inline ForceSeries interpolate(const ForceSeries& values) {
  // cos(k π (j + 1/2)/16) has 64 different values.
  static const auto cosines = [] {
    std::array<double, 4 * kNodes> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
      table[i] = std::cos(kPi * static_cast<double>(i) / (2 * kNodes));
    }
    return table;
  }();
  ForceSeries c{};
  for (std::size_t k = 0; k < kNodes; ++k) {
    for (std::size_t j = 0; j < kNodes; ++j) {
      c[k] += values[j] * cosines[k * (2 * (kNodes - 1 - j) + 1) % cosines.size()];
    }
    c[k] *= (k == 0 ? 1.0 : 2.0) / kNodes;
  }
  return c;
}

/// p(t) by Clenshaw's recurrence.
[[nodiscard]] inline double value_at(const ForceSeries& p, double t) {
  double b1 = 0, b2 = 0;
  for (std::size_t k = kNodes; k-- > 1;) {
    const double b = p[k] + 2 * t * b1 - b2;
    b2 = b1;
    b1 = b;
  }
  return p[0] + t * b1 - b2;
}

[[nodiscard]] inline ForceSeries derivative(const ForceSeries& p) {
  ForceSeries d{};
  for (std::size_t k = kNodes; k-- > 1;) {
    d[k - 1] = (k + 1 < kNodes ? d[k + 1] : 0) + 2 * static_cast<double>(k) * p[k];
  }
  d[0] /= 2;
  return d;
}

/// The same function on the left (side -1) or right (+1) half of the interval.
[[nodiscard]] inline ForceSeries half(const ForceSeries& p, double side) {
  ForceSeries values;
  for (std::size_t j = 0; j < kNodes; ++j) {
    values[j] = value_at(p, (node(j) + side) / 2);
  }
  return interpolate(values);
}

/// Σ_{k>0} |c_k|.
[[nodiscard]] inline double spread(const ForceSeries& p) {
  double sum = 0;
  for (std::size_t k = 1; k < kNodes; ++k) {
    sum += std::abs(p[k]);
  }
  return sum;
}

/// The first t >= from with p(t) < level. The series is on the part [low, high] of its first interval.
[[nodiscard]] inline std::optional<double> first_below(const ForceSeries& p, double level, double from,
                                                       double low = -1, double high = 1) {
  constexpr double kNarrow = 1e-14;
  const double reach = spread(p);
  if (high < from || !(p[0] - reach < level)) {
    return std::nullopt;
  }
  if (p[0] + reach < level || high - low < kNarrow) {
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

/// Takes a value of p below best.value - `tolerance` into `best`, if there is one, until none is left.
inline void find_lower(const ForceSeries& p, double tolerance, LowestValue& best, double low = -1,
                       double high = 1) {
  constexpr double kNarrow = 1e-9;
  if (!(p[0] - spread(p) < best.value - tolerance)) {
    return;
  }
  const double middle = (low + high) / 2;
  for (const auto& [t, local] : {std::pair(low, -1.0), std::pair(middle, 0.0), std::pair(high, 1.0)}) {
    const double value = value_at(p, local);
    best = value < best.value ? LowestValue{t, value} : best;
  }
  if (high - low > kNarrow) {
    find_lower(half(p, -1), tolerance, best, low, middle);
    find_lower(half(p, 1), tolerance, best, middle, high);
  }
}

}  // namespace higherpair
