#pragma once

#include "run_testing.hpp"

#include <cmath>
#include <complex>
#include <vector>

namespace higherpair::testing {

/// Two cranks of 30 mm, 100 mm apart, hold two links that reach so far together: they can be assembled while
/// the tips of the cranks are no farther from each other.
struct CoupledCranks {
  double phase = 0;  ///< of the second crank [rad], which turns back at three times the speed
  double reach = 0;  ///< [mm]

  /// What is left of the reach [mm], the first crank being at `theta`.
  [[nodiscard]] double room(double theta) const {
    const Complex i(0, 1);
    return reach - std::abs(100.0 + 30.0 * std::exp(i * (phase - 3 * theta)) - 30.0 * std::exp(i * theta));
  }
  /// The limits over a turn from a position at which it can be.
  [[nodiscard]] std::vector<double> limits(double start) const {
    constexpr int kParts = 7200;
    std::vector<double> found;
    for (int k = 0; k < kParts; ++k) {
      double a = start + 2 * kPi * k / kParts, b = start + 2 * kPi * (k + 1) / kParts;
      for (int halving = 0; (room(a) > 0) != (room(b) > 0) && halving < 60; ++halving) {
        const double middle = (a + b) / 2;
        ((room(middle) > 0) == (room(a) > 0) ? a : b) = middle;
      }
      if ((room(a) > 0) != (room(b) > 0)) {
        found.push_back(a);
      }
    }
    return found;
  }
};

}  // namespace higherpair::testing
