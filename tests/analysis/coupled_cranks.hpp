#pragma once

#include "run_testing.hpp"

#include <cmath>
#include <complex>
#include <vector>

namespace higherpair::testing {

/// Two cranks of 30 mm on pivots 100 mm apart carry two links, which join the tips of the cranks. The
/// mechanism can be assembled while the distance of the tips is at most `reach`, the length of both links
/// together.
struct CoupledCranks {
  double phase = 0;  ///< of the second crank [rad], which turns back at three times the speed
  double reach = 0;  ///< [mm]

  /// What is left of the reach [mm] with the first crank at `theta`; negative where it cannot be assembled.
  [[nodiscard]] double room(double theta) const {
    const Complex i(0, 1);
    return reach - std::abs(100.0 + 30.0 * std::exp(i * (phase - 3 * theta)) - 30.0 * std::exp(i * theta));
  }
  /// The limits over one turn from `start`, where it can be assembled.
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
