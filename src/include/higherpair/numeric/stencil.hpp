#pragma once

#include <array>
#include <cstddef>

namespace higherpair {

/// f'(0) from differences of f at ±h, ±2h, …, by their weights.
/// \param f  returns a type that can be added, and multiplied by a double
/// Fornberg, Generation of finite difference formulas on arbitrarily spaced grids, 1988, table 1.
template <class F, std::size_t N>
[[nodiscard]] auto weighted_difference(F f, double h, const std::array<double, N>& weights) {
  decltype(f(h)) sum = (f(h) - f(-h)) * (weights[0] / h);
  for (std::size_t k = 1; k < N; ++k) {
    const double step = static_cast<double>(k + 1) * h;
    sum += (f(step) - f(-step)) * (weights[k] / h);
  }
  return sum;
}

/// Four steps to either side: exact for polynomials up to the eighth degree, otherwise with an error of h⁸
/// f⁽⁹⁾/630.
template <class F>
[[nodiscard]] auto eighth_order_difference(F f, double h) {
  return weighted_difference(f, h, std::array{4 / 5.0, -1 / 5.0, 4 / 105.0, -1 / 280.0});
}

/// Three steps to either side: with an error of h⁶ f⁽⁷⁾/140.
template <class F>
[[nodiscard]] auto sixth_order_difference(F f, double h) {
  return weighted_difference(f, h, std::array{3 / 4.0, -3 / 20.0, 1 / 60.0});
}

}  // namespace higherpair
