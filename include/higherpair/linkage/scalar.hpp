#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace higherpair {

/// What the kernels of this room ask of their scalar type T: + - * /, comparisons that give a mask, and,
/// found by argument-dependent lookup, sqrt, abs, copysign, max and select(mask, if_true, if_false). The
/// floating types have all of these; a pack of several configurations brings its own.
template <class T>
requires std::is_floating_point_v<T>
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
