#pragma once

#include <cmath>
#include <optional>

namespace higherpair::testing {

/// Central differences of half-widths h, h/2 and h/4, extrapolated twice. `error` is the difference of the
/// two first extrapolations; it exceeds the true error wherever the series in h² converges.
struct Difference {
  double value = INFINITY;
  double error = INFINITY;
};

/// The derivative of `at(offset)`, which returns std::optional<double>; infinite where that is empty.
template <class At>
Difference difference(double h, const At& at) {
  double slopes[3];
  for (double& slope : slopes) {
    const std::optional<double> ahead = at(h);
    const std::optional<double> behind = at(-h);
    if (!ahead || !behind) {
      return {};
    }
    slope = (*ahead - *behind) / (2 * h);
    h /= 2;
  }
  const double coarse = (4 * slopes[1] - slopes[0]) / 3;
  const double fine = (4 * slopes[2] - slopes[1]) / 3;
  return {(16 * fine - coarse) / 15, std::abs(fine - coarse)};
}

}  // namespace higherpair::testing
