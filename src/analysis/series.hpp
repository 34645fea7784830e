#pragma once

#include "higherpair/analysis/derivatives.hpp"

#include <boost/math/differentiation/autodiff.hpp>

// Power series in time, cut off behind the highest derivative.

namespace higherpair {

using Series = boost::math::differentiation::autodiff_fvar<double, kHighestDerivative>;
using Coefficients = std::array<double, kHighestDerivative + 1>;

inline constexpr std::array<double, 7> kFactorials{1, 1, 2, 6, 24, 120, 720};
static_assert(kFactorials.size() > kHighestDerivative);

[[nodiscard]] inline Series series_of(const Coefficients& coefficients) {
  const auto t = boost::math::differentiation::make_fvar<double, kHighestDerivative>(0.0);
  Series sum(coefficients.back());
  for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
    sum = sum * t + coefficients[k];
  }
  return sum;
}

[[nodiscard]] inline double coefficient(const Series& series, std::size_t k) {
  return series.derivative(k) / kFactorials[k];
}

[[nodiscard]] inline Coefficients rate_of(const Coefficients& c) {
  Coefficients rate{};
  for (std::size_t k = 1; k < c.size(); ++k) {
    rate[k - 1] = static_cast<double>(k) * c[k];
  }
  return rate;
}

/// What has this rate and begins at 0.
[[nodiscard]] inline Series integral_of(const Series& rate) {
  Coefficients c{};
  for (std::size_t k = 1; k < c.size(); ++k) {
    c[k] = coefficient(rate, k - 1) / static_cast<double>(k);
  }
  return series_of(c);
}

}  // namespace higherpair
