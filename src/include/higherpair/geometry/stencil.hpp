#pragma once

#include <array>
#include <cstddef>

namespace higherpair {

/// f'(0) from differences of f at ±h, ±2h, ±3h and ±4h: exact for polynomials up to the eighth degree, else
/// with an error of h⁸ f⁽⁹⁾/630.
/// \param f  gives what can be added, and multiplied by a double
/// Fornberg, Generation of finite difference formulas on arbitrarily spaced grids, 1988, table 1.
template <class F>
[[nodiscard]] auto eighth_order_difference(F f, double h) {
  constexpr std::array<double, 4> kWeights{4 / 5.0, -1 / 5.0, 4 / 105.0, -1 / 280.0};
  decltype(f(h)) sum = (f(h) - f(-h)) * (kWeights[0] / h);
  for (std::size_t k = 1; k < kWeights.size(); ++k) {
    const double step = static_cast<double>(k + 1) * h;
    sum += (f(step) - f(-step)) * (kWeights[k] / h);
  }
  return sum;
}

}  // namespace higherpair
