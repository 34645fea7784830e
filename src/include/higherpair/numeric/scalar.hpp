#pragma once

#include <limits>

namespace higherpair {

/// What the kernels of geometry and linkage require of their scalar type T: + - * /, comparisons that give a
/// mask, and, found by argument-dependent lookup, sqrt, abs, copysign, max and select(mask, if_true,
/// if_false). This select serves types whose comparisons give a bool; a pack of several configurations brings
/// its own.
template <class T>
[[nodiscard]] constexpr T select(bool condition, T if_true, T if_false) {
  return condition ? if_true : if_false;
}

/// Distance from 1 to the next number of T, as a double. Specialise it for packs of anything but double.
template <class T>
inline constexpr double kEpsilonOf = std::numeric_limits<double>::epsilon();
template <>
inline constexpr double kEpsilonOf<float> = std::numeric_limits<float>::epsilon();
template <>
inline constexpr double kEpsilonOf<long double> =
    static_cast<double>(std::numeric_limits<long double>::epsilon());

}  // namespace higherpair
