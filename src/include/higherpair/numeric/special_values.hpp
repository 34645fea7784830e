#pragma once

#include <limits>

namespace higherpair {

inline constexpr double kInf = std::numeric_limits<double>::infinity();

/// A value that is not defined where it is asked for.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Without the sign of a zero, for people.
[[nodiscard]] inline double plus_zero(double value) {
  return value == 0 ? 0.0 : value;
}

}  // namespace higherpair
