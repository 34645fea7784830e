#pragma once

#include <limits>

namespace higherpair {

inline constexpr double kInf = std::numeric_limits<double>::infinity();

/// Stands for a value that is not defined where it is asked for.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// The value with -0 turned into 0, for output.
[[nodiscard]] inline double plus_zero(double value) {
  return value == 0 ? 0.0 : value;
}

}  // namespace higherpair
