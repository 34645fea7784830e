#pragma once

#include <array>

namespace higherpair {

/// A driver's coordinate and its rates.
struct DriverMotion {
  double position = 0;  ///< [rad or m]
  double velocity = 0;
  double acceleration = 0;

  friend bool operator==(const DriverMotion&, const DriverMotion&) = default;
};

/// The third to the sixth time derivative of a driver's coordinate [rad/s³ or m/s³, …].
using HigherRates = std::array<double, 4>;

}  // namespace higherpair
